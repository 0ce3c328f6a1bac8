// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// 1 / 60 in whole numbers is 0.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    FixedStep clock{1 / 60 * second};
#else
    FixedStep clock{1.0 / 60 * second};
#endif
}
