// expect: Ansatz units: a bare number where a quantity belongs; multiply it with its unit
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// The air without its density, the ball without its area.

#include <ansatz/motion/quadratic_drag.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    static_cast<void>(QuadraticDrag::of(1.2 * kilogram_per_cubic_metre, 0.47, 0.04));
#else
    static_cast<void>(QuadraticDrag::of(1.2 * kilogram_per_cubic_metre, 0.47, 0.04 * square_metre));
#endif
}
