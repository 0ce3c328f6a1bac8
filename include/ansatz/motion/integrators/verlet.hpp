// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Verlet`: the position history instead of a velocity (notes 1.6.4).
///
/// Use it where positions are moved directly (constraints, cloth): the velocity follows by itself. Time-reversible,
/// without damping, with a fixed step and forces of position; stable up to omega dt = 2. Its velocity is derived: the
/// difference of the last two positions is the velocity of half a step ago, which `World::velocity` brings to the
/// present with half a step of acceleration. For forces that depend on the velocity the same is done first, at the
/// price of one more evaluation, so that it stays of second order.
///
/// The start needs \f$ x_{-1} = x_0 - v_0\,\Delta t + \tfrac12 a_0\,\Delta t^2 \f$ (without the last term the method is of
/// first order); it is completed in the first step, when \f$ \Delta t \f$ and \f$ a_0 \f$ are known. A step that differs
/// from the one before is corrected for, which keeps the second order where the usual formula does not converge at all.
///
/// Its price: the velocity is the small difference of two positions. Far from the origin, or with tiny steps, digits of
/// it are lost for ever: a float body at 1e6 m that moves by less than its position's rounding in a step stands still.
/// The origin should be near; or take double, or VelocityVerlet, which stores the velocity.
///
/// L. %Verlet, Phys. Rev. 159, 98 (1967). Deliberately not provided: a longer FIFO; nothing would read it.

#include <ansatz/motion/concepts.hpp>

namespace ansatz {

/// \f$ x_{n+1} = x_n + (x_n - x_{n-1}) \frac{\Delta t_n}{\Delta t_{n-1}} + a_n\, \Delta t_n \frac{\Delta t_n + \Delta t_{n-1}}{2} \f$,
/// which for equal steps is the notes' \f$ x_n + (x_n - x_{n-1}) + a_n \Delta t^2 \f$.
struct Verlet {
    using role = roles::Integrator;
    using writes = Columns<Position, PreviousPosition>;
    using scratch = Columns<Velocity>;
    static constexpr int order = 2;
    static constexpr bool reversible = true;

    /// Stage 0 brings the velocity to the present, for forces that ask for it; without such forces it is left out.
    static constexpr int stages = 2;
    /// The stage to begin with.
    static constexpr int first_stage(bool velocity_read) { return velocity_read ? 0 : 1; }

    /// The velocity now, from the last two positions and half a step of acceleration.
    [[gnu::always_inline]] static void advance(Stage<0>, auto&, auto&, auto& v, const auto& a, const auto& dt) {
        v = velocity_now(v, a, dt.previous);
    }
    /// The next position from the last two and the acceleration.
    [[gnu::always_inline]] static void advance(Stage<1>, auto& x, auto& previous, auto&, const auto& a,
                                               const auto& dt) {
        const auto next = x + (x - previous) * (dt / dt.previous) + a * (0.5 * dt * (dt + dt.previous));
        previous = x;
        x = next;
    }

    /// \name What velocity means
    /// @{

    /// The mean velocity of the last step, of length dt: it belongs to half a step ago.
    [[gnu::always_inline]] static auto mean_velocity(const auto& x, const auto& previous, const auto& dt) {
        return (x - previous) / dt;
    }
    /// From the mean velocity of the last step to the velocity now.
    [[gnu::always_inline]] static auto velocity_now(const auto& mean, const auto& a, const auto& dt) {
        return mean + 0.5 * a * dt;
    }
    /// The previous position that makes `v` the velocity now: the start of the history.
    [[gnu::always_inline]] static auto history(const auto& x, const auto& v, const auto& a, const auto& dt) {
        return x - v * dt + 0.5 * a * (dt * dt);
    }
    /// @}
};

} // namespace ansatz
