// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Rest`: puts bodies to rest that have been slow for a while and would stay where they are (notes 1.1, 1.8, made safe).
///
/// Use it in scenes where most things lie still: a resting body costs no law and no stage, ten thousand of them neither. The notes ask
/// only for a velocity close to zero, which stops a thrown ball at the top of its flight. Here a body must have been slower
/// than `threshold` for `time`, and nothing may pull at it: at velocity zero its acceleration must be exactly zero. So a
/// body under gravity falls asleep only when something holds it. Any force, impulse, new position or change of a policy
/// wakes it. A drift below the threshold counts as rest: it stops after `time`. The notes' own rule is stop_below.hpp.

#include <ansatz/world/concepts.hpp>
#include <ansatz/world/requirements.hpp>

#include <string_view>

namespace ansatz {

/// Slow (|v| < threshold) for `time`, and \f$ \mathbf a(\mathbf x, \mathbf v = 0) = 0 \f$: asleep, with v = 0 exactly.
struct Rest {
    using role = roles::Effect;
    using reads = Columns<Velocity>;
    using writes = Columns<RestTime>;
    static constexpr Place place = Place::after_integration;
    static constexpr int turn = 2; ///< looks at the velocity that is left
    static constexpr bool puts_to_rest = true; ///< it decides who falls asleep

    /// m/s, finite, greater than zero; it says nothing about mass, so that a heavy body rests like a light one
    Parameter<unit::Velocity> threshold = 0.05 * metre_per_second;
    /// s, finite, not negative
    Parameter<unit::Time> time = 0.5 * second;

    static constexpr std::string_view name = "Rest";
    static void parameters(auto& self, auto&& visit) {
        visit("threshold", self.threshold);
        visit("time", self.time);
    }
    void check() const {
        require_positive("Rest", "threshold", threshold);
        require_not_negative("Rest", "time", time);
    }

    template <class S> struct In {
        typename S::Speed threshold;
        typename S::Time time;
        explicit In(const Rest& rest) : threshold(S::convert(rest.threshold)), time(S::convert(rest.time)) {}

        [[gnu::always_inline]] void apply(typename S::Time& slow_for, const typename S::Velocity& v, const auto& context) const {
            const auto counted = slow_for + context.dt();
            slow_for = S::Time::from_value(squared_norm(v) < threshold * threshold ? counted.value() : typename S::Scalar(0));
        }
        /// A sum of steps may end one rounding short of `time`; that is long enough.
        bool long_enough(const typename S::Time& slow_for) const {
            return slow_for.value() > typename S::Scalar(0) && slow_for.value() >= time.value() * typename S::Scalar(0.99999);
        }
    };
};

static_assert(EffectIn<Rest, Space<>>);

} // namespace ansatz
