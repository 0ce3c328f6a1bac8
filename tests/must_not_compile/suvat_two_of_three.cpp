// expect: suvat::solve takes exactly three of the five quantities
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Two are not enough.

#include <ansatz/motion/suvat.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    suvat::solve(suvat::initial_velocity(5.0 * metre_per_second), suvat::time(1.0 * second));
#else
    suvat::solve(suvat::initial_velocity(5.0 * metre_per_second), suvat::displacement(1.0 * metre),
                 suvat::time(1.0 * second));
#endif
}
