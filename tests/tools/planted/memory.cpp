// SPDX-License-Identifier: BSL-1.0
// The faults that tests/tools/planted.sh plants, one a run, by name; a sanitizer must end each of them.
#include <climits>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace {

volatile int sink;
[[gnu::noinline]] int* of_the_stack() {
    int local[4] = {1, 2, 3, 4};
    int* volatile there = local;
    return there;
}
[[gnu::noinline]] void lose() {
    int* volatile lost = new int[16];
    lost[0] = 1;
    lost = nullptr;
}

} // namespace

int main(int count, char** names) {
    const char* fault = count > 1 ? names[1] : "none";
    const auto is = [&](const char* name) { return std::strcmp(fault, name) == 0; };
    const std::size_t size = 8 + std::size_t(count - 2); // known when it runs, not before
    std::unique_ptr<int[]> numbers(new int[size]());
    if (is("off_by_one"))
        for (std::size_t i = 0; i <= size; ++i) sink = numbers[i];
    if (is("leak")) lose();
    if (is("freed")) {
        int* const kept = numbers.get();
        numbers.reset();
        sink = kept[1];
    }
    if (is("returned")) sink = of_the_stack()[1];
    if (is("overflow")) sink = INT_MAX - 1 + count;
    if (is("beyond_size")) {
        std::vector<int> some;
        some.reserve(size);
        sink = some[size - 1];
    }
    return 0;
}
