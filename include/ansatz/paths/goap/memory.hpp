// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a `Runner` makes of actions that failed: it forgets them, or it remembers.
///
/// | policy | an action that has failed | use it |
/// |---|---|---|
/// | `Forgets` | is planned again at once, up to the runner's `attempts` | where it was bad luck: a blow that misses |
/// | `Remembers` | is left out for a while, twice as long each time | where something hidden is wrong: a stuck door |
///
/// The facts of a domain do not say why an action failed, or it would not have been planned. So a runner that forgets
/// plans the stuck door for ever, while there is a window. One that remembers takes the window; where there is none it
/// has no plan, and tries the door again when its time is over. With `attempts` n, `pause` p and `longest` L, what
/// always fails is tried at most n times, and from then on after p, 2p, 4p, ... and at last every L. What has
/// succeeded, and what is forgiven, is as new.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/units.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ansatz::goap {

/// Nothing is known of earlier failures; takes no byte.
struct Forgets {
    static constexpr bool remembers = false; ///< no
};

/// An action that has failed is left out of plans for a while.
struct Remembers {
    static constexpr bool remembers = true;        ///< yes
    std::size_t attempts = 1;                      ///< failures, one after the other, until it is left out
    Quantity<unit::Time> pause = 10.0 * second;    ///< for how long the first time, s; infinite: until it is forgiven
    Quantity<unit::Time> longest = 640.0 * second; ///< it becomes twice as long each time, up to this, s
};

namespace detail {

/// What failed how often, and until when it is left out.
class Failures {
public:
    /// Of one action.
    struct Record {
        std::uint64_t failures = 0;   ///< since it succeeded last
        Quantity<unit::Time> pause{}; ///< of the last time that it was left out
        Quantity<unit::Time> until{}; ///< when it is tried again, by the clock
        bool out = false;             ///< it is left out
        friend bool operator==(const Record&, const Record&) = default;
    };

    /// \throws std::invalid_argument for no attempt at all, and for a pause that is not positive, or longer than the
    /// longest
    explicit Failures(const Remembers& policy) : policy_(policy) {
        if (policy.attempts < 1)
            refuse_value("goap::Remembers", "attempts", std::to_string(policy.attempts),
                         "an action is tried once at least");
        if (!(policy.pause.value() > 0)) refuse_value("goap::Remembers", "pause", policy.pause, "it must be positive");
        if (!(policy.longest >= policy.pause))
            refuse_value("goap::Remembers", "longest", policy.longest,
                         "it must be at least the pause, " + describe(policy.pause));
    }

    /// Time goes by. \return whether an action is tried again from now on
    bool pass(Parameter<unit::Time> dt) {
        if (!(dt.value() >= 0 && dt.value() <= std::numeric_limits<double>::max()))
            refuse_value("goap::Runner::pass", "dt", dt, "the time that has gone by is finite and not negative");
        now_ += dt;
        return let_in([&](const Record& r) { return r.until <= now_; });
    }
    void failed(Action a) {
        if (records_.size() <= a) records_.resize(a + 1);
        auto& r = records_[a];
        if (++r.failures < policy_.attempts) return;
        r.pause = r.pause.value() > 0 ? std::min(r.pause + r.pause, policy_.longest) : policy_.pause;
        r.until = now_ + r.pause;
        r.out = true;
        list();
    }
    void done(Action a) {
        if (a < records_.size()) forgive(a);
    }
    bool forgive(Action a) {
        if (a >= records_.size()) return false;
        const bool was_out = records_[a].out;
        records_[a] = {};
        if (was_out) list();
        return was_out;
    }
    std::span<const Action> left_out() const { return out_; }
    std::uint64_t failures(Action a) const { return a < records_.size() ? records_[a].failures : 0; }
    std::uint64_t version() const { return version_; } // another set is left out

    // To save it.
    const std::vector<Record>& records() const { return records_; }
    Quantity<unit::Time> now() const { return now_; }
    void set(std::vector<Record> records, Quantity<unit::Time> now) {
        records_ = std::move(records), now_ = now;
        list();
    }

private:
    bool let_in(auto&& which) {
        bool any = false;
        for (auto& r : records_)
            if (r.out && which(r)) r.out = false, any = true;
        if (any) list();
        return any;
    }
    void list() {
        out_.clear();
        for (Action a = 0; a < records_.size(); ++a)
            if (records_[a].out) out_.push_back(a);
        ++version_;
    }
    Remembers policy_;
    std::vector<Record> records_; // of each action up to the last that failed
    std::vector<Action> out_;
    Quantity<unit::Time> now_{};
    std::uint64_t version_ = 0;
};

/// Of Forgets: nothing.
struct NoFailures {
    explicit NoFailures(const Forgets&) {}
};

} // namespace detail
} // namespace ansatz::goap
