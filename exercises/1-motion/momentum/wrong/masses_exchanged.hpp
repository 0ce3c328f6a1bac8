// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the impulse divided by the mass of the other body
// Why:     The share of the first body in the change is m2 / (m1 + m2): the heavier the other one, the more it
//          changes. With the masses exchanged the heavy body is thrown about by the light one.
// Read:    1.4
// Fails:   momentum, elastic

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// A body in a plane: `.mass` in kg and `.velocity` in m/s.
using Body = mechanics::PointMass<double, Vector<double, 2>>;

/// 1.4: the two bodies after they met head-on.
/// \param restitution e, from 0 (they stay together) to 1 (no energy is lost)
inline std::pair<Body, Body> collide(const Body& first, const Body& second, double restitution) {
    const auto change = (1 + restitution) * (first.velocity - second.velocity);
    const auto all = first.mass + second.mass;
    return {{first.mass, first.velocity - change * (first.mass / all)},
            {second.mass, second.velocity + change * (second.mass / all)}};
}

/// The kinetic energy of both before such a collision, minus that after it; in J.
inline Quantity<unit::Energy> energy_lost(const Body& first, const Body& second, double restitution) {
    const auto reduced_mass = first.mass * second.mass / (first.mass + second.mass);
    return 0.5 * (1 - restitution * restitution) * reduced_mass * squared_norm(first.velocity - second.velocity);
}

} // namespace exercise
