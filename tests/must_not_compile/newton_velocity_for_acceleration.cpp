// expect: mechanics::force takes a mass and an acceleration
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// F = m v is no force.

#include <ansatz/motion/newton.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    mechanics::force(2.0 * kilogram, 3.0 * metre_per_second);
#else
    mechanics::force(2.0 * kilogram, 3.0 * metre_per_second_squared);
#endif
}
