// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

namespace exercise {

using Speed = Quantity<unit::Velocity>;
using Velocity3 = VectorQuantity<unit::Velocity, 3>;
using NewtonSeconds = Quantity<unit::Impulse>;
using PerMass = Quantity<unit::InverseMass>;
using Direction = Vector<double, 3>; // a plain vector, without a unit

struct Body {
    Velocity3 velocity;
    PerMass inverse_mass; ///< 1/m, zero for what is immovable
};

/// v_N: how fast two bodies part, along the normal; negative while they approach.
/// \param normal N, of length 1, from the second to the first
inline Speed parting_speed(const Velocity3& first, const Velocity3& second, const Direction& normal) {
    return todo(1);
}

/// e of a meeting, of the two bodies' own; 0 unless they approach faster than the threshold.
/// \param parting v_N
inline double bounce(double first, double second, Speed parting, Speed threshold) {
    return todo(2);
}

/// 2.2.1: J, along N on the first body, and the other way on the second; nothing where they part.
/// \param parting v_N
/// \param e       the coefficient of restitution
inline NewtonSeconds impulse(Speed parting, PerMass first, PerMass second, double e) {
    return todo(3);
}

/// Changes both velocities by an impulse along the normal.
inline void apply(Body& first, Body& second, const Direction& normal, NewtonSeconds impulse) {
    todo(4);
}

} // namespace exercise
