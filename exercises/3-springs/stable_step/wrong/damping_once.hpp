// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: c h in place of 2 c h
// Why:     In k h^2 + 2 c h = 4 m the damper has a two: its force is not halved by the way, as that of the spring is.
// Read:    3.5
// Fails:   damped, damper

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    return 8.0 * mass / (damping + sqrt(damping * damping + 16.0 * stiffness * mass));
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
