// expect(g++): Ansatz_units_this_adds_or_compares_quantities_of_different_units
// expect(clang++): overload resolution selected deleted operator
// expect note: Ansatz_units_this_adds_or_compares_quantities_of_different_units
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A length is neither more nor less than a time.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    return 1.0 * metre < 1.0 * second;
#else
    return 1.0 * metre < 0.5 * metre;
#endif
}
