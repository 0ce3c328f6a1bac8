// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/walking/steering.hpp>

using namespace ansatz;

namespace exercise {

using Velocity = VectorQuantity<unit::Velocity, 2>;

inline Velocity steered(const Velocity& velocity, const Velocity& wanted, Quantity<unit::Acceleration> acceleration,
                        Quantity<unit::Time> dt) {
    return paths::steered(velocity, wanted, acceleration, dt);
}
inline Quantity<unit::Velocity> arrival_speed(Quantity<unit::Length> distance,
                                              Quantity<unit::Acceleration> acceleration, Quantity<unit::Time> dt) {
    return paths::arrival_speed(distance, acceleration, dt);
}

} // namespace exercise
