// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: e applied to each velocity by itself
// Why:     -e u is right for a ball that meets a wall. Here both move, and e speaks of their relative velocity alone.
// Read:    1.4, 2.2.1
// Fails:   momentum, train

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// A body in a plane: `.mass` in kg and `.velocity` in m/s.
using Body = mechanics::PointMass<double, Vector<double, 2>>;

/// 1.4: the two bodies after they met head-on.
/// \param restitution e, from 0 (they stay together) to 1 (no energy is lost)
inline std::pair<Body, Body> collide(const Body& first, const Body& second, double restitution) {
    return {{first.mass, -restitution * first.velocity}, {second.mass, -restitution * second.velocity}};
}

/// The kinetic energy of both before such a collision, minus that after it; in J.
inline Quantity<unit::Energy> energy_lost(const Body& first, const Body& second, double restitution) {
    const auto reduced_mass = first.mass * second.mass / (first.mass + second.mass);
    return 0.5 * (1 - restitution * restitution) * reduced_mass * squared_norm(first.velocity - second.velocity);
}

} // namespace exercise
