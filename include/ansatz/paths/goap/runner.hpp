// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Runner`: carries a plan out, action by action, and plans anew when the world has broken it (notes 6.2, 6.3).
///
/// A plan is broken when the actions that are left can no longer be done one after the other, or would no longer lead
/// to the goal. Other changes do not matter: somebody opens a window, and the tea is made all the same. As with paths,
/// a plan that still holds is kept even where a cheaper one has become possible. And the planner is not asked twice:
/// from the same state to the same goal, by the same actions, there is the same plan, or none.
///
/// What failed is forgotten, `Runner{planner}`, or left out of plans for a while, `Runner{planner, goap::Remembers{}}`,
/// which memory.hpp explains. `save` and `load` of a runner are in goap/save.hpp.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goap/memory.hpp>
#include <ansatz/paths/goap/planner.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::goap {

/// What writes runners down and reads them back: goap/save.hpp.
struct RunnerArchive;

/// A plan on its way.
/// \tparam Memory what it makes of actions that failed: Forgets or Remembers
template <class Planner, class Memory = Forgets> class Runner {
public:
    static constexpr bool remembers = Memory::remembers; ///< whether it leaves out what failed
    using State = typename Planner::State;               ///< which facts hold
    using Condition = typename Planner::Condition;       ///< which facts should

    static constexpr std::size_t without_end = std::numeric_limits<std::size_t>::max(); ///< attempts, if none are given

    /// \param planner  used, not copied; several runners may share one
    /// \param attempts how often an action may fail, one time after the other in a world that stays as it is, before
    /// the
    ///                 runner gives up: then there is nothing to do until the world changes
    /// \throws std::invalid_argument for no attempt at all
    explicit Runner(Planner& planner, std::size_t attempts = without_end)
        requires(!remembers)
        : planner_(&planner), attempts_(attempts) {
        if (attempts < 1)
            refuse_value("goap::Runner", "attempts", std::to_string(attempts), "an action is tried once at least");
    }

    /// The same, and what failed is remembered.
    /// \throws std::invalid_argument for no attempt at all, for a pause that is not positive, and for a longest below it
    explicit Runner(Planner& planner, const std::type_identity_t<Memory>& memory)
        requires remembers
        : planner_(&planner), attempts_(without_end), memory_(memory) {}

    /// Plans for the first time. What failed on the way to an earlier goal is still known.
    Outcome go(const State& now, const Condition& goal) {
        goal_ = goal;
        plans_ = searches_ = failures_ = 0;
        return again(now);
    }
    /// What is to be done now; nothing when the goal is reached or there is no plan.
    std::optional<Action> action() const { return at_ < actions_.size() ? std::optional(actions_[at_]) : std::nullopt; }
    std::span<const Action> ahead() const { return std::span(actions_).subspan(at_); } ///< action() and those behind it
    /// Whether the goal is reached: nothing is left to do.
    bool reached() const { return outcome_ == Outcome::found && at_ == actions_.size(); }
    /// Of the last planning; gave_up when actions have failed too often, or there is no plan without those that are
    /// left out: then there is nothing to do for now.
    Outcome outcome() const { return outcome_; }
    std::size_t plans() const { return plans_; }       ///< how often it set out by a plan from the beginning
    std::size_t searches() const { return searches_; } ///< how often the planner was asked for one
    /// Whether the actions that are left still lead from this state to the goal.
    bool holds_in(const State& now) const {
        if (outcome_ != Outcome::found) return false;
        State s = now;
        for (const Action a : ahead()) {
            const auto& rule = planner_->domain().rules()[a];
            if (!rule.needs.holds_in(s)) return false;
            s = rule.after(s);
        }
        return goal_.holds_in(s);
    }
    /// The world has changed, or may have: plans anew if that has broken the plan. Call it when you like, every frame
    /// if need be: where there is no plan it asks for one when the state or the domain is another.
    /// \return whether there is a new plan
    bool look(const State& now) {
        if (goal_.holds_in(now)) { // reached, by us or by luck
            outcome_ = Outcome::found;
            at_ = actions_.size();
            return false;
        }
        if (holds_in(now) || (outcome_ != Outcome::found && is_answered(now))) return false;
        again(now);
        return true;
    }
    /// action() has been done: on to the next.
    /// \param now what the world has become
    void done(const State& now) {
        failures_ = 0;
        if constexpr (remembers)
            if (at_ < actions_.size()) memory_.done(actions_[at_]);
        if (at_ < actions_.size()) ++at_;
        look(now);
    }
    /// action() has failed: begins anew, by the plan for what the world is like now, or gives up.
    void failed(const State& now) {
        if constexpr (remembers)
            if (at_ < actions_.size()) memory_.failed(actions_[at_]);
        again(now);
        if (++failures_ < attempts_ || outcome_ != Outcome::found) return;
        outcome_ = Outcome::gave_up;
        at_ = actions_.size();
    }
    /// Its planner.
    const Planner& planner() const { return *planner_; }

    /// \name What failed, of a runner that remembers
    /// @{
    /// Time goes by: what was left out for long enough may be planned again. A plan that holds is kept.
    /// \param dt s
    /// \throws std::invalid_argument for a time that is negative or not finite
    void pass(Parameter<unit::Time> dt) {
        require_memory();
        memory_.pass(dt);
    }
    /// The actions that are left out for now, in their order.
    std::span<const Action> left_out() const {
        require_memory();
        return memory_.left_out();
    }
    /// How often an action has failed since it succeeded last.
    std::uint64_t failures(Action a) const {
        require_memory();
        return memory_.failures(a);
    }
    /// The action is as new: you know that the door was mended. The next look() plans with it, where there is no plan.
    void forgive(Action a) {
        require_memory();
        memory_.forgive(a);
    }
    /// The same of all actions.
    void forgive() {
        require_memory();
        for (Action a = 0; a < planner_->domain().actions(); ++a) memory_.forgive(a);
    }
    /// @}

private:
    friend struct RunnerArchive;
    static constexpr void require_memory() {
        static_assert(remembers, "Ansatz: this runner forgets what failed; make it with a memory, "
                                 "goap::Runner{planner, goap::Remembers{}}");
    }
    std::uint64_t memory_version() const {
        if constexpr (remembers) return memory_.version();
        else return 0;
    }
    /// Whether the last planning was from this state, by what the domain is like now.
    bool is_answered(const State& now) const {
        return searches_ > 0 && now == from_ && planner_->domain().version() == version_ &&
               memory_version() == left_out_version_;
    }
    Outcome again(const State& now) {
        at_ = 0;
        ++plans_;
        if (is_answered(now)) return outcome_ = answer_;
        failures_ = 0;
        if constexpr (remembers) {
            answer_ = planner_->plan_without(memory_.left_out(), now, goal_);
            if (answer_ == Outcome::no_path && !memory_.left_out().empty()) answer_ = Outcome::gave_up;
        } else answer_ = planner_->plan(now, goal_);
        outcome_ = answer_;
        ++searches_;
        from_ = now, version_ = planner_->domain().version(), left_out_version_ = memory_version();
        actions_.clear();
        if (outcome_ == Outcome::found) actions_.assign(planner_->actions().begin(), planner_->actions().end());
        return outcome_;
    }
    Planner* planner_;
    Condition goal_{};
    State from_{}; ///< the state that was planned from
    std::vector<Action> actions_;
    std::size_t attempts_, at_ = 0, plans_ = 0, searches_ = 0, failures_ = 0, version_ = 0;
    std::uint64_t left_out_version_ = 0;
    [[no_unique_address]] std::conditional_t<remembers, detail::Failures, detail::NoFailures> memory_{Memory{}};
    Outcome outcome_ = Outcome::not_begun, answer_ = Outcome::not_begun; ///< the latter the planner's
};
/// The runner of a planner, `Runner{planner}`.
template <class Planner> Runner(Planner&) -> Runner<Planner>;
/// The same with a number of attempts, `Runner{planner, 3}`.
template <class Planner> Runner(Planner&, std::size_t) -> Runner<Planner>;
/// The same with a memory, `Runner{planner, Remembers{}}`.
template <class Planner> Runner(Planner&, Remembers) -> Runner<Planner, Remembers>;

} // namespace ansatz::goap
