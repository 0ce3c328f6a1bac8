// expect(g++): Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross
// expect(clang++): overload resolution selected deleted operator
// expect note: Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Which product of two vectors: dot or cross?

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = metres(1, 2, 3) * metres(4, 5, 6);
    static_cast<void>(q);
#else
    auto q = dot(metres(1, 2, 3), metres(4, 5, 6));
    static_cast<void>(q);
#endif
}
