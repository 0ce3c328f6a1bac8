// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `AStar`: the cheapest path from a start to a goal, over any graph of Boost.Graph (notes 6.1).
///
/// ```
/// Grid map(64, 64);
/// AStar search{map, Octile{}, Buckets{}};                  // policies in any order; all but the graph have defaults
/// if (search.find(Cell{1, 1}, Cell{60, 40}) == Outcome::found)
///     for (Cell c : search.path()) walk_to(map.position(c));
/// ```
///
/// | role       | policies                                   | default                                             |
/// |------------|--------------------------------------------|-----------------------------------------------------|
/// | Heuristic  | heuristics.hpp                             | the graph's `default_heuristic`, else ZeroHeuristic |
/// | Queue      | `Heap`, `Buckets`                          | `Heap`                                              |
/// | Cost       | `CostIn<Number>`                           | the graph's `default_cost`, else its weights' type  |
/// | Reopening  | `Reopening`, `NoReopening`, `UpdateClosed` | `Reopening`                                         |
/// | Successors | `EveryEdge`, on grids `JumpPoints`         | `EveryEdge`                                         |
/// | Goals      | `OneGoal`, `AnyGoal`, `GoalWhere{...}`     | `OneGoal`                                           |
/// | Engine     | `OwnLoop`, `BoostAStar`, `LazyTheta`       | `OwnLoop`                                           |
/// | Weights    | `WeightsOf{map}`, `UnitWeights`            | the graph's own, else 1 for every edge              |
/// | Index      | `IndexOf{map, count}`                      | the graph's own, else vertices are hashed           |
///
/// %Keep the object: its arrays are stamped and not cleared, so that the next query costs only what it visits, and
/// allocates nothing once they have grown. It reads the graph and does not copy it; a change of the graph counts
/// from the next `begin` or `find` on. A copy of a search is a search of its own.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/heap.hpp>
#include <ansatz/paths/heuristics/zero.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/own_loop.hpp>
#include <ansatz/paths/reopening.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/search.hpp>
#include <ansatz/paths/successors.hpp>
#include <ansatz/paths/visitor.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

namespace detail {
template <class Graph> struct DefaultHeuristic {
    using type = ZeroHeuristic;
};
template <class Graph>
    requires requires { typename Graph::default_heuristic; }
struct DefaultHeuristic<Graph> {
    using type = typename Graph::default_heuristic;
};

/// Whether a policy that brings weights brings a property map of this graph's edges.
template <class Graph, class Policy> inline constexpr bool brings_weights = true;
template <class Graph, class Map>
inline constexpr bool brings_weights<Graph, WeightsOf<Map>> =
    requires(const Map& map, const EdgeOf<Graph>& e) { get(map, e); };

/// What is wrong with a list of policies, in sentences. One assert a rule.
template <class Graph, class... Policies> struct CheckedPolicies {
    static_assert(SearchGraph<Graph>,
                  "Ansatz paths: AStar searches a graph of Boost.Graph: out_edges(v, g) and target(e, g) "
                  "must work on it, and boost::graph_traits know its vertices and edges");
    static_assert(
        (has_known_role<Policies> && ...),
        "Ansatz paths: AStar was given something that is no policy of a search; after the graph it takes a "
        "heuristic (Octile{}), a queue (Heap{}, Buckets{}), CostIn<Number>{}, Reopening{}, an engine, WeightsOf{map} "
        "or IndexOf{map, count}, in any order");
    static_assert(count_of<roles::Heuristic, Policies...> <= 1,
                  "Ansatz paths: AStar has two heuristics; for the larger of both write Maximum{Octile{}, Euclid{}}");
    static_assert(count_of<roles::Queue, Policies...> <= 1, "Ansatz paths: AStar has two queues; leave one out");
    static_assert(count_of<roles::Cost, Policies...> <= 1, "Ansatz paths: AStar has two costs; leave one CostIn out");
    static_assert(count_of<roles::Reopening, Policies...> <= 1,
                  "Ansatz paths: AStar is told twice what to do with closed nodes; leave one out");
    static_assert(count_of<roles::Engine, Policies...> <= 1, "Ansatz paths: AStar has two engines; leave one out");
    static_assert(count_of<roles::Successors, Policies...> <= 1,
                  "Ansatz paths: AStar has two policies of successors; leave one out");
    static_assert(count_of<roles::Weights, Policies...> <= 1,
                  "Ansatz paths: AStar has two maps of weights; leave one out");
    static_assert(count_of<roles::Index, Policies...> <= 1, "Ansatz paths: AStar has two index maps; leave one out");
    static_assert(count_of<roles::Goals, Policies...> <= 1,
                  "Ansatz paths: AStar is told twice what its goal is; leave AnyGoal or GoalWhere out");
    static_assert((brings_weights<Graph, Policies> && ...),
                  "Ansatz paths: WeightsOf takes a property map of the graph's edges: WeightsOf{get(&Road::length, "
                  "graph)}, or of a function WeightsOf{boost::make_function_property_map<Edge>(function)}");
    static constexpr bool ok = true;
};
} // namespace detail

/// The cheapest path; see the file's description.
template <class Graph, class... Policies> class AStar {
    static_assert(detail::CheckedPolicies<Graph, Policies...>::ok);
    using Given = detail::pick<roles::Weights, detail::NotGiven, Policies...>;
    using Index = detail::pick<roles::Index, detail::NotGiven, Policies...>;
    static_assert(detail::AsksForWeights<Graph, Given>::ok);
    using Engine = detail::pick<roles::Engine, OwnLoop, Policies...>;
    using Natural =
        CostIn<typename detail::CostOfEngine<Engine, typename detail::NaturalCost<Graph, Given>::type>::type>;
    using Goals = detail::pick<roles::Goals, OneGoal, Policies...>;
    using OnGraph = typename detail::HeuristicOfEngine<Engine, typename detail::DefaultHeuristic<Graph>::type>::type;
    using DefaultEstimate = std::conditional_t<Goals::has_places, OnGraph, ZeroHeuristic>;
    using Heuristic = detail::pick<roles::Heuristic, DefaultEstimate, Policies...>;
    using QueuePolicy = detail::pick<roles::Queue, Heap, Policies...>;
    using Reopens = detail::pick<roles::Reopening, Reopening, Policies...>;
    static_assert(detail::admits<Engine, Heuristic>,
                  "Ansatz paths: Octile and Manhattan count steps, which is too much for an engine that walks straight "
                  "between tiles; leave the heuristic out, or take Euclid{}");
    using Leaps = detail::pick<roles::Successors, EveryEdge, Policies...>;
    static constexpr bool leaps =
        !std::is_same_v<Leaps, EveryEdge> && LeapsOn<Leaps, Graph, VertexOf<Graph>, EdgeOf<Graph>>;
    static_assert(
        leaps || std::is_same_v<Leaps, EveryEdge>,
        "Ansatz paths: AStar was given successors that it cannot find on this graph; JumpPoints need a grid of "
        "eight directions on even ground, Grid<Eight<...>, Even>; elsewhere leave them out");
    static_assert(
        [] {
            if constexpr (requires { Heuristic::knows_weights; })
                return Heuristic::knows_weights || std::is_same_v<Given, detail::NotGiven>;
            else return true;
        }(),
        "Ansatz paths: Checked would judge by the graph's own weights, and the search goes by others; give it the "
        "same, "
        "Checked{heuristic, report, WeightsOf{map}}");
    static_assert(
        !leaps || std::is_same_v<Given, detail::NotGiven>,
        "Ansatz paths: AStar with JumpPoints cannot have WeightsOf: they count on every step costing the same");
    using Successors = std::conditional_t<leaps, Leaps, EveryEdge>; // so that one sentence is said and no more
    static_assert(detail::IsNumbered<Graph> || !std::is_same_v<Index, detail::NotGiven> ||
                      detail::IsHashed<VertexOf<Graph>>,
                  "Ansatz paths: the vertices of this graph have no numbers; give them a vertex_index, or write "
                  "AStar{graph, ..., IndexOf{map, count}}, or specialise std::hash for them");

public:
    using Vertex = VertexOf<Graph>; ///< a vertex of the graph
    /// Where it may end: a vertex, several, or a condition.
    using Goal = typename Goals::template In<Graph>;
    /// What `find` is given: a vertex, or with `AnyGoal` an array of them.
    using Wanted = typename Goals::template Wanted<Graph>;
    /// The number it counts in.
    using Cost = typename detail::pick<roles::Cost, Natural, Policies...>::type;
    /// The heuristic, bound to a goal.
    using Estimate = decltype(Goals::template bind<Cost>(std::declval<const Heuristic&>(), std::declval<const Graph&>(),
                                                         std::declval<const Goal&>(), std::declval<const int*>()));
    /// The number of h and f: that of the costs, or a wider one where estimates may be more than any cost (`Weighted`).
    using Guess = detail::Guess<Cost, std::decay_t<std::invoke_result_t<const Estimate&, const Vertex&>>>;
    /// The open list.
    using Queue = typename QueuePolicy::template In<Guess, Vertex>;
    using NodeOf = Node<Vertex, Cost, Guess>; ///< f, g, h and parent of a vertex
    /// What it keeps while it runs.
    using Work = Search<Graph, Cost, Queue, Reopens, Successors, Given, Index, Estimate, Goal>;
    static_assert(
        Queue::exact || Reopens::reopens,
        "Ansatz paths: Buckets are in order only to a bucket's width, and need Reopening; with NoReopening or "
        "UpdateClosed take Heap");
    static_assert(
        !std::is_integral_v<Cost> || std::is_integral_v<typename Work::Weight>,
        "Ansatz paths: the weights of this graph have fractions, which a whole-number cost would cut off, and then "
        "heuristics are too much; take CostIn<double>");
    /// As many expansions as it takes.
    static constexpr std::size_t without_end = std::numeric_limits<std::size_t>::max();

    /// \param graph read, never copied: it must live as long as this
    explicit AStar(const Graph& graph, Policies... policies)
        : heuristic_(detail::take<roles::Heuristic, DefaultEstimate>(policies...)),
          goals_(detail::take<roles::Goals, OneGoal>(policies...)),
          search_(graph, Queue(detail::take<roles::Queue, Heap>(policies...)),
                  detail::take<roles::Weights, detail::NotGiven>(policies...),
                  detail::take<roles::Index, detail::NotGiven>(policies...)) {}
    explicit AStar(const Graph&&, Policies...) = delete; // a graph that is gone after this line

    /// Finds the path in one go.
    /// \param goal    a vertex; with `AnyGoal` an array or vector of them
    /// \param most    how many nodes may be expanded before it gives up
    /// \param visitor watches (visitor.hpp)
    /// \throws std::invalid_argument for a start or goal that the graph does not have, for none of them, and for a
    ///         graph on which the policy of successors would be wrong; never later
    template <class Watcher> Outcome find(const Vertex& start, const Wanted& goal, std::size_t most, Watcher& visitor) {
        begin(start, goal, visitor);
        return run(most, visitor);
    }
    /// The same without a visitor.
    Outcome find(const Vertex& start, const Wanted& goal, std::size_t most = without_end) {
        Visitor nobody;
        return find(start, goal, most, nobody);
    }
    /// The cheapest path from any of several starts: an array or vector of vertices. `path().front()` is the one that
    /// it begins at; those that are blocked are passed over.
    template <class Watcher>
    Outcome find(std::span<const Vertex> starts, const Wanted& goal, std::size_t most, Watcher& visitor) {
        begin(starts, goal, visitor);
        return run(most, visitor);
    }
    /// The same without a visitor.
    Outcome find(std::span<const Vertex> starts, const Wanted& goal, std::size_t most = without_end) {
        Visitor nobody;
        return find(starts, goal, most, nobody);
    }
    /// To where the condition of `GoalWhere` holds.
    Outcome find(const Vertex& start)
        requires(!Goals::has_places)
    {
        return find(start, Wanted{});
    }

    /// \name A search in slices: so many expansions a frame
    /// @{
    template <class Watcher> void begin(const Vertex& start, const Wanted& goal, Watcher& visitor) {
        begin_from(std::span<const Vertex>(&start, 1), goal, visitor);
    }
    void begin(const Vertex& start, const Wanted& goal) {
        Visitor nobody;
        begin(start, goal, nobody);
    }
    template <class Watcher> void begin(std::span<const Vertex> starts, const Wanted& goal, Watcher& visitor) {
        static_assert(
            requires { requires Engine::several_starts; },
            "Ansatz paths: this engine searches from one start; for several take OwnLoop, the default, or search "
            "backwards with AnyGoal");
        begin_from(starts, goal, visitor);
    }
    void begin(std::span<const Vertex> starts, const Wanted& goal) {
        Visitor nobody;
        begin(starts, goal, nobody);
    }
    /// Expands up to so many nodes and says how the search stands then. Does nothing when it is not running.
    template <class Watcher> Outcome advance(std::size_t expansions, Watcher& visitor) {
        if (outcome_ != Outcome::running) return outcome_;
        search_.grow(); // the graph may have
        outcome_ = Engine::run(search_, expansions, visitor);
        if (outcome_ == Outcome::found) trace(search_.goal_vertex);
        return outcome_;
    }
    Outcome advance(std::size_t expansions) {
        Visitor nobody;
        return advance(expansions, nobody);
    }
    /// Ends a running search with what it has: path() leads to the node that came nearest to the goal.
    void give_up() {
        if (outcome_ != Outcome::running) return;
        outcome_ = Outcome::gave_up;
        trace(search_.nearest);
    }
    /// @}

    /// \name What came of it
    /// @{
    Outcome outcome() const { return outcome_; }
    /// From start to goal, both included; empty where there is none. Valid until the next query.
    std::span<const Vertex> path() const { return path_; }
    Cost cost() const { ///< g of the path's last node; the dearest cost there is where there is no path
        const auto* last = path_.empty() ? nullptr : node(path_.back());
        return last ? last->g : detail::infinite<Cost>;
    }
    std::size_t expanded() const { return search_.expanded; }   ///< nodes whose neighbours were visited
    std::size_t generated() const { return search_.generated; } ///< nodes that were ever on the open list
    std::size_t reopened() const { return search_.reopened; } ///< how often a closed node was reached on a cheaper way
    /// The outcome in a sentence, with the place.
    std::string why() const;
    /// @}

    /// \name The notes' lists and values
    /// @{
    /// f, g, h and parent of a node; null if this query has not come to it.
    const NodeOf* node(const Vertex& v) const { return search_.seen(v); }
    bool is_open(const Vertex& v) const { return has_stamp(v, search_.nodes.stamps().open()); }
    bool is_closed(const Vertex& v) const { return has_stamp(v, search_.nodes.stamps().closed()); }
    /// The open list by ascending f, of equal f by h. For inspection: it is made anew by each call.
    std::vector<Vertex> open_list() const;
    /// The closed list, in the order of the graph's vertices; in which order they were closed a `Trace` tells.
    std::vector<Vertex> closed_list() const;
    /// @}

    const Goal& goal() const { return search_.goal; } ///< of this query
    /// The graph that is searched.
    const Graph& graph() const { return search_.graph(); }
    /// What an edge costs a search, in its number.
    Cost weight(const EdgeOf<Graph>& e) const { return search_.cost_of(get(search_.fresh_weights(), e)); }
    auto& internals() { return search_; } ///< for tests and engines

private:
    template <class Watcher> Outcome run(std::size_t most, Watcher& visitor) {
        advance(most, visitor);
        if (outcome_ == Outcome::running) give_up();
        return outcome_;
    }
    template <class Watcher> void begin_from(std::span<const Vertex> starts, const Wanted& goal, Watcher& visitor) {
        const Graph& g = search_.graph();
        detail::require_vertices("AStar", "start", "the number of starts", g, starts);
        goals_.require(g, goal);
        if constexpr (leaps) Successors::require(g);
        goals_.set(search_.goal, goal);
        search_.begin(starts);
        path_.clear(); // not sooner: starts and goal may be of it
        if (starts.size() > 1 || detail::blocked(search_.start, g))
            std::erase_if(search_.starts, [&](const Vertex& v) { return detail::blocked(v, g); });
        if (search_.starts.empty() || goals_.blocked(g, search_.goal)) {
            outcome_ = Outcome::blocked;
            return;
        }
        search_.bind(goals_.template bind<Cost>(heuristic_, g, search_.goal, search_.earlier()));
        search_.open_starts([&](const Vertex& v, const NodeOf& node) { visitor.opened(v, node); });
        outcome_ = Outcome::running;
    }
    bool has_stamp(const Vertex& v, std::uint32_t stamp) const {
        const auto* n = node(v);
        return n && n->stamp == stamp;
    }
    /// 4: by the parents back to the start, then turned round.
    void trace(Vertex v) {
        path_.clear();
        for (;;) {
            path_.push_back(v);
            const Vertex parent = search_.nodes[search_.slot(v)].parent;
            if (v == parent) break; // a start
            if constexpr (leaps)
                Successors::between(parent, v, [&](const Vertex& on_the_way) { path_.push_back(on_the_way); });
            v = parent;
        }
        std::reverse(path_.begin(), path_.end());
    }
    Heuristic heuristic_;
    [[no_unique_address]] Goals goals_;
    Work search_;
    std::vector<Vertex> path_;
    Outcome outcome_ = Outcome::not_begun;
};
/// The search of a graph by these policies, `AStar{graph, Octile{}}`.
template <class Graph, class... Policies> AStar(const Graph&, Policies...) -> AStar<Graph, Policies...>;

template <class Graph, class... Policies> [[gnu::cold]] std::string AStar<Graph, Policies...>::why() const {
    if (outcome_ == Outcome::not_begun) return "no search was begun"; // there is no vertex yet that has a name
    const Graph& g = search_.graph();
    auto name = [&](const Vertex& v) { return detail::name_of_vertex(v, g); };
    const std::size_t starts = search_.starts.size();
    std::string way = starts > 1 ? "from any of " + std::to_string(starts) + " starts" : "from " + name(search_.start);
    way += goals_.in_words(g, search_.goal);
    switch (outcome_) {
    case Outcome::not_begun: break;
    case Outcome::running: return "the search " + way + " goes on after " + std::to_string(expanded()) + " expansions";
    case Outcome::found:
        if constexpr (!std::is_same_v<Goals, OneGoal>)
            way = "from " + name(path_.front()) + " to " + name(path_.back());
        return "the path " + way + " costs " + detail::name_of_cost(cost(), g);
    case Outcome::no_path:
        return "there is no path " + way + ": all " + std::to_string(expanded()) +
               " nodes that can be reached were expanded";
    case Outcome::gave_up:
        return "the search " + way + " gave up after " + std::to_string(expanded()) + " expansions; nearest came " +
               name(search_.nearest);
    case Outcome::blocked:
        if (starts == 0) return "there is no path " + way + ": the start is blocked";
        return "there is no path " + way + ": the goal is blocked";
    case Outcome::too_far:
        return "no path " + way +
               " was found whose cost its number holds, and there were ways that cost more; take CostIn<std::uint64_t> "
               "or CostIn<double>";
    case Outcome::bad_weight:
        return "the edge from " + name(search_.bad_from) + " to " + name(search_.bad_to) + " weighs " +
               describe(search_.bad_value) + "; a weight is a number and not negative";
    }
    return "";
}

template <class Graph, class... Policies> auto AStar<Graph, Policies...>::open_list() const -> std::vector<Vertex> {
    std::vector<Vertex> open;
    search_.queue.each([&](const Vertex& v) {
        if (is_open(v)) open.push_back(v);
    });
    std::stable_sort(open.begin(), open.end(), [&](const Vertex& a, const Vertex& b) {
        const auto &m = *node(a), &n = *node(b);
        return m.f() < n.f() || (m.f() == n.f() && m.h < n.h);
    });
    // A node stands in the queue as often as its f fell; equal ones need not be neighbours.
    std::vector<Vertex> once;
    for (const Vertex& v : open)
        if (std::find(once.begin(), once.end(), v) == once.end()) once.push_back(v);
    return once;
}

template <class Graph, class... Policies> auto AStar<Graph, Policies...>::closed_list() const -> std::vector<Vertex> {
    std::vector<Vertex> closed;
    search_.each_vertex([&](const Vertex& v) {
        if (is_closed(v)) closed.push_back(v);
    });
    return closed;
}

} // namespace ansatz::paths
