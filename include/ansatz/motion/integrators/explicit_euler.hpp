// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ExplicitEuler`: position and velocity both move with what was known at the beginning of the step (notes 1.6.1).
///
/// Use it to see why it is not used: the energy of an undamped spring grows by the factor 1 + (omega dt)^2 in every
/// step, at every dt. SemiImplicitEuler costs the same and does not. <!-- costs: motion integrator/oscillator:
/// SemiImplicitEuler < 1.15 ExplicitEuler -->

#include <ansatz/motion/concepts.hpp>

namespace ansatz {

/// \f$ x_{n+1} = x_n + v_n\,\Delta t, \quad v_{n+1} = v_n + a(x_n, v_n)\,\Delta t \f$
struct ExplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static constexpr double velocity_leads = -0.5; ///< of a step: v + leads a dt is the velocity where x is
    static constexpr int order = 1;

    /// One step: x and v of one body move with its velocity and its acceleration a, as they are at the beginning.
    [[gnu::always_inline]] static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        x += v * dt; // with the old velocity; the other way round it would be semi-implicit
        v += a * dt;
    }
};

} // namespace ansatz
