// expect: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// 1 / 2 in whole numbers is 0: no time to wait.

#include <ansatz/states.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    static_cast<void>(states::after(1 / 2 * second));
#else
    static_cast<void>(states::after(1.0 / 2 * second));
#endif
}
