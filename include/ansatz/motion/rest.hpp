// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Rest`: puts bodies to rest that have been slow for a while and would stay where they are (notes 1.1, 1.8, made
/// safe).
///
/// Use it in scenes where most things lie still: a resting body costs no law and no stage, ten thousand of them
/// neither. The notes ask only for a velocity close to zero, which stops a thrown ball at the top of its flight. Here a
/// body must have been slower than `threshold` for `time`, and what pulls at it must be balanced: the acceleration that
/// remains to it at velocity zero may not exceed `pull`. So a body under gravity falls asleep only when something holds
/// it: a spring, or a contact. Any force, impulse, new position or change of a policy wakes it. A drift below the
/// threshold counts as rest: it stops after `time`. The notes' own rule is stop_below.hpp.
///
/// **How `pull` is chosen.** What hangs on springs and is slowed comes ever closer to its balance and never reaches it;
/// `pull` says what is close enough. It must be smaller than the weakest pull that shall move a body from rest (a tenth
/// of it, say): a body under weaker gravity alone falls asleep in the air. And it must be larger than what rounding
/// leaves of balanced forces, about the largest acceleration of one of them times 10^-15 (double) or 10^-6 (float). The
/// default is a ten thousandth of the earth's gravity; a sleeper on a spring stops (pull/omega^2) from its balance, a
/// fortieth of a millimetre at one swing in a second. Zero means nothing at all.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// Slow (|v| < threshold) for `time`, and \f$ |\mathbf a(\mathbf x, \mathbf v = 0)| \le \f$ `pull`: asleep, with v = 0
/// exactly.
struct Rest {
    using role = roles::Effect;
    using reads = Columns<Velocity>;
    using writes = Columns<RestTime>;
    static constexpr Place place = Place::after_integration;
    static constexpr int turn = 2;             ///< tests the velocity that is left
    static constexpr bool puts_to_rest = true; ///< it decides which bodies fall asleep

    /// m/s, finite, greater than zero; it says nothing about mass, so that a heavy body rests like a light one
    Parameter<unit::Velocity> threshold = 0.05 * metre_per_second;
    /// s, finite, not negative
    Parameter<unit::Time> time = 0.5 * second;
    /// m/s^2, finite, not negative: the acceleration that may remain
    Parameter<unit::Acceleration> pull = 1e-3 * metre_per_second_squared;

    static constexpr std::string_view name = "Rest";
    static void parameters(auto& self, auto&& visit) {
        visit("threshold", self.threshold);
        visit("time", self.time);
        visit("pull", self.pull);
    }
    void check() const {
        require_positive("Rest", "threshold", threshold);
        require_not_negative("Rest", "time", time);
        require_not_negative("Rest", "pull", pull);
    }

    template <class S> struct In {
        typename S::template ScalarOf<unit::SpecificEnergy> slow; ///< of |v|^2
        typename S::Time time;
        typename S::template ScalarOf<unit::Acceleration> pull;
        explicit In(const Rest& rest)
            : slow(detail::squared_threshold<typename S::Speed>(S::convert(rest.threshold))),
              time(S::convert(rest.time)),
              pull(S::convert(rest.pull)) {}

        [[gnu::always_inline]] void apply(typename S::Time& slow_for, const typename S::Velocity& v,
                                          const auto& context) const {
            const auto counted = slow_for + context.dt();
            slow_for = S::Time::from_value(squared_norm(v) < slow ? counted.value() : typename S::Scalar(0));
        }
        /// A sum of steps may end one rounding short of `time`; that is long enough.
        bool long_enough(const typename S::Time& slow_for) const {
            return slow_for.value() > typename S::Scalar(0) &&
                   slow_for.value() >= time.value() * typename S::Scalar(0.99999);
        }
        /// Whether what remains of all that pulls at a body lets it rest. A policy of your own may leave this out: then
        /// nothing may remain.
        bool balanced(const typename S::Acceleration& remains) const { return !(robust_norm(remains) > pull); }
    };
};

} // namespace ansatz
