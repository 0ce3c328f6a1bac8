// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the time counted down
// Why:     A clock that counts down must be set to the time first, and the world starts it at zero. Let it grow, and
//          compare it with the time in long_enough.
// Read:    1.8
// Fails:   adds-up, anew, mass, world

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.8: a body that has been slower than the threshold for a time may sleep.
struct Rest {
    using role = roles::Effect;
    using reads = Columns<Velocity>;
    using writes = Columns<RestTime>;
    static constexpr Place place = Place::after_integration;
    static constexpr int turn = 2; // it acts after all damping
    static constexpr bool puts_to_rest = true;

    Parameter<unit::Velocity> threshold = 0.05 * metre_per_second; ///< greater than zero
    Parameter<unit::Time> time = 0.5 * second;                     ///< not negative

    /// The same in a space S, for example Space<float, 2>; S::Scalar is the type of its numbers.
    template <class S> struct In {
        using Time = typename S::Time;

        typename S::Speed threshold;
        Time time;
        explicit In(const Rest& rest) : threshold(S::convert(rest.threshold)), time(S::convert(rest.time)) {}

        /// For each body, after each step of context.dt(): bring `slow_for` up to date, the time for which it has been
        /// slower than the threshold without a break.
        void apply(Time& slow_for, const typename S::Velocity& v, const auto& context) const {
            if (norm(v) < threshold) slow_for -= context.dt();
            else slow_for = Time();
        }

        /// Whether a body may sleep that has been slow for so long.
        bool long_enough(const Time& slow_for) const {
            // A sum of steps may end a rounding short of the time.
            return slow_for > Time() && slow_for >= typename S::Scalar(0.99999) * time;
        }
    };
};

} // namespace exercise
