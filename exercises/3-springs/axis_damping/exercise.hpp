// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// What a spring is fixed to: a place in m, and how fast that place moves, in m/s.
struct End {
    VectorQuantity<unit::Length, 3> position;
    VectorQuantity<unit::Velocity, 3> velocity;
};
/// A spring, and the damper beside it.
struct Damped {
    Quantity<unit::Length> rest_length;  ///< m
    Quantity<unit::Stiffness> stiffness; ///< k, N/m
    Quantity<unit::Damping> damping;     ///< c, N s/m
};
using Force = VectorQuantity<unit::Force, 3>;

/// 3: how fast the distance between two ends grows; zero for ends in the same place.
inline Quantity<unit::Velocity> lengthening(const End& first, const End& second) {
    return todo(1);
}

/// The force on the first end, and the force on the second; none for ends in the same place.
inline std::pair<Force, Force> forces(const End& first, const End& second, const Damped& spring) {
    return todo(2);
}

} // namespace exercise
