// expect(g++): Ansatz_units_this_adds_a_vector_and_a_scalar_or_vectors_of_different_dimension
// expect(clang++): overload resolution selected deleted operator
// expect note: Ansatz_units_this_adds_a_vector_and_a_scalar_or_vectors_of_different_dimension
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Vectors of different dimension.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = metres(1, 2, 3) + metres(4, 5);
    static_cast<void>(q);
#else
    auto q = metres(1, 2, 3) + metres(4, 5, 0);
    static_cast<void>(q);
#endif
}
