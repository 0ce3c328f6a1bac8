// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: c^2 - 4 k m under the root
// Why:     That is the root which says whether a body swings, and it is none of a positive number below the critical
//          damping. In k h^2 + 2 c h = 4 m the signs differ.
// Read:    3.1, 3.5
// Fails:   damped, undamped, shorter, ten-times

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    return 4.0 * mass / (damping + sqrt(damping * damping - 4.0 * stiffness * mass));
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
