// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

namespace exercise {

/// A mass on a spring, with a damper beside it.
struct OnSpring {
    ansatz::Quantity<ansatz::unit::Mass> mass;
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    ansatz::Quantity<ansatz::unit::Damping> damping;
};
/// How it moves: the displacement from the rest, and the velocity.
struct State {
    ansatz::Quantity<ansatz::unit::Length> x;
    ansatz::Quantity<ansatz::unit::Velocity> v;
};

/// The library's implicit Euler solves for any force whose derivatives are known. Here they are numbers.
inline State after_a_step(const OnSpring& body, const State& now, ansatz::Quantity<ansatz::unit::Time> h) {
    using S = ansatz::Space<double, 2>;
    struct Laws {
        S::ScalarOf<ansatz::unit::FrequencySquared> k;
        S::ScalarOf<ansatz::unit::Frequency> c;
        S::Acceleration operator()(const S::Position& x, const S::Velocity& v, double) const { return -k * x - c * v; }
        ansatz::Jacobian<S> jacobian(const S::Position&, const S::Velocity&, double) const {
            const auto one = S::MatrixOf<ansatz::unit::Dimensionless>::from_value(Eigen::Matrix2d::Identity());
            return {-k * one, -c * one};
        }
    };
    S::Position place = ansatz::metres(now.x.value(), 0);
    S::Velocity velocity = ansatz::metres_per_second(now.v.value(), 0);
    ansatz::ImplicitEuler::solve(place, velocity, Laws{body.stiffness / body.mass, body.damping / body.mass}, h);
    return {ansatz::x(place), ansatz::x(velocity)};
}

/// Nothing of this name is in the library; it is measured on the steps.
inline double energy_factor(const OnSpring& body, ansatz::Quantity<ansatz::unit::Time> h, int steps) {
    const auto energy = [&](const State& s) { return body.mass * s.v * s.v + body.stiffness * s.x * s.x; };
    const State start{0.3 * ansatz::metre, -2.0 * ansatz::metre_per_second};
    const OnSpring undamped{body.mass, body.stiffness, 0.0 * ansatz::newton_second_per_metre};
    State state = start;
    for (int i = 0; i < steps; ++i) state = after_a_step(undamped, state, h);
    return energy(state) / energy(start);
}

} // namespace exercise
