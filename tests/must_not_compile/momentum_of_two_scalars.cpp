// expect: no matching function for call to
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Two bodies of different scalars.

#include <ansatz/motion/momentum.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    mechanics::collide(mechanics::PointMass{2.0f * kilogram, 3.0f * metre_per_second},
                       mechanics::PointMass{2.0 * kilogram, 3.0 * metre_per_second}, 0.5);
#else
    mechanics::collide(mechanics::PointMass{2.0 * kilogram, 3.0 * metre_per_second},
                       mechanics::PointMass{2.0 * kilogram, 3.0 * metre_per_second}, 0.5);
#endif
}
