// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: a depth no larger than the smaller ball
// Why:     A ball that is inside another one with all of itself is still deeper the further it is in: it must come out
//          past the surface.
// Read:    2.1.2.1
// Fails:   out-of-it

#include <ansatz/world.hpp>

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

/// 2.1.2.1: whether two balls intersect. If they only touch they do not.
inline bool intersect(const Ball& first, const Ball& second) {
    return norm(first.centre - second.centre) < first.radius + second.radius;
}

/// p, of two balls that intersect: how far they must be moved apart until they only touch.
inline Length penetration(const Ball& first, const Ball& second) {
    const Length depth = first.radius + second.radius - norm(first.centre - second.centre);
    return min(depth, 2.0 * min(first.radius, second.radius));
}

/// N, of two balls that intersect: of length 1, from the second to the first; (0, 1, 0) where their centres are the
/// same.
inline Direction unit_normal(const Ball& first, const Ball& second) {
    const Place between = first.centre - second.centre;
    const Length distance = norm(between);
    if (distance == 0.0 * metre) return Direction(0, 1, 0);
    return between / distance;
}

/// P, of two balls that intersect: halfway between the two surfaces.
/// \param normal N
/// \param depth  p
inline Place contact_point(const Ball& first, const Ball& second, const Direction& normal, Length depth) {
    return first.centre - (first.radius - 0.5 * depth) * normal;
}

} // namespace exercise
