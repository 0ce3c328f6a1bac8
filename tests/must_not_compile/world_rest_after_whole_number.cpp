// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// A parameter that is a time: 1 / 2 in whole numbers is 0.

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Rest{.time = 1 / 2 * second}};
#else
    World world{SemiImplicitEuler{}, Rest{.time = 1.0 / 2 * second}};
#endif
}
