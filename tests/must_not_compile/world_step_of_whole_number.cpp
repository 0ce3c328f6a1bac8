// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// 1 / 60 in whole numbers is 0: the world would stand still.

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
#ifdef ANSATZ_MISTAKE
    world.step(1 / 60 * second);
#else
    world.step(1.0 / 60 * second);
#endif
}
