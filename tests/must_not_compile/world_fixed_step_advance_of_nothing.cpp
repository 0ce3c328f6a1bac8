// expect: Ansatz: FixedStep::advance calls its third argument with the world, before each step
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// What is called before each step does not take the world.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
    FixedStep clock{1.0 / 60 * second};
    int steps = 0;
#ifdef ANSATZ_MISTAKE
    clock.advance(world, 0.1 * second, [&] { ++steps; });
#else
    clock.advance(world, 0.1 * second, [&](auto&) { ++steps; });
#endif
}
