// expect(g++): Ansatz_units_this_adds_or_compares_quantities_of_different_units
// expect(clang++): overload resolution selected deleted operator
// expect note: Ansatz_units_this_adds_or_compares_quantities_of_different_units
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A length and a time have no sum.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = 1.0 * metre + 1.0 * second;
    static_cast<void>(q);
#else
    auto q = 1.0 * metre + 2.0 * metre;
    static_cast<void>(q);
#endif
}
