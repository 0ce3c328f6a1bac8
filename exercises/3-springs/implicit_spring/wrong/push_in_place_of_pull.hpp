// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the sign of the spring lost when the equation was solved
// Why:     On the side of what is known stands m v - h k x. Above the fraction the spring pulls back; below it both
//          terms have a plus.
// Read:    3
// Fails:   equation, sixty, never-grows, order

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
    const auto v = (now.v + h * body.stiffness * now.x / body.mass) / (1 + damper + spring);
    return {now.x + h * v, v};
}

/// What part of its energy is left to a body without damping, after so many steps of h. It does not matter how it
/// moves.
inline double energy_factor(const OnSpring& body, Quantity<unit::Time> h, int steps) {
    return std::pow(1 + h * h * body.stiffness / body.mass, -steps);
}

} // namespace exercise
