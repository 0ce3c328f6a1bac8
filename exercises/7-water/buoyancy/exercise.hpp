// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <limits>
#include <numbers>

using namespace ansatz;

namespace exercise {

/// 7.4: how much of a ball is under water, in m^3. `depth` is how far its lowest point is under the surface: negative
/// where it hangs above it, more than its diameter where it is under it.
inline Quantity<unit::Volume> submerged(Quantity<unit::Length> radius, Quantity<unit::Length> depth) {
    return todo(1);
}

/// 7.4: how a body is accelerated of which `volume` is under water of `density`, in m/s^2, upwards positive. `g` is
/// positive.
inline Quantity<unit::Acceleration> acceleration(Quantity<unit::Mass> mass, Quantity<unit::Volume> volume,
                                                 Quantity<unit::Density> density, Quantity<unit::Acceleration> g) {
    return todo(2);
}

/// A spring between a body and the surface above it.
struct Spring {
    Quantity<unit::Stiffness> stiffness;
    Quantity<unit::Length> breaks_at; ///< a depth
    bool broken = false;
};

/// 7.4: with what the spring pulls a body upwards that is `depth` under the surface, in N; breaks it where that is too
/// deep. A broken one never pulls again. Above the surface, where the depth is negative, it is slack.
inline Quantity<unit::Force> pull(Spring& spring, Quantity<unit::Length> depth) {
    return todo(3);
}

/// 7.4.1: how much of the water that spring presses up with a body that is so deep, in m^3. What the spring carries,
/// the water carries; once it is broken, the water is free.
inline Quantity<unit::Volume> pressed_up(Spring& spring, Quantity<unit::Length> depth, Quantity<unit::Density> density,
                                         Quantity<unit::Acceleration> g) {
    return todo(4);
}

/// 7.4: how a body is accelerated by the notes' simplest way, in m/s^2, upwards positive: under the surface, where the
/// depth is positive, by a fixed `lift` against gravity, and above it by gravity alone. `lift` and `g` are positive.
inline Quantity<unit::Acceleration> fixed_acceleration(Quantity<unit::Length> depth, Quantity<unit::Acceleration> lift,
                                                       Quantity<unit::Acceleration> g) {
    return todo(5);
}

/// 7.4: how deep a body comes that meets the surface with a downward `speed` and is lifted like that, in m; infinite
/// where it does not turn round.
inline Quantity<unit::Length> deepest(Quantity<unit::Velocity> speed, Quantity<unit::Acceleration> lift,
                                      Quantity<unit::Acceleration> g) {
    return todo(6);
}

} // namespace exercise
