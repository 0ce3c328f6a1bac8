// expect: float and double are mixed in one expression
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Two scalars in one sum.

#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    auto q = 1.0f * metre + 2.0 * metre;
    static_cast<void>(q);
#else
    auto q = scalar_cast<double>(1.0f * metre) + 2.0 * metre;
    static_cast<void>(q);
#endif
}
