// expect: Ansatz units: a bare number where a quantity belongs; multiply it with its unit
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// The slowest speed that must be right, without its unit.

#include <ansatz/motion/resolved_radius.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    static_cast<void>(resolved_radius<Space<float, 3>>(0.05, 0.01 * second));
#else
    static_cast<void>(resolved_radius<Space<float, 3>>(0.05 * metre_per_second, 0.01 * second));
#endif
}
