// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SemiImplicitEuler`: velocity first, then the position with the new velocity (notes 1.6.3).
///
/// The integrator to begin with: as cheap as explicit Euler <!-- costs: motion integrator/oscillator:
/// SemiImplicitEuler < 1.15 ExplicitEuler -->, and symplectic, so that the energy of a spring or an orbit
/// swings about the true one for ever instead of growing. Stable up to omega dt = 2 exactly, and explicit damping makes
/// that limit smaller, not larger. Not when the trajectory itself must be accurate: it is of first order; see
/// velocity_verlet.hpp and runge_kutta4.hpp.

#include <ansatz/motion/concepts.hpp>

namespace ansatz {

/// \f$ v_{n+1} = v_n + a(x_n, v_n)\,\Delta t, \quad x_{n+1} = x_n + v_{n+1}\,\Delta t \f$
struct SemiImplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static constexpr double velocity_leads = 0.5; ///< of a step: v + leads a dt is the velocity where x is
    static constexpr int order = 1;

    /// One step: v of one body moves with its acceleration a, then x with the new v.
    [[gnu::always_inline]] static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) {
        v += a * dt;
        x += v * dt;
    }
};

} // namespace ansatz
