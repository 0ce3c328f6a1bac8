// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// A body in a plane: `.mass` in kg and `.velocity` in m/s.
using Body = mechanics::PointMass<double, Vector<double, 2>>;

/// 1.4: the two bodies after they met head-on.
/// \param restitution e, from 0 (they stay together) to 1 (no energy is lost)
inline std::pair<Body, Body> collide(const Body& first, const Body& second, double restitution) {
    return todo(1);
}

/// The kinetic energy of both before such a collision, minus that after it; in J.
inline Quantity<unit::Energy> energy_lost(const Body& first, const Body& second, double restitution) {
    return todo(2);
}

} // namespace exercise
