// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <optional>

using namespace ansatz;

namespace exercise {

using Mass = Quantity<unit::Mass>;
using Length = Quantity<unit::Length>;
using Velocity = Quantity<unit::Velocity>;
using Acceleration = Quantity<unit::Acceleration>;
using Force = Quantity<unit::Force>;
using Stiffness = Quantity<unit::Stiffness>;
using Damping = Quantity<unit::Damping>;

/// 3.4: with what a rope pulls, never less than nothing. `lengthens` is how fast its length grows, negative where it
/// shortens; the damping is along the rope.
inline Force pull(Length length, Length rest_length, Velocity lengthens, Stiffness stiffness, Damping damping) {
    // task 1: return todo(1);
    const Force none = 0.0 * newton;
    if (length <= rest_length) return none;
    return max(none, Force(stiffness * (length - rest_length) + damping * lengthens));
    // end of task 1
}

/// The most with which a rope without damping pulls that catches a load: it becomes taut when the load falls with this
/// speed, and g goes on pulling while it stretches.
inline Force peak_pull(Mass mass, Acceleration g, Velocity speed, Stiffness stiffness) {
    // task 2: return todo(2);
    const Force weight = mass * g;
    return weight + sqrt(weight * weight + stiffness * mass * speed * speed);
    // end of task 2
}

/// From how high above the place where its rope becomes taut a load may fall, so that the rope pulls with no more than
/// `strength`. Nothing, std::nullopt, where even a load that is let go there would break it. The rope is a row of
/// metres: `per_strain` is K, the force that would stretch a rope of any length to twice its length.
inline std::optional<Length> highest_fall(Mass mass, Acceleration g, Length rest_length, Force per_strain,
                                          Force strength) {
    // task 3: return todo(3);
    const Force weight = mass * g;
    if (strength < 2.0 * weight) return std::nullopt;
    return rest_length * strength * (strength - 2.0 * weight) / (2.0 * weight * per_strain);
    // end of task 3
}

} // namespace exercise
