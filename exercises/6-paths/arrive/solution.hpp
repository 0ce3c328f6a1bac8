// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/units.hpp>

#include <cmath>

using namespace ansatz;

namespace exercise {

using Velocity = VectorQuantity<unit::Velocity, 2>;

/// 6.3.8: the velocity of the next step.
inline Velocity steered(const Velocity& velocity, const Velocity& wanted, Quantity<unit::Acceleration> acceleration,
                        Quantity<unit::Time> dt) {
    // task 1: return todo(1);
    const Velocity change = wanted - velocity;
    const Quantity<unit::Velocity> most = acceleration * dt;
    if (norm(change) <= most) return wanted;
    return velocity + double(most / norm(change)) * change;
    // end of task 1
}

/// How fast the next step may be, so that steps that are each slower by acceleration * dt end at the distance.
inline Quantity<unit::Velocity> arrival_speed(Quantity<unit::Length> distance,
                                              Quantity<unit::Acceleration> acceleration, Quantity<unit::Time> dt) {
    // task 2: return todo(2);
    const double steps = distance / (acceleration * dt * dt);
    const double m = std::floor((std::sqrt(1 + 8 * steps) - 1) / 2);
    return 0.5 * m * acceleration * dt + distance / ((m + 1) * dt);
    // end of task 2
}

} // namespace exercise
