// expect(g++): conversion from
// expect(clang++): no viable conversion from
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A velocity is no length.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    Quantity<unit::Length> x = 3.0 * metre_per_second;
    static_cast<void>(x);
#else
    Quantity<unit::Length> x = 3.0 * metre_per_second * second;
    static_cast<void>(x);
#endif
}
