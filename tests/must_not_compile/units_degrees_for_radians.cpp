// expect: degree
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Degrees only by explicit conversion: there is no unit that 30 could be multiplied with.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = sin(30.0 * degree);
    static_cast<void>(q);
#else
    auto q = sin(degrees(30.0));
    static_cast<void>(q);
#endif
}
