// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <optional>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Place = VectorQuantity<unit::Length, 3>;
using Direction = Vector<double, 3>; // a plain vector, without a unit

/// A ball that moves in a straight line during a step.
struct Ball {
    Place centre; ///< where it is at the beginning of the step
    Place motion; ///< by how much it moves until the end
    Length radius;
};

/// Where two balls touch.
struct Contact {
    Place point;      ///< the one point that both have
    Direction normal; ///< of length 1, from the second ball to the first
};

/// 2.1.2.3: up to this speed a ball that flies straight at a wall is pushed out on the side that it came from, wherever
/// it was at the beginning of the step. It is seen at the ends of the steps alone.
inline Quantity<unit::Velocity> safe_speed(Length radius, Length thickness, Quantity<unit::Time> dt) {
    // task 1: return todo(1);
    return (radius + 0.5 * thickness) / dt;
    // end of task 1
}

/// When two balls first touch: the share of the step that is over by then, from 0 to 1. 0 for two that intersect
/// already and come nearer; nothing, std::nullopt, for two that do not touch in this step, or that part.
inline std::optional<double> first_touch(const Ball& a, const Ball& b) {
    // task 2: return todo(2);
    const Place between = a.centre - b.centre;
    const Place motion = a.motion - b.motion; // of a, seen from b
    const Length reach = a.radius + b.radius;
    const Length far = norm(between), length = norm(motion), none = 0.0 * metre;
    if (length == none) return std::nullopt;
    const Direction along = motion.value() / length.value();
    const Length way = -dot(between, along); // to where they are nearest
    if (way <= none) return std::nullopt;
    if (far <= reach) return 0.0;

    const Length nearest = norm(Place(between + way * along));
    if (nearest >= reach) return std::nullopt;
    const double share = (far - reach) * (far + reach) / (way + sqrt(reach * reach - nearest * nearest)) / length;
    if (share > 1) return std::nullopt;
    return share;
    // end of task 2
}

/// How two balls touch that do so when this share of the step is over.
inline Contact contact_then(const Ball& a, const Ball& b, double share) {
    // task 3: return todo(3);
    const Place at_a = a.centre + share * a.motion, at_b = b.centre + share * b.motion;
    const Place between = at_a - at_b;
    const Direction normal = between.value().normalized();
    return {at_a - a.radius * normal, normal};
    // end of task 3
}

} // namespace exercise
