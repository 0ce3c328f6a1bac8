// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the amplitude's factor taken for the energy's
// Why:     The amplitude grows by the root of 1 + (omega dt)^2; the energy goes with its square.
// Read:    1.6.1
// Fails:   energy-factor

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.6.1: position and velocity both move with what was known at the beginning of the step.
struct ExplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static constexpr int order = 1;

    /// x in m, v in m/s, a in m/s^2 (as it is at the beginning of the step), dt in s: change x and v to what they are
    /// at its end.
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        x += v * dt;
        v += a * dt;
    }
};

/// By what factor the energy of a mass on a spring, (v^2 + omega^2 x^2) / 2 for each kilogram, is larger after one step of
/// explicit Euler. It is the same factor in every step, whatever x and v are.
inline double energy_factor(Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    const double angle = omega * dt;
    return std::sqrt(1 + angle * angle);
}

} // namespace exercise
