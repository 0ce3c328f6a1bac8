// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the root of the school book, which divides by the stiffness
// Why:     The formula is right, and on a computer it is 0 / 0 for a damper alone. Where c is large it takes two
//          nearly equal numbers from each other. 4 m / (c + sqrt(c^2 + 4 k m)) is the same number.
// Read:    3.5, 1.5
// Fails:   damper

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    return (sqrt(damping * damping + 4.0 * stiffness * mass) - damping) / stiffness;
}

/// How many equal parts of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    return std::max(1, int(std::ceil(frame / limit)));
}

} // namespace exercise
