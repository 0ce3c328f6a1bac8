// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// 16 / 1000 in whole numbers is 0.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
    FixedStep clock{1.0 / 60 * second};
#ifdef ANSATZ_MISTAKE
    clock.advance(world, 16 / 1000 * second);
#else
    clock.advance(world, 16.0 / 1000 * second);
#endif
}
