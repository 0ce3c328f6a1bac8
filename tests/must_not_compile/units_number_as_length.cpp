// expect(g++): conversion from
// expect(clang++): no viable conversion from
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A number is no length.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    Quantity<unit::Length> x = 3.0;
    static_cast<void>(x);
#else
    Quantity<unit::Length> x = 3.0 * metre;
    static_cast<void>(x);
#endif
}
