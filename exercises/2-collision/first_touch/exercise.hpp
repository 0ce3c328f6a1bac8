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
    return todo(1);
}

/// When two balls first touch: the share of the step that is over by then, from 0 to 1. 0 for two that intersect
/// already and come nearer; nothing, std::nullopt, for two that do not touch in this step, or that part.
inline std::optional<double> first_touch(const Ball& a, const Ball& b) {
    return todo(2);
}

/// How two balls touch that do so when this share of the step is over.
inline Contact contact_then(const Ball& a, const Ball& b, double share) {
    return todo(3);
}

} // namespace exercise
