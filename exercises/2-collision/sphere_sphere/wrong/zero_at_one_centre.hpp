// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: a normal of length zero where both have one centre
// Why:     Eigen's normalized() leaves a vector of length zero as it is. Along it nobody is ever moved, and the two
//          stay in each other.
// Read:    2.1.2.1
// Fails:   one-centre

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
    return first.radius + second.radius - norm(first.centre - second.centre);
}

/// N, of two balls that intersect: of length 1, from the second to the first; (0, 1, 0) where their centres are the
/// same.
inline Direction unit_normal(const Ball& first, const Ball& second) {
    return (first.centre - second.centre).value().normalized();
}

/// P, of two balls that intersect: halfway between the two surfaces.
/// \param normal N
/// \param depth  p
inline Place contact_point(const Ball& first, const Ball& second, const Direction& normal, Length depth) {
    return first.centre - (first.radius - 0.5 * depth) * normal;
}

} // namespace exercise
