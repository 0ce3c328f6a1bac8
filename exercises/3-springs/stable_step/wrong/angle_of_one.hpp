// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: half of the limit, omega h = 1 for a spring without damping
// Why:     At omega h = 1 sweeps for implicit Euler stop converging. This method may go twice as far.
// Read:    1.6.2, 1.6.3, 3.5
// Fails:   damped, undamped, damper

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    return 2.0 * mass / (damping + sqrt(damping * damping + 4.0 * stiffness * mass));
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
