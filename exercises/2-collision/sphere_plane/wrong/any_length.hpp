// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: a normal of the length that was given
// Why:     Every height is a dot product with N: with an N of length 12 a ball at 1 m is at 12 m.
// Read:    2.1.2.2
// Fails:   length-one, on-it

#include <ansatz/world.hpp>

#include <optional>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Place = VectorQuantity<unit::Length, 3>;
using Direction = Vector<double, 3>; // a plain vector, without a unit

/// A ball.
struct Ball {
    Place centre;
    Length radius;
};

/// All places x with N . x + d <= 0: what lies on a plane, and below it.
struct HalfSpace {
    Direction normal; ///< N, of length 1, out of what is solid
    Length d;         ///< the constant of the plane
};

/// How a ball intersects a plane.
struct Contact {
    Place point;      ///< halfway between the lowest point of the ball and the surface
    Direction normal; ///< of length 1, from the plane to the ball
    Length depth;     ///< how far the ball must be moved along the normal until it only touches
};

/// The plane through a point that faces in a direction, which may have any length but zero.
inline HalfSpace half_space(const Direction& facing, const Place& point) {
    return {facing, -dot(point, facing)};
}

/// 2.1.2.2: how high a place is above a plane; negative below it.
inline Length height(const Place& place, const HalfSpace& plane) {
    return dot(place, plane.normal) + plane.d;
}

/// How a ball intersects a plane, or nothing, std::nullopt, where it does not.
inline std::optional<Contact> contact(const Ball& ball, const HalfSpace& plane) {
    const Length above = dot(ball.centre, plane.normal) + plane.d;
    if (above >= ball.radius) return std::nullopt;
    return Contact{ball.centre - 0.5 * (ball.radius + above) * plane.normal, plane.normal, ball.radius - above};
}

} // namespace exercise
