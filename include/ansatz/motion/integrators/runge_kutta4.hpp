// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `RungeKutta4`: the classical method of fourth order (beyond the notes).
///
/// Use it for short, smooth, accurate trajectories: halving dt divides the error by sixteen. Not for long runs of
/// undamped systems, where its energy drifts a little in every step and never comes back, and not through contacts,
/// where the order is lost. Four evaluations of the forces a step.

#include <ansatz/motion/concepts.hpp>

namespace ansatz {

/// \f$ y_{n+1} = y_n + \tfrac{\Delta t}{6}(k_1 + 2 k_2 + 2 k_3 + k_4) \f$ for y = (x, v), y' = (v, a).
struct RungeKutta4 {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    using scratch = Columns<ScratchVector<unit::Length>, ScratchVector<unit::Velocity, 0>,
                            ScratchVector<unit::Velocity, 1>, ScratchVector<unit::Acceleration>>;
    static constexpr int stages = 4;
    static constexpr double nodes[] = {0, 0.5, 0.5, 1}; ///< the times of the stages, as fractions of the step
    static constexpr int order = 4;

    // x0, v0: the state that the step started from; sum_v, sum_a: the weighted slopes so far.
    /// The first slope, at the beginning of the step; x0 and v0 keep where it began.
    [[gnu::always_inline]] static void advance(Stage<0>, auto& x, auto& v, auto& x0, auto& v0, auto& sum_v, auto& sum_a,
                                               const auto& a, const auto& dt) {
        x0 = x;
        v0 = v;
        sum_v = v;
        sum_a = a;
        x = x0 + 0.5 * dt * v;
        v = v0 + 0.5 * dt * a;
    }
    /// The second slope, half a step along the first.
    [[gnu::always_inline]] static void advance(Stage<1>, auto& x, auto& v, auto& x0, auto& v0, auto& sum_v, auto& sum_a,
                                               const auto& a, const auto& dt) {
        sum_v += 2.0 * v;
        sum_a += 2.0 * a;
        x = x0 + 0.5 * dt * v;
        v = v0 + 0.5 * dt * a;
    }
    /// The third slope, half a step along the second.
    [[gnu::always_inline]] static void advance(Stage<2>, auto& x, auto& v, auto& x0, auto& v0, auto& sum_v, auto& sum_a,
                                               const auto& a, const auto& dt) {
        sum_v += 2.0 * v;
        sum_a += 2.0 * a;
        x = x0 + dt * v;
        v = v0 + dt * a;
    }
    /// The fourth slope, a whole step along the third, and the sum of all.
    [[gnu::always_inline]] static void advance(Stage<3>, auto& x, auto& v, auto& x0, auto& v0, auto& sum_v, auto& sum_a,
                                               const auto& a, const auto& dt) {
        x = x0 + (sum_v + v) * (dt / 6.0);
        v = v0 + (sum_a + a) * (dt / 6.0);
    }
};

} // namespace ansatz
