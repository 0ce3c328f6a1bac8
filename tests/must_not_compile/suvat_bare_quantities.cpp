// expect: suvat::solve takes named quantities
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// Which of two velocities is meant?

#include <ansatz/motion/suvat.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    const auto motion = suvat::solve(5.0 * metre_per_second, 2.0 * metre_per_second, 1.0 * second).front();
#else
    const auto motion = suvat::solve(suvat::initial_velocity(5.0 * metre_per_second),
                                     suvat::final_velocity(2.0 * metre_per_second), suvat::time(1.0 * second))
                            .front();
#endif
    static_cast<void>(motion);
}
