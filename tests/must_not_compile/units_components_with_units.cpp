// expect: Ansatz units: a maker of vectors takes plain numbers, since its name says the unit
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Components that have their unit already: metres of metres.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
    const auto height = 10.0 * metre;
#ifdef ANSATZ_MISTAKE
    static_cast<void>(metres(0.0 * metre, height, 0.0 * metre));
#else
    static_cast<void>(vector_of(0.0 * metre, height, 0.0 * metre));
#endif
}
