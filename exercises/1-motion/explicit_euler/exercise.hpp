// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.6.1: everything moves with what is known at the beginning of the step.
struct ExplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static constexpr int order = 1;

    /// x in m, v in m/s, a in m/s^2 (as it is at the beginning of the step), dt in s: change x and v to what they are
    /// at its end.
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        todo(1);
    }
};

/// By what factor the energy of a mass on a spring, (v^2 + omega^2 x^2) / 2 for each kilogram, is larger after one step
/// of explicit Euler. It is the same factor in every step, whatever x and v are.
inline double energy_factor(Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    return todo(2);
}

} // namespace exercise
