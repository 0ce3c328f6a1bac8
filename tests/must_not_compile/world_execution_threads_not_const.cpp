// expect: an execution whose number of threads the world cannot ask for; write `int threads() const`, or leave it out
// SPDX-License-Identifier: BSL-1.0
// An Execution that changes itself when it is asked how many threads it has.

#include <ansatz/world.hpp>

#include <cstddef>

using namespace ansatz;

struct Mine {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(0, count); }
#ifdef ANSATZ_MISTAKE
    int threads() { return 2; }
#else
    int threads() const { return 2; }
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Mine{}};
    world.step(0.01 * second);
}
