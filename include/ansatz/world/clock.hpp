// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The clock of a world: time as a whole number of equal steps, never as a sum of them.
///
/// A float that adds 1/60 s is 2605 s wrong after a day and stands still after six. Here the time is
/// `start + steps * dt`, where `start` moves only when dt changes: at most one rounding away from the truth.

#include <ansatz/world/space.hpp>

#include <cstdint>

namespace ansatz {

/// \tparam S the space; the clock counts in double at least
template <class S> class StepClock {
public:
    using Time = typename S::ClockTime; ///< s, of the space's clock

    /// The simulated time.
    Time now() const { return start_ + Time::from_value(typename S::ClockScalar(steps_) * dt_.value()); }
    /// How many steps were taken, of whatever length.
    std::uint64_t tick() const { return tick_; }
    /// The length of the last step; zero before the first.
    Time last() const { return dt_; }

    /// One tick further.
    void advance(const Time& dt) {
        if (!(dt == dt_)) {
            start_ = now();
            steps_ = 0;
            dt_ = dt;
        }
        ++steps_;
        ++tick_;
    }

    /// Adds to a hash all that it goes on from.
    template <class Hash> void add_to(Hash& hash) const {
        hash.add(tick_);
        hash.add(steps_);
        hash.add_number(start_.value());
        hash.add_number(dt_.value());
    }
    /// The same tick and the same time.
    friend bool operator==(const StepClock& a, const StepClock& b) {
        return a.start_ == b.start_ && a.dt_ == b.dt_ && a.steps_ == b.steps_ && a.tick_ == b.tick_;
    }

private:
    friend struct Archive;
    Time start_{};
    Time dt_{};
    std::uint64_t steps_ = 0;
    std::uint64_t tick_ = 0;
};

} // namespace ansatz
