// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Runner`: carries a plan out, action by action, and plans anew when the world has broken it (notes 6.2, 6.3).
///
/// A plan is broken when the actions that are left can no longer be done one after the other, or would no longer lead to the
/// goal. Other changes do not matter: somebody opens a window, and the tea is made all the same. As with paths, a plan that
/// still holds is kept even where a cheaper one has become possible.

#include <ansatz/paths/goap/planner.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ansatz::goap {

/// A plan on its way.
template <class Planner> class Runner {
public:
    using State = typename Planner::State;         ///< which facts hold
    using Condition = typename Planner::Condition; ///< which facts should

    /// \param planner used, not copied; several runners may share one
    explicit Runner(Planner& planner) : planner_(&planner) {}

    /// Plans for the first time.
    Outcome go(const State& now, const Condition& goal) {
        goal_ = goal;
        plans_ = 0;
        return again(now);
    }
    /// What is to be done now; nothing when the goal is reached or there is no plan.
    std::optional<Action> action() const { return at_ < actions_.size() ? std::optional(actions_[at_]) : std::nullopt; }
    std::span<const Action> ahead() const { return std::span(actions_).subspan(at_); } ///< action() and those behind it
    /// Whether the goal is reached: nothing is left to do.
    bool reached() const { return outcome_ == Outcome::found && at_ == actions_.size(); }
    Outcome outcome() const { return outcome_; } ///< of the last planning
    std::size_t plans() const { return plans_; } ///< how often it planned
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
    /// The world has changed, or may have: plans anew if that has broken the plan. Call it when you like, every frame if need
    /// be. \return whether it planned
    bool look(const State& now) {
        if (goal_.holds_in(now)) { // reached, by us or by luck
            outcome_ = Outcome::found;
            at_ = actions_.size();
            return false;
        }
        if (holds_in(now)) return false;
        again(now);
        return true;
    }
    /// action() has been done: on to the next. \param now what the world has become
    void done(const State& now) {
        if (at_ < actions_.size()) ++at_;
        look(now);
    }
    /// action() has failed: plans anew, whatever the world looks like.
    void failed(const State& now) { again(now); }
    /// Who plans for it.
    const Planner& planner() const { return *planner_; }

private:
    Outcome again(const State& now) {
        outcome_ = planner_->plan(now, goal_);
        ++plans_;
        at_ = 0;
        actions_.clear();
        if (outcome_ == Outcome::found) actions_.assign(planner_->actions().begin(), planner_->actions().end());
        return outcome_;
    }
    Planner* planner_;
    Condition goal_{};
    std::vector<Action> actions_;
    std::size_t at_ = 0, plans_ = 0;
    Outcome outcome_ = Outcome::not_begun;
};
/// The runner of a planner, `Runner{planner}`.
template <class Planner> Runner(Planner&) -> Runner<Planner>;

} // namespace ansatz::goap
