// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `VelocityVerlet`: Verlet's scheme with the velocity kept beside the position, of second order (beyond notes 1.6.4).
///
/// Use it where SemiImplicitEuler is not accurate enough: for forces of position it is symplectic, time-reversible and
/// stable up to omega dt = 2. For forces that depend on the velocity it predicts that velocity for its second
/// evaluation, so that it stays of second order (a scheme that reuses the old one drops to first), though no longer
/// reversible. Two evaluations of the forces a step; the usual trick of carrying the last one over to the next step is
/// deliberately not played, because any contact, impulse or changed policy in between would make it stale.
///
/// W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson, J. Chem. Phys. 76, 637 (1982).

#include <ansatz/motion/concepts.hpp>

namespace ansatz {

/// \f$ x_{n+1} = x_n + v_n \Delta t + \tfrac12 a_n \Delta t^2, \quad v_{n+1} = v_n + \tfrac12 (a_n + a_{n+1}) \Delta t \f$
struct VelocityVerlet {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    using scratch = Columns<ScratchVector<unit::Velocity>>;
    static constexpr int stages = 2;
    static constexpr double nodes[] = {0, 1}; ///< the times of the stages, as fractions of the step
    static constexpr int order = 2;
    static constexpr bool reversible = true;

    /// Half a step of velocity, and a whole one of position with it.
    [[gnu::always_inline]] static void advance(Stage<0>, auto& x, auto& v, auto& half, const auto& a, const auto& dt) {
        half = v + 0.5 * a * dt;
        x += half * dt;
        v += a * dt; // predicted, for forces that ask for it
    }
    /// The other half of the velocity, with the acceleration at the new position.
    [[gnu::always_inline]] static void advance(Stage<1>, auto&, auto& v, auto& half, const auto& a, const auto& dt) {
        v = half + 0.5 * a * dt;
    }
};

} // namespace ansatz
