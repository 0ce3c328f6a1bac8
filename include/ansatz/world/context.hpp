// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a policy is told beside the values of its columns: the time step, and, if it asked for the clock, the time.

#include <ansatz/world/columns.hpp>
#include <ansatz/world/space.hpp>

namespace ansatz {

namespace detail {
/// A policy as a space binds it.
template <class P, class S> using Bound = typename P::template In<S>;
/// Whether a policy asks for the time.
template <class P> inline constexpr bool reads_clock = contains<Clock, reads_of<P>>;
template <class P> using without_clock = difference_of<reads_of<P>, Columns<Clock>>;
} // namespace detail

/// The step that is being taken: a time, with the length of the step before it.
///
/// Wherever a formula says dt, this is dt; only an integrator that keeps history needs `previous` (it is dt itself in
/// the first step).
template <class S> struct TimeStep : S::Time {
    /// The length of the step before; the same in the first step.
    typename S::Time previous;

    /// A step and the one before it.
    TimeStep(const typename S::Time& dt, const typename S::Time& before) : S::Time(dt), previous(before) {}
};

/// The moment at which a law is asked.
/// \tparam KnowsTime whether the policy listed `Clock` among what it reads
template <class S, bool KnowsTime = true> class Context {
public:
    /// The time at which the step began, and the step.
    Context(const typename S::ClockTime& time, const TimeStep<S>& dt) : time_(time), dt_(dt) {}

    /// The step, in seconds.
    const TimeStep<S>& dt() const { return dt_; }

    /// The simulated time at this evaluation (between the beginning and the end of the step for a later stage).
    const typename S::ClockTime& time() const {
        static_assert(KnowsTime,
                      "Ansatz: a policy asks for the time that it did not declare; add Clock to its columns, "
                      "e.g. `using reads = Columns<Clock>;`");
        return time_;
    }

    /// The same step, `fraction` of dt later.
    [[gnu::always_inline]] Context later(double fraction) const {
        if (fraction == 0) return *this;
        return Context(S::ClockTime::from_value(time_.value() + typename S::ClockScalar(fraction) *
                                                                    typename S::ClockScalar(dt_.value())),
                       dt_);
    }

    /// This context for a policy that does, or does not, know the time.
    template <bool Knows> [[gnu::always_inline]] Context<S, Knows> restricted() const { return {time_, dt_}; }

private:
    template <class, bool> friend class Context;
    typename S::ClockTime time_;
    TimeStep<S> dt_;
};

} // namespace ansatz
