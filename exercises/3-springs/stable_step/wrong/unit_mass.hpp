// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the mass forgotten, as if it were 1 kg
// Why:     A formula for a = -k x - c v has no mass in it. A heavy body is slower, and takes a longer step.
// Read:    3.5
// Fails:   damped, undamped, damper, ten-times

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    const auto one = 1.0 * kilogram;
    return 4.0 * one / (damping + sqrt(damping * damping + 4.0 * stiffness * one));
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
