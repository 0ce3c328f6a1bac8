// expect: World has more than one policy that runs its loops; keep one Execution, or none
// SPDX-License-Identifier: BSL-1.0
// Two executions.

#include <ansatz/world.hpp>

using namespace ansatz;

struct InOnePart {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(0, count); }
};
struct InTwo {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        loop(0, count / 2);
        loop(count / 2, count);
    }
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, InOnePart{}, InTwo{}};
#else
    World world{SemiImplicitEuler{}, InTwo{}};
#endif
    world.step(0.1 * second);
}
