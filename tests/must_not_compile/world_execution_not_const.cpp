// expect: an execution whose execute the world cannot call; write `void execute(std::size_t count, std::size_t
// SPDX-License-Identifier: BSL-1.0
// An execution that would change itself.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Counting {
    using role = roles::Execution;
#ifdef ANSATZ_MISTAKE
    int calls = 0;
    void execute(std::size_t count, std::size_t, const auto& loop) {
        ++calls;
        loop(0, count);
    }
#else
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(0, count); }
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Counting{}};
    world.step(0.1 * second);
}
