// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the force in the middle of the step
// Why:     With the mean of the old and the new state it is the trapezoidal rule. It is more accurate and takes no
//          energy, but it does not calm a stiff spring: that one turns round in every step.
// Read:    1.6.2
// Fails:   equation, place, sixty, damper, order

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

namespace exercise {

/// A mass on a spring, with a damper beside it.
struct OnSpring {
    Quantity<unit::Mass> mass;           ///< m, kg
    Quantity<unit::Stiffness> stiffness; ///< k, N/m
    Quantity<unit::Damping> damping;     ///< c, N s/m
};
/// How it moves: the displacement from the rest, and the velocity.
struct State {
    Quantity<unit::Length> x;   ///< m
    Quantity<unit::Velocity> v; ///< m/s
};

/// 3.5: where implicit Euler is after a step of h, under the force -kx - cv at the end of the step.
inline State after_a_step(const OnSpring& body, const State& now, Quantity<unit::Time> h) {
    const double spring = h * h * body.stiffness / body.mass, damper = h * body.damping / body.mass;
    const auto pull = h * (body.stiffness * now.x + 0.5 * body.damping * now.v) / body.mass;
    const auto v = (now.v - pull - 0.25 * spring * now.v) / (1 + 0.5 * damper + 0.25 * spring);
    return {now.x + 0.5 * h * (now.v + v), v};
}

/// What part of its energy is left to a body without damping, after so many steps of h. It does not matter how it
/// moves.
inline double energy_factor(const OnSpring& body, Quantity<unit::Time> h, int steps) {
    return std::pow(1 + h * h * body.stiffness / body.mass, -steps);
}

} // namespace exercise
