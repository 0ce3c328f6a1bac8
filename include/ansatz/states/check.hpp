// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The checker: what is probably wrong with a machine that is well formed (notes 5.2).
///
/// `check(outline)` reads the structure: states that nothing leads to, states that nothing leads out of, transitions
/// that a former one always hides, and guards that compare a continuous value for equality, which motion steps over. A
/// guard that is a function is a closed box to it. `overlapping<D>(contexts)` opens the box by asking: it finds the
/// guards of one state that hold together in contexts that you give, so that the order of the description decides, and
/// the pairs of conditions that lead back and forth in one and the same context, the sort of oscillation that needs no
/// noise.

#include <ansatz/core/error.hpp>
#include <ansatz/states/names.hpp>
#include <ansatz/states/outline.hpp>

#include <algorithm>

namespace ansatz {

/// Something that a checker found.
struct Finding {
    /// What it is about.
    enum class What : std::uint8_t { unreachable, no_exit, hidden, equality, overlap, back_and_forth };
    What what;         ///< what it is about
    std::string state; ///< the name of the state
    long line = 0;     ///< in the machine's file, if it has one
    std::string text;  ///< a sentence
};

namespace states::detail {

inline std::size_t find_state(const Outline& outline, const std::string& name) {
    for (std::size_t s = 1; s < outline.states.size(); ++s)
        if (outline.states[s].name == name) return s;
    return 0;
}

/// Which states can be entered, from the machine's start on, if every guard may hold.
class Reach {
public:
    explicit Reach(const Outline& outline) : outline_(outline), reached_(outline.states.size(), 0) {
        for (std::size_t s = 1; s < outline.states.size(); ++s) ids_.emplace_back(outline.states[s].name, s);
        std::sort(ids_.begin(), ids_.end());
        of_state_.resize(outline.states.size());
        for (std::size_t t = 0; t < outline.transitions.size(); ++t)
            of_state_[outline.transitions[t].source].push_back(t);
        children_.resize(outline.states.size());
        for (std::size_t s = 1; s < outline.states.size(); ++s) children_[outline.states[s].parent].push_back(s);
        reach(0);
        while (!todo_.empty()) {
            const std::size_t s = todo_.back();
            todo_.pop_back();
            follow(s);
        }
    }
    bool operator()(std::size_t s) const { return reached_[s] != 0; }

private:
    std::size_t find(const std::string& name) const {
        const auto at = std::lower_bound(ids_.begin(), ids_.end(), std::pair<std::string, std::size_t>(name, 0));
        return at != ids_.end() && at->first == name ? at->second : 0;
    }
    void reach(std::size_t s) {
        for (; !reached_[s]; s = outline_.states[s].parent) {
            reached_[s] = 1;
            todo_.push_back(s);
            if (s == 0) break;
        }
    }
    void follow(std::size_t s) {
        const auto& state = outline_.states[s];
        for (const auto t : of_state_[s])
            for (const auto& target : outline_.transitions[t].targets) reach(find(target));
        for (const auto& name : state.initial) reach(find(name));
        bool first = true;
        for (const auto child : children_[s]) {
            if (is_history(outline_.states[child].kind)) continue;
            if (state.kind == Kind::parallel || (first && state.initial.empty() && !state.childless)) reach(child);
            first = false;
        }
    }
    const Outline& outline_;
    std::vector<char> reached_;
    std::vector<std::pair<std::string, std::size_t>> ids_;
    std::vector<std::vector<std::size_t>> of_state_, children_;
    std::vector<std::size_t> todo_;
};

inline bool leads_out(const Outline& outline, const Outline::Transition& t) {
    for (const auto& target : t.targets)
        if (target != outline.states[t.source].name) return true;
    return false;
}

inline void check_exits(const Outline& outline, const Reach& reached, std::vector<Finding>& found) {
    std::vector<char> out(outline.states.size(), 0), compound(outline.states.size(), 0);
    for (const auto& t : outline.transitions)
        if (leads_out(outline, t)) out[t.source] = 1;
    for (std::size_t s = 1; s < outline.states.size(); ++s)
        if (!is_history(outline.states[s].kind)) compound[outline.states[s].parent] = 1;
    for (std::size_t s = 1; s < outline.states.size(); ++s) {
        const auto& state = outline.states[s];
        if ((compound[s] && !state.childless) || state.kind == Kind::final || is_history(state.kind) || !reached(s))
            continue;
        bool leaves = false;
        for (std::size_t up = s; up != 0; up = outline.states[up].parent) leaves = leaves || out[up] != 0;
        if (!leaves)
            found.push_back({Finding::What::no_exit, state.name, state.line,
                             "the state \"" + state.name +
                                 "\" has no exit: no transition of it or around it leads anywhere else; if that is "
                                 "meant, make it a final state"});
    }
}

// Whether a transition is always taken before a later one of the same state could be.
inline bool hides(const Outline::Transition& earlier, const Outline::Transition& later) {
    bool same = earlier.events.empty() == later.events.empty();
    for (auto one : words(later.events)) {
        if (one.ends_with(".*")) one.resize(one.size() - 2);
        same = same && matches(earlier.events, one);
    }
    const bool always = earlier.guard.empty() || earlier.guard == later.guard;
    const bool at_once = earlier.events.empty() && earlier.guard.empty();
    return same && always && !(earlier.events.empty() && !at_once && earlier.guard != later.guard);
}
inline void check_hidden(const Outline& outline, std::vector<Finding>& found) {
    const auto& all = outline.transitions;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size() && all[j].source == all[i].source; ++j) {
            const auto& name = outline.states[all[j].source].name;
            if (hides(all[i], all[j]))
                found.push_back({Finding::What::hidden, name, all[j].line,
                                 "a transition of \"" + name + "\"" +
                                     (all[j].events.empty() ? "" : " on \"" + all[j].events + "\"") +
                                     " is never taken: an earlier one " +
                                     (all[i].guard.empty() ? "without a guard" : "with the same guard") +
                                     " is taken before it"});
        }
}

} // namespace states::detail

/// What is probably wrong with a machine.
inline std::vector<Finding> check(const Outline& outline) {
    std::vector<Finding> found;
    if (outline.states.empty()) return found;
    const states::detail::Reach reached(outline);
    for (std::size_t s = 1; s < outline.states.size(); ++s) {
        const auto& state = outline.states[s];
        if (!reached(s) && !states::is_history(state.kind))
            found.push_back(
                {Finding::What::unreachable, state.name, state.line,
                 "the state \"" + state.name + "\" is unreachable: no transition and no initial state leads to it"});
    }
    states::detail::check_exits(outline, reached, found);
    states::detail::check_hidden(outline, found);
    for (const auto& t : outline.transitions)
        if (t.equality)
            found.push_back({Finding::What::equality, outline.states[t.source].name, t.line,
                             "the guard \"" + t.guard + "\" of \"" + outline.states[t.source].name +
                                 "\" compares a continuous value for equality: a value that moves in steps passes it "
                                 "by; use crosses, rises_through or falls_through"});
    return found;
}

/// Refuses a machine with a state that nothing leads to.
/// \throws std::invalid_argument with origin, line and name
inline void refuse_unreachable(const Outline& outline) {
    for (const auto& finding : check(outline))
        if (finding.what == Finding::What::unreachable)
            refuse(Refusal::invalid_argument,
                   outline.origin + (finding.line > 0 ? ":" + std::to_string(finding.line) : "") + ": " + finding.text);
}

} // namespace ansatz
