// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the impulse with both signs exchanged
// Why:     The first body is pushed back by the second, not on. With the signs exchanged the momentum is kept, but
//          the bodies meet faster afterwards than they did before.
// Read:    1.4
// Fails:   parting, elastic

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// A body in a plane: `.mass` in kg and `.velocity` in m/s.
using Body = mechanics::PointMass<double, Vector<double, 2>>;

/// 1.4: the two bodies after they met head-on.
/// \param restitution e, from 0 (they stay together) to 1 (no energy is lost)
inline std::pair<Body, Body> collide(const Body& first, const Body& second, double restitution) {
    const auto reduced_mass = first.mass * second.mass / (first.mass + second.mass);
    const auto impulse = (1 + restitution) * reduced_mass * (first.velocity - second.velocity);
    return {{first.mass, first.velocity + impulse / first.mass},
            {second.mass, second.velocity - impulse / second.mass}};
}

/// The kinetic energy of both before such a collision, minus that after it; in J.
inline Quantity<unit::Energy> energy_lost(const Body& first, const Body& second, double restitution) {
    const auto reduced_mass = first.mass * second.mass / (first.mass + second.mass);
    return 0.5 * (1 - restitution * restitution) * reduced_mass * squared_norm(first.velocity - second.velocity);
}

} // namespace exercise
