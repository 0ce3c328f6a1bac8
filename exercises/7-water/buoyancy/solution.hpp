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
    // task 1: return todo(1);
    const auto d = max(0.0 * metre, min(depth, 2.0 * radius));
    return std::numbers::pi * d * d * (3.0 * radius - d) / 3.0;
    // end of task 1
}

/// 7.4: how a body is accelerated of which `volume` is under water of `density`, in m/s^2, upwards positive. `g` is
/// positive.
inline Quantity<unit::Acceleration> acceleration(Quantity<unit::Mass> mass, Quantity<unit::Volume> volume,
                                                 Quantity<unit::Density> density, Quantity<unit::Acceleration> g) {
    // task 2: return todo(2);
    return density * g * volume / mass - g;
    // end of task 2
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
    // task 3: return todo(3);
    if (depth > spring.breaks_at) spring.broken = true;
    if (spring.broken || depth < 0.0 * metre) return 0.0 * newton;
    return spring.stiffness * depth;
    // end of task 3
}

/// 7.4.1: how much of the water that spring presses up with a body that is so deep, in m^3. What the spring carries,
/// the water carries; once it is broken, the water is free.
inline Quantity<unit::Volume> pressed_up(Spring& spring, Quantity<unit::Length> depth, Quantity<unit::Density> density,
                                         Quantity<unit::Acceleration> g) {
    // task 4: return todo(4);
    return pull(spring, depth) / (density * g);
    // end of task 4
}

/// 7.4: how a body is accelerated by the notes' simplest way, in m/s^2, upwards positive: under the surface, where the
/// depth is positive, by a fixed `lift` against gravity, and above it by gravity alone. `lift` and `g` are positive.
inline Quantity<unit::Acceleration> fixed_acceleration(Quantity<unit::Length> depth, Quantity<unit::Acceleration> lift,
                                                       Quantity<unit::Acceleration> g) {
    // task 5: return todo(5);
    return depth > 0.0 * metre ? lift - g : -g;
    // end of task 5
}

/// 7.4: how deep a body comes that meets the surface with a downward `speed` and is lifted like that, in m; infinite
/// where it does not turn round.
inline Quantity<unit::Length> deepest(Quantity<unit::Velocity> speed, Quantity<unit::Acceleration> lift,
                                      Quantity<unit::Acceleration> g) {
    // task 6: return todo(6);
    if (!(lift > g)) return std::numeric_limits<double>::infinity() * metre;
    return 0.5 * speed * speed / (lift - g);
    // end of task 6
}

} // namespace exercise
