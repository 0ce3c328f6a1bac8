// expect(g++): Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit
// expect(clang++): overload resolution selected deleted operator
// expect note: Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A number and a length have no sum.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = 1.0 * metre + 2.0;
    static_cast<void>(q);
#else
    auto q = 1.0 * metre + 2.0 * metre;
    static_cast<void>(q);
#endif
}
