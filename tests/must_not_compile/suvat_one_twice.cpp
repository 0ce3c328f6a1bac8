// expect: suvat::solve was given one quantity twice
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// The same quantity twice.

#include <ansatz/motion/suvat.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    suvat::solve(suvat::time(5.0 * second), suvat::time(5.0 * second), suvat::displacement(1.0 * metre));
#else
    suvat::solve(suvat::time(5.0 * second), suvat::initial_velocity(5.0 * metre_per_second),
                 suvat::displacement(1.0 * metre));
#endif
}
