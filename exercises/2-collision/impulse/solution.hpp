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
    // task 1: return todo(1);
    return dot(first - second, normal);
    // end of task 1
}

/// e of a meeting, of the two bodies' own; 0 unless they approach faster than the threshold.
/// \param parting v_N
inline double bounce(double first, double second, Speed parting, Speed threshold) {
    // task 2: return todo(2);
    return -parting > threshold ? std::max(first, second) : 0.0;
    // end of task 2
}

/// 2.2.1: J, along N on the first body, and the other way on the second; nothing where they part.
/// \param parting v_N
/// \param e       the coefficient of restitution
inline NewtonSeconds impulse(Speed parting, PerMass first, PerMass second, double e) {
    // task 3: return todo(3);
    if (parting >= 0.0 * metre_per_second) return 0.0 * newton_second;
    return -(1 + e) * parting / (first + second);
    // end of task 3
}

/// Changes both velocities by an impulse along the normal.
inline void apply(Body& first, Body& second, const Direction& normal, NewtonSeconds impulse) {
    // task 4: todo(4);
    first.velocity += first.inverse_mass * impulse * normal;
    second.velocity -= second.inverse_mass * impulse * normal;
    // end of task 4
}

} // namespace exercise
