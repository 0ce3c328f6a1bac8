// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;

namespace exercise {

/// 3.5: the step beyond which semi-implicit Euler explodes, for a mass on a damped spring. The mass is positive;
/// stiffness and damping are not negative, and not both zero.
inline Quantity<unit::Time> largest_step(Quantity<unit::Mass> mass, Quantity<unit::Stiffness> stiffness,
                                         Quantity<unit::Damping> damping) {
    // task 1: return todo(1);
    // The root of k h^2 + 2 c h = 4 m, in the form that does not cancel when c is large.
    return 4.0 * mass / (damping + sqrt(damping * damping + 4.0 * stiffness * mass));
    // end of task 1
}

/// How many equal substeps of a frame are each no longer than the limit; 1 at least. The frame is not negative, and the
/// limit is positive or infinite.
inline int parts_of(Quantity<unit::Time> frame, Quantity<unit::Time> limit) {
    // task 2: return todo(2);
    return std::max(1, int(std::ceil(frame / limit)));
    // end of task 2
}

} // namespace exercise
