// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.6.3: the velocity first, then the position with the new velocity.
struct SemiImplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static constexpr int order = 1;

    /// x in m, v in m/s, a in m/s^2 (as it is at the beginning of the step), dt in s: change x and v to what they are
    /// at its end.
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        // task 1: todo(1);
        v += a * dt;
        x += v * dt;
        // end of task 1
    }
};

/// What semi-implicit Euler keeps exactly for a mass on a spring, a = -omega^2 x, with steps of dt: (v^2 + omega^2 x^2)
/// / 2 and a term with x v that vanishes with dt. In m^2/s^2, for each kilogram.
inline Quantity<unit::SpecificEnergy> kept_energy(Quantity<unit::Length> x, Quantity<unit::Velocity> v,
                                                  Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    // task 2: return todo(2);
    return 0.5 * (v * v + omega * omega * x * x - dt * omega * omega * x * v);
    // end of task 2
}

/// The step beyond which a spring with damping, a = -omega^2 x - c v, explodes. omega is positive, c is not negative.
inline Quantity<unit::Time> largest_step(Quantity<unit::Frequency> omega, Quantity<unit::Frequency> c) {
    // task 3: return todo(3);
    // The root of omega^2 dt^2 + 2 c dt = 4, in the form that does not cancel when c is large.
    return 4.0 / (c + sqrt(c * c + 4.0 * omega * omega));
    // end of task 3
}

} // namespace exercise
