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
    return todo(1);
}

/// How fast the next step may be, so that steps that are each slower by acceleration * dt end at the distance.
inline Quantity<unit::Velocity> arrival_speed(Quantity<unit::Length> distance,
                                              Quantity<unit::Acceleration> acceleration, Quantity<unit::Time> dt) {
    return todo(2);
}

} // namespace exercise
