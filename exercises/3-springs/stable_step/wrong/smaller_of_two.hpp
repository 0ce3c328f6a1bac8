// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the smaller one of two limits, that of the spring and that of the damper
// Why:     Each is right where the other is not there. Together they push in the same direction, so that the limit of
//          both is below either.
// Read:    3.5
// Fails:   damped, shorter

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    const auto spring = 2.0 * sqrt(mass / stiffness), damper = 2.0 * mass / damping;
    return min(spring, damper);
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
