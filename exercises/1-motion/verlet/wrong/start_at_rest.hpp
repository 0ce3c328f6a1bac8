// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the history started with the present position
// Why:     Two equal positions are the history of a body that hardly moves: its velocity is forgotten.
// Read:    1.6.4
// Fails:   constant-acceleration, order, throw

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.6.4: the position of now and the one before, instead of a position and a velocity.
struct Verlet {
    using role = roles::Integrator;
    using writes = Columns<Position, PreviousPosition>;
    using scratch = Columns<Velocity>;
    static constexpr int order = 2;

    /// Stage 0 is only for forces that depend on the velocity; the world leaves it out where there are none.
    static constexpr int stages = 2;
    static constexpr int first_stage(bool velocity_read) { return velocity_read ? 0 : 1; }
    static void advance(Stage<0>, auto&, auto&, auto& v, const auto& a, const auto& dt) {
        v = velocity_now(v, a, dt.previous);
    }

    /// Change x to the next position and previous to the present one. a is the acceleration now. dt is the time to the
    /// next position, dt.previous the time since the previous one.
    static void advance(Stage<1>, auto& x, auto& previous, auto&, const auto& a, const auto& dt) {
        // The mean velocity of the last step belongs to its middle; from there to the middle of this one a acts.
        const auto next = x + (x - previous) * (dt / dt.previous) + a * (0.5 * dt * (dt + dt.previous));
        previous = x;
        x = next;
    }

    /// The mean velocity between the previous position and x, dt later.
    static auto mean_velocity(const auto& x, const auto& previous, const auto& dt) -> decltype(x / dt) {
        return (x - previous) / dt;
    }
    /// The velocity at the end of a step of length dt, from its mean velocity and the acceleration at its end.
    template <class V> static V velocity_now(const V& mean, const auto& a, const auto& dt) {
        return mean + 0.5 * a * dt;
    }

    /// Where a body was dt ago that now is at x, with the velocity v and the acceleration a.
    template <class X> static X history(const X& x, const auto& v, const auto& a, const auto& dt) { return x; }
};

} // namespace exercise
