// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

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

} // namespace exercise
