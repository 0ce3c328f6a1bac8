// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Planner`: the cheapest series of actions from a state to a goal (notes 6.2), by the same A* that finds paths.
///
/// `Planner{domain}` plans with `Careful` and finds the cheapest plan; `Planner{domain, Greedy{}}` is faster and may
/// not. <!-- costs: paths planner/*: Greedy < 0.5 Careful --> %Keep it: it allocates nothing once warm. It reads the
/// domain, so actions may be added and costs changed between plans.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/goap/explain.hpp>
#include <ansatz/paths/goap/heuristics.hpp>
#include <ansatz/paths/goap/state_graph.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::goap {

using paths::Outcome;

/// Plans.
/// \tparam Policies of the search: `Careful` (without any), `Greedy`, or any other that AStar takes
template <class Domain, class... Policies> class Planner;

/// Plans in a domain of so many words.
template <std::size_t Words, class... Policies> class Planner<Domain<Words>, Policies...> {
    using Graph = StateGraph<Words>;
    static constexpr bool chosen = (paths::HasRole<Policies, paths::roles::Heuristic> || ...);

public:
    using State = goap::State<Words>;         ///< which facts hold
    using Condition = goap::Condition<Words>; ///< which facts should
    /// The search that it plans with, by `Careful` where no heuristic is named.
    using Search = typename std::conditional_t<chosen, std::type_identity<paths::AStar<Graph, Policies...>>,
                                               std::type_identity<paths::AStar<Graph, Careful, Policies...>>>::type;

    /// \param domain read, never copied: it must live as long as this
    explicit Planner(const Domain<Words>& domain, Policies... policies)
        : graph_(domain), search_(made(graph_, policies...)) {}
    explicit Planner(const Domain<Words>&&, Policies...) = delete;
    Planner(const Planner&) = delete; // its search reads its own graph
    Planner& operator=(const Planner&) = delete;

    /// Plans in one go.
    /// \param most how many states may be expanded before it gives up; then actions() lead to the state that came
    /// nearest
    Outcome plan(const State& now, const Condition& goal, std::size_t most = Search::without_end) {
        leave_out({});
        search_.find(now, goal, most);
        return read(now);
    }
    /// The same without some of the actions: the cheapest plan of the others.
    /// \param left_out their numbers; one that the domain does not have is none
    Outcome plan_without(std::span<const Action> left_out, const State& now, const Condition& goal,
                         std::size_t most = Search::without_end) {
        leave_out(left_out);
        search_.find(now, goal, most);
        return read(now);
    }
    /// \name A plan in slices: so many states a frame
    /// @{
    /// Sets out to plan.
    void begin(const State& now, const Condition& goal) {
        leave_out({});
        search_.begin(now, goal);
        start_ = now;
        actions_.clear();
    }
    /// Expands up to so many states more and returns the outcome so far.
    Outcome advance(std::size_t states) {
        search_.advance(states);
        return search_.outcome() == Outcome::running ? Outcome::running : read(start_);
    }
    /// @}

    /// How the last planning stands or ended.
    Outcome outcome() const { return search_.outcome(); }
    std::span<const Action> actions() const { return actions_; }     ///< what to do, in order
    std::span<const State> states() const { return search_.path(); } ///< before the first and after each
    double cost() const { return double(search_.cost()); }           ///< of all actions together
    std::size_t expanded() const { return search_.expanded(); }      ///< states whose actions were visited
    /// What it plans with.
    const Domain<Words>& domain() const { return graph_.domain(); }
    /// Its search, to read.
    const Search& search() const { return search_; }
    /// The plan, or why there is none, in a sentence.
    std::string why() const {
        if (outcome() == Outcome::no_path) {
            const std::string reason = explain(domain(), start_, search_.goal());
            if (!reason.empty()) return "there is no plan: " + reason;
            if (!left_out_.empty()) {
                std::string names;
                for (const Action a : left_out_) names += (names.empty() ? "\"" : ", \"") + domain().name_of(a) + "\"";
                return "there is no plan without what is left out: " + names;
            }
            return "there is no plan: every fact of the goal can be had, but not all at once; all " +
                   std::to_string(expanded()) + " states that can be reached were expanded";
        }
        if (outcome() != Outcome::found) return search_.why();
        if (actions_.empty()) return "nothing needs to be done";
        std::string text;
        for (const Action a : actions_) text += (text.empty() ? "" : ", ") + domain().name_of(a);
        return text;
    }

private:
    static Search made(const Graph& g, const Policies&... policies) {
        if constexpr (chosen) return Search(g, policies...);
        else return Search(g, Careful{}, policies...);
    }
    void leave_out(std::span<const Action> actions) {
        left_out_.clear();
        for (const Action a : actions)
            if (a < domain().actions()) left_out_.push_back(a);
        graph_.use(nullptr);
        if (left_out_.empty()) return;
        rules_ = domain().rules();
        for (const Action a : left_out_) rules_[a].makes = {}; // an action that changes nothing is no edge
        graph_.use(&rules_);
    }
    /// The actions between the states of the path: of several that lead to the same state the cheapest.
    Outcome read(const State& now) {
        start_ = now;
        actions_.clear();
        const auto path = search_.path();
        const auto& rules = graph_.rules();
        for (std::size_t i = 1; i < path.size(); ++i) {
            Action best = rules.size();
            for (Action a = 0; a < rules.size(); ++a)
                if (rules[a].after(path[i - 1]) == path[i] && rules[a].needs.holds_in(path[i - 1]) &&
                    (best == rules.size() || rules[a].cost < rules[best].cost))
                    best = a;
            actions_.push_back(best);
        }
        return search_.outcome();
    }
    Graph graph_;
    typename Graph::Rules rules_; // where some are left out
    Search search_;
    State start_{};
    std::vector<Action> actions_, left_out_;
};
/// The planner of a domain, `Planner{domain}`.
template <std::size_t Words, class... Policies>
Planner(const Domain<Words>&, Policies...) -> Planner<Domain<Words>, Policies...>;

} // namespace ansatz::goap
