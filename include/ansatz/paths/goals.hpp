// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `OneGoal`, `AnyGoal` and `GoalWhere`: what a search is to reach; the role Goals of `AStar`.
///
/// ```
/// AStar nearest{map, AnyGoal{}};
/// if (nearest.find(hero, medkits) == Outcome::found) walk_to(nearest.path().back());    // which of them it is
/// AStar lookout{map, GoalWhere{[&](Cell c) { return height(c) > 30; }}};
/// lookout.find(hero);                                                                   // the nearest such tile
/// ```
///
/// With `AnyGoal` one search finds the cheapest path to any of several goals, whose cost is the least that single
/// searches for each would find. Its estimate is the least of those for each goal: never too much where theirs is not,
/// and consistent where theirs is. Every node asks for all of them, so a dozen goals are well served; for hundreds take
/// `AnyGoal` with `ZeroHeuristic`, or `GoalWhere` with a table of your own. Where many search for the same goals,
/// search once, backwards: `FlowField`.
///
/// With `GoalWhere` the goal is a condition on a vertex. Nothing is known of where it holds, so the search spreads
/// evenly (`ZeroHeuristic`), unless `By{function of the vertex}` estimates the rest. A graph whose every goal is a
/// condition declares it as its `goal_type` (goap/state_graph.hpp), and needs none of these.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/heuristics/zero.hpp>
#include <ansatz/paths/roles.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// Several vertices, any of which is the goal. Copies share what they hold and never change it under each other.
template <class Vertex> class VertexSet {
public:
    /// The vertices, in the order in which they were given.
    std::span<const Vertex> all() const { return kept_ ? std::span<const Vertex>(*kept_) : std::span<const Vertex>(); }
    /// Takes these in place of those before; allocates nothing where there was room for as many.
    void assign(std::span<const Vertex> vertices) {
        const bool of_its_own = kept_ && !vertices.empty() && std::less_equal<>{}(kept_->data(), vertices.data()) &&
                                std::less<>{}(vertices.data(), kept_->data() + kept_->size());
        if (!kept_ || kept_.use_count() > 1 || of_its_own)
            kept_ = std::make_shared<std::vector<Vertex>>(vertices.begin(), vertices.end());
        else kept_->assign(vertices.begin(), vertices.end());
    }
    /// Whether this vertex is one of them.
    friend bool is_reached(const Vertex& v, const VertexSet& set) {
        for (const Vertex& goal : *set.kept_)
            if (goal == v) return true;
        return false;
    }

private:
    std::shared_ptr<std::vector<Vertex>> kept_;
};

/// A condition on a vertex, as a goal.
template <class Condition> struct Meets {
    std::shared_ptr<const Condition> condition; ///< shared, for copies of a goal are many and a function may be large
    /// Whether this vertex meets it.
    template <class Vertex> friend bool is_reached(const Vertex& v, const Meets& goal) { return (*goal.condition)(v); }
};

namespace detail {

/// The least of the estimates for several goals.
template <class Bound> struct LeastEstimate {
    std::shared_ptr<std::vector<Bound>> of; ///< one for each goal
    template <class Vertex> auto operator()(const Vertex& v) const {
        auto least = of->front()(v);
        for (std::size_t i = 1; i < of->size(); ++i) least = std::min(least, (*of)[i](v));
        return least;
    }
};
template <class Graph>
void require_vertex(const char* where, const char* what, const Graph& g, const VertexOf<Graph>& v) {
    if (!contains(v, g)) refuse_value(where, what, name_of_vertex(v, g), size_of_graph(g));
}
/// \throws std::invalid_argument for none, and for one that the graph does not have
template <class Graph>
void require_vertices(const char* where, const char* one, const char* number, const Graph& g,
                      std::span<const VertexOf<Graph>> all) {
    if (all.empty()) refuse_value(where, number, "0", "there must be one at least");
    for (const auto& v : all) require_vertex(where, one, g, v);
}
/// Heuristics that ask nothing of the goal.
template <class Heuristic, class Vertex>
inline constexpr bool asks_for_no_goal = std::is_same_v<Heuristic, ZeroHeuristic>;
template <class Function, class Vertex>
inline constexpr bool asks_for_no_goal<By<Function>, Vertex> =
    std::is_invocable_v<const Function&, const Vertex&> &&
    !std::is_invocable_v<const Function&, const Vertex&, const Vertex&>;

} // namespace detail

/// One vertex, or the condition that the graph declares as its `goal_type`; the default.
struct OneGoal {
    using role = roles::Goals;
    static constexpr bool has_places = true; ///< a heuristic can be bound to it
    /// The goal of a query.
    template <class Graph> using In = GoalOf<Graph>;
    /// What `find` is given.
    template <class Graph> using Wanted = GoalOf<Graph>;
    /// \throws std::invalid_argument for a goal that the graph does not have
    template <class Graph> static void require(const Graph& g, const Wanted<Graph>& goal) {
        if constexpr (std::is_same_v<Wanted<Graph>, VertexOf<Graph>>) detail::require_vertex("AStar", "goal", g, goal);
    }
    /// The goal of the next query.
    template <class Goal> void set(Goal& kept, const Goal& wanted) const { kept = wanted; }
    /// Whether nothing that is wanted is free.
    template <class Graph> static bool blocked(const Graph& g, const In<Graph>& goal) {
        if constexpr (std::is_same_v<In<Graph>, VertexOf<Graph>>) return detail::blocked(goal, g);
        else return false;
    }
    /// The heuristic for this goal.
    template <class Cost, class Heuristic, class Graph, class Earlier>
    static auto bind(const Heuristic& h, const Graph& g, const In<Graph>& goal, const Earlier*) {
        return h.template bind<Cost>(g, goal);
    }
    /// " to (3, 4)".
    template <class Graph> [[gnu::cold]] static std::string in_words(const Graph& g, const In<Graph>& goal) {
        if constexpr (std::is_same_v<In<Graph>, VertexOf<Graph>>) return " to " + detail::name_of_vertex(goal, g);
        else return "";
    }
};

/// Any of several vertices: the search ends at the one that is reached most cheaply, `path().back()`. Those that are
/// blocked are passed over; a search to none, or to one that the graph does not have, is refused.
struct AnyGoal {
    using role = roles::Goals;
    static constexpr bool has_places = true; ///< a heuristic can be bound to each
    /// The goals of a query.
    template <class Graph> using In = VertexSet<VertexOf<Graph>>;
    /// What `find` is given: an array or vector of vertices, which is copied.
    template <class Graph> using Wanted = std::span<const VertexOf<Graph>>;
    /// \throws std::invalid_argument for no goal, and for one that the graph does not have
    template <class Graph> static void require(const Graph& g, const Wanted<Graph>& goals) {
        static_assert(std::is_same_v<GoalOf<Graph>, VertexOf<Graph>>,
                      "Ansatz paths: the goals of this graph are conditions (its goal_type), which many vertices meet "
                      "already; leave AnyGoal out");
        detail::require_vertices("AStar", "goal", "the number of goals", g, goals);
    }
    /// The goals of the next query.
    template <class Vertex> void set(VertexSet<Vertex>& kept, const std::span<const Vertex>& wanted) const {
        kept.assign(wanted);
    }
    /// Whether each of them is blocked.
    template <class Graph> static bool blocked(const Graph& g, const In<Graph>& goals) {
        return std::ranges::all_of(goals.all(), [&](const auto& v) { return detail::blocked(v, g); });
    }
    /// The least of the heuristic's estimates for each.
    /// \param earlier that of the query before, whose memory is used again
    template <class Cost, class Heuristic, class Graph, class Earlier>
    static auto bind(const Heuristic& h, const Graph& g, const In<Graph>& goals, const Earlier* earlier) {
        using Bound = decltype(h.template bind<Cost>(g, std::declval<const VertexOf<Graph>&>()));
        detail::LeastEstimate<Bound> all;
        if constexpr (std::is_same_v<Earlier, detail::LeastEstimate<Bound>>)
            if (earlier && earlier->of.use_count() == 1) all.of = earlier->of; // a copy of the search keeps its own
        if (!all.of) all.of = std::make_shared<std::vector<Bound>>();
        all.of->clear();
        for (const auto& goal : goals.all()) all.of->push_back(h.template bind<Cost>(g, goal));
        return all;
    }
    /// " to any of 3 goals".
    template <class Graph> [[gnu::cold]] static std::string in_words(const Graph& g, const In<Graph>& goals) {
        if (goals.all().size() == 1) return " to " + detail::name_of_vertex(goals.all().front(), g);
        return " to any of " + std::to_string(goals.all().size()) + " goals";
    }
};

/// Any vertex that meets a condition: `AStar{map, GoalWhere{[&](Cell c) { ... }}}`, then `find(start)`.
template <class Condition> struct GoalWhere {
    using role = roles::Goals;
    static constexpr bool has_places = false; ///< it is unknown where it holds
    /// Nothing more: the policy has the condition.
    struct Nothing {};
    /// The condition.
    template <class Graph> using In = Meets<Condition>;
    /// What `find` is given.
    template <class Graph> using Wanted = Nothing;
    std::shared_ptr<const Condition> condition; ///< of a vertex: true where the search may end
    /// The goal is where this holds.
    explicit GoalWhere(Condition c) : condition(std::make_shared<const Condition>(std::move(c))) {}
    /// Nothing that could be wrong.
    template <class Graph> static void require(const Graph&, const Nothing&) {
        static_assert(std::is_invocable_r_v<bool, const Condition&, const VertexOf<Graph>&>,
                      "Ansatz paths: GoalWhere takes a function of a vertex of this graph that answers true where the "
                      "search may end, e.g. GoalWhere{[&](Cell c) { return c.x == 0; }}");
    }
    /// The goal of the next query.
    void set(Meets<Condition>& kept, const Nothing&) const { kept.condition = condition; }
    /// Never: where it holds is not known.
    template <class Graph> static bool blocked(const Graph&, const Meets<Condition>&) { return false; }
    /// A heuristic that asks for no goal.
    template <class Cost, class Heuristic, class Graph, class Earlier>
    static auto bind(const Heuristic& h, const Graph& g, const Meets<Condition>&, const Earlier*) {
        static_assert(detail::asks_for_no_goal<Heuristic, VertexOf<Graph>>,
                      "Ansatz paths: a goal that is a condition is at no place that this heuristic could estimate the "
                      "way to; leave the heuristic out, or write By{[](auto v) { return 0.0; }} of the vertex alone");
        return h.template bind<Cost>(g, VertexOf<Graph>{});
    }
    /// " to a node that meets the condition".
    template <class Graph> [[gnu::cold]] static std::string in_words(const Graph&, const Meets<Condition>&) {
        return " to a node that meets the condition";
    }
};
/// `GoalWhere{function}` holds this function.
template <class Condition> GoalWhere(Condition) -> GoalWhere<Condition>;

} // namespace ansatz::paths
