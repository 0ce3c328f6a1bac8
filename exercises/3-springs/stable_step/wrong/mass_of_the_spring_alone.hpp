// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the mass left out of the damping
// Why:     c is divided by the mass just as k is. Here the spring knows the mass and the damper takes it for 1 kg.
// Read:    3, 3.5
// Fails:   damped, damper, ten-times

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    const auto omega_squared = stiffness / mass;
    const auto gamma = damping / (1.0 * kilogram);
    return 4.0 / (gamma + sqrt(gamma * gamma + 4.0 * omega_squared));
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
