// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the damping with the sign of the other root
// Why:     Damping calms, so a longer step looks plausible. The other root of the quadratic equation is a negative
//          step; its size is not a limit of anything.
// Read:    1.6.3
// Fails:   limit, damping

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
        v += a * dt;
        x += v * dt;
    }
};

/// What semi-implicit Euler keeps exactly for a mass on a spring, a = -omega^2 x, with steps of dt: (v^2 + omega^2 x^2)
/// / 2 and a term with x v that vanishes with dt. In m^2/s^2, for each kilogram.
inline Quantity<unit::SpecificEnergy> kept_energy(Quantity<unit::Length> x, Quantity<unit::Velocity> v,
                                                  Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    return 0.5 * (v * v + omega * omega * x * x - dt * omega * omega * x * v);
}

/// The step beyond which a spring with damping, a = -omega^2 x - c v, explodes. omega is positive, c is not negative.
inline Quantity<unit::Time> largest_step(Quantity<unit::Frequency> omega, Quantity<unit::Frequency> c) {
    return (sqrt(c * c + 4.0 * omega * omega) + c) / (omega * omega);
}

} // namespace exercise
