// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Speed = Quantity<unit::Velocity>;
using Newtons = Quantity<unit::Force>;
using Acceleration3 = VectorQuantity<unit::Acceleration, 3>;
using PerMass = Quantity<unit::InverseMass>; // 1/m, zero for what is immovable
using Direction = Vector<double, 3>;         // a plain vector, without a unit

/// 2.2.2: how hard two bodies press each other; never less than nothing.
/// \param depth     p, greater than zero where they are in each other
/// \param parting   v_N, how fast they separate; negative while they go deeper
/// \param stiffness k
/// \param damping   c
inline Newtons pressing(Length depth, Speed parting, Quantity<unit::Stiffness> stiffness,
                        Quantity<unit::Damping> damping) {
    return todo(1);
}

/// What that does to the first body and to the second.
/// \param normal N, of length 1, from the second to the first
inline std::pair<Acceleration3, Acceleration3> accelerations(const Direction& normal, Newtons pressing, PerMass first,
                                                             PerMass second) {
    return todo(2);
}

/// The step beyond which semi-implicit Euler explodes, for a contact without damping.
inline Quantity<unit::Time> largest_step(Quantity<unit::Stiffness> stiffness, PerMass first, PerMass second) {
    return todo(3);
}

} // namespace exercise
