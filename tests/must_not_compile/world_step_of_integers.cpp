// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// A quantity of integers.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
#ifdef ANSATZ_MISTAKE
    world.step(Quantity<unit::Time, int>::from_value(1));
#else
    world.step(Quantity<unit::Time, float>::from_value(1.0f));
#endif
}
