// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a search keeps while it runs, for the engines: graph, weights, nodes, open list, estimate and counters. `AStar`
/// owns one; write against it only if you write an engine.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/nodes.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/units/describe.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// What a search knows.
/// \tparam Graph_    the graph, which is read and never copied
/// \tparam Estimate  what the heuristic became when it was bound to a goal: estimate(v) is h
/// \tparam Goal_     what is to be reached: a vertex, or what is_reached(v, goal) is asked of
template <class Graph_, class Cost_, class Queue_, class Reopens_, class Successors_, class Given, class Index,
          class Estimate_, class Goal_ = GoalOf<Graph_>>
struct Search {
    using Graph = Graph_;           ///< what is searched
    using Cost = Cost_;             ///< the number it counts in
    using Queue = Queue_;           ///< the open list
    using Reopens = Reopens_;       ///< what becomes of closed nodes: Reopening or another
    using Successors = Successors_; ///< which nodes are visited from a node: EveryEdge or another
    using Estimate = Estimate_;     ///< the heuristic, bound to a goal
    using Vertex = VertexOf<Graph>; ///< a vertex of the graph
    using Goal = Goal_;             ///< where it may end: a vertex, a set or a condition
    /// The number of its estimates, and of f: that of the costs, or a wider one (`Weighted`).
    using Guess = detail::Guess<Cost, std::decay_t<std::invoke_result_t<const Estimate&, const Vertex&>>>;
    /// The property map of the weights.
    using Weights = std::decay_t<decltype(detail::weights_of<Graph, Cost>(std::declval<const Graph&>(),
                                                                          std::declval<const Given&>()))>;
    /// What a weight is.
    using Weight = std::decay_t<decltype(get(std::declval<const Weights&>(), std::declval<const EdgeOf<Graph>&>()))>;
    /// Whether the vertices have numbers; else they are hashed.
    static constexpr bool numbered = !std::is_same_v<Index, detail::NotGiven> || detail::IsNumbered<Graph>;
    /// The nodes of the vertices: an array or a hash table.
    using Nodes = std::conditional_t<numbered, detail::NumberedNodes<Vertex, Cost, Guess>,
                                     detail::HashedNodes<Vertex, Cost, Guess>>;

    /// The map that numbers the vertices; where they are hashed there is none.
    static auto index_map_of(const Graph& g, const Index& i) {
        if constexpr (!std::is_same_v<Index, detail::NotGiven>) return i.map;
        else if constexpr (numbered) return detail::index_of(g);
        else return detail::NotGiven{};
    }
    /// The type of that map.
    using IndexMap = decltype(index_map_of(std::declval<const Graph&>(), std::declval<const Index&>()));
    /// The map of this search.
    auto index_map() const { return index_map_of(*graph_, index_); }

    /// Refers to the graph, which must live as long; copies the others.
    Search(const Graph& g, Queue q, const Given& given, const Index& i)
        : queue(std::move(q)),
          graph_(&g),
          given_(given),
          index_(i),
          weights_(detail::weights_of<Graph, Cost>(g, given)) {}

    /// The graph that is searched.
    const Graph& graph() const { return *graph_; }
    /// Where this vertex' node is kept.
    [[gnu::always_inline]] auto slot(const Vertex& v) {
        if constexpr (numbered) return std::size_t(get(index_map(), v));
        else return nodes.slot_of(v);
    }
    /// Where the nodes are, by value: for the loop, which asks for little else.
    struct NumberedPlace {
        typename Nodes::Record* records; ///< all nodes, by number
        IndexMap index;                  ///< numbers the vertices
        /// The node of a vertex.
        [[gnu::always_inline]] auto& of(const Vertex& v) const { return records[std::size_t(get(index, v))]; }
        /// Has the nodes of a vertex' neighbours brought near, for it will be expanded next.
        [[gnu::always_inline]] void fetch_around(const Vertex& v, const Graph& g) const {
            if constexpr (requires { g.index_offsets(); }) {
                const auto at = reinterpret_cast<std::uintptr_t>(records) +
                                std::size_t(get(index, v)) * sizeof(typename Nodes::Record);
                const auto row = std::size_t(g.index_offsets()[1]) * sizeof(typename Nodes::Record);
                // NOLINTNEXTLINE(performance-no-int-to-ptr)
                __builtin_prefetch(reinterpret_cast<const void*>(at - row)); // an address beyond the array does no harm
                // NOLINTNEXTLINE(performance-no-int-to-ptr)
                __builtin_prefetch(reinterpret_cast<const void*>(at + row));
            }
        }
        /// The node of the vertex that an edge leads to.
        template <class Edge> [[gnu::always_inline]] auto& of_target(const Edge& e, const Vertex& v) const {
            if constexpr (requires {
                              { target_index(e, index) } -> std::convertible_to<std::size_t>;
                          })
                return records[target_index(e, index)]; // the graph has it at hand
            else return of(v);
        }
    };
    /// The same where the vertices are hashed.
    struct HashedPlace {
        Nodes* nodes; ///< the hash table
        /// The node of a vertex; makes it where there is none.
        [[gnu::always_inline]] auto& of(const Vertex& v) const { return (*nodes)[nodes->slot_of(v)]; }
        /// The node of the vertex that an edge leads to.
        template <class Edge> [[gnu::always_inline]] auto& of_target(const Edge&, const Vertex& v) const {
            return of(v);
        }
        /// Nothing: where they lie only the hash tells.
        void fetch_around(const Vertex&, const Graph&) const {}
    };
    /// Which of the two this search has.
    using Place = std::conditional_t<numbered, NumberedPlace, HashedPlace>;
    /// Where the nodes are now; holds until there are more.
    Place place() {
        if constexpr (numbered) return {&nodes[0], index_map()};
        else return {&nodes};
    }
    /// The heuristic, bound to the goal of this query.
    const Estimate& bound() const { return *estimate_; }
    /// The weights as they were when the query began.
    const Weights& weights() const { return weights_->map; }
    /// The weights, asked of the graph anew.
    Weights fresh_weights() const { return detail::weights_of<Graph, Cost>(*graph_, given_); }
    /// The node of a vertex that this query has come to, else null.
    const typename Nodes::Record* seen(const Vertex& v) const {
        const typename Nodes::Record* at = nullptr;
        if constexpr (numbered) {
            const std::size_t i = const_cast<Search*>(this)->slot(v); // looks a number up, changes nothing
            if (i < nodes.size()) at = &nodes[i];
        } else if (const auto i = nodes.find(v); i != Nodes::none) at = &nodes[i];
        return at && (at->stamp == nodes.stamps().open() || at->stamp == nodes.stamps().closed()) ? at : nullptr;
    }
    /// Every vertex that may have a node: use(vertex).
    template <class Use> void each_vertex(Use&& use) const {
        if constexpr (numbered) {
            const auto all = vertices(*graph_);
            for (auto at = all.first; at != all.second; ++at) use(Vertex(*at));
        } else nodes.each(use);
    }
    /// Makes room for vertices that the graph has got since.
    void grow() { nodes.grow(count()); }
    std::size_t count() const { ///< of the vertices, where they are numbered
        if constexpr (!std::is_same_v<Index, detail::NotGiven>) return index_.count;
        else if constexpr (numbered) return std::size_t(num_vertices(*graph_));
        else return 0;
    }
    /// h of a vertex.
    [[gnu::always_inline]] Guess estimate(const Vertex& v) const { return Guess((*estimate_)(v)); }
    /// That of the query before, or null: the next may use its memory again.
    const Estimate* earlier() const { return estimate_ ? &*estimate_ : nullptr; }
    /// Takes the heuristic for the goal of this query.
    void bind(Estimate e) { estimate_.emplace(std::move(e)); }
    /// Whether a vertex is the goal that is wanted, or meets it.
    [[gnu::always_inline]] static bool reaches(const Vertex& v, const Goal& wanted) {
        if constexpr (std::is_same_v<Goal, Vertex>) return v == wanted;
        else return is_reached(v, wanted);
    }
    /// Whether a vertex is the goal of this query, or meets it.
    bool is_goal(const Vertex& v) const { return reaches(v, goal); }
    /// A weight in the number of the search, no more than the dearest cost there is.
    template <class Weight> [[gnu::always_inline]] static Cost cost_of(const Weight& weight) {
        return detail::cost_of<Cost>(weight);
    }

    /// Forgets the last query and sets out for another, to the goal as it is now.
    /// \param from one start at least
    void begin(std::span<const Vertex> from) {
        weights_.emplace(fresh_weights()); // not assigned: a map that holds a lambda cannot be
        nodes.begin(count());
        queue.begin(*graph_);
        starts.assign(from.begin(), from.end());
        start = starts.front();
        goal_known = too_far = false;
        goal_cost = detail::infinite<Cost>, nearest_h = detail::infinite<Guess>;
        nearest = goal_vertex = start;
        expanded = reopened = generated = 0;
    }
    /// 1: the start nodes on the open list: opened(vertex, node) for each.
    template <class Opened> void open_starts(Opened&& opened) {
        std::size_t least = 0; // the queue begins with the least f
        for (std::size_t i = 1; i < starts.size(); ++i)
            if (estimate(starts[i]) < estimate(starts[least])) least = i;
        std::swap(starts[0], starts[least]);
        start = nearest = goal_vertex = starts[0];
        for (const Vertex& v : starts) {
            auto& node = nodes[slot(v)];
            if (node.stamp == nodes.stamps().open()) continue; // it was given twice
            node.g = Cost(0), node.h = estimate(v), node.parent = v, node.stamp = nodes.stamps().open();
            if (generated++ == 0) queue.start(node.h, node.h, v);
            else queue.push(node.h, node.h, v);
            opened(v, node);
        }
    }
    /// The goal can be had at this cost; kept if it is the first such, or cheaper.
    void reach(const Vertex& v, Cost g) {
        if (goal_known && !(g < goal_cost)) return;
        goal_known = true, goal_vertex = v, goal_cost = g;
    }
    /// Notes which edge has a weight that is negative or not a number.
    template <class Weight>
    [[gnu::cold, gnu::noinline]] void refuse_weight(const Vertex& p, const Vertex& q, const Weight& weight) {
        trouble = Outcome::bad_weight, bad_from = p, bad_to = q, bad_value = double(weight);
    }

    Nodes nodes;                ///< of this query, and of earlier ones with their old stamps
    Queue queue;                ///< the open list
    std::vector<Vertex> starts; ///< where the query begins, blocked ones left out
    Vertex start{},             ///< the first of them
        goal_vertex{},          ///< where it reached the goal
        nearest{},              ///< closed, with the least h
        bad_from{},             ///< where the edge of the refused weight begins
        bad_to{};               ///< where it ends
    Goal goal{};                ///< of this query
    /// The goal's g so far.
    Cost goal_cost{};
    Guess nearest_h{};    ///< h of `nearest`
    double bad_value = 0; ///< the weight that was refused
    /// Whether the goal has been reached.
    bool goal_known = false, too_far = false; ///< whether a cost was more than its number holds
    Outcome trouble = Outcome::bad_weight;    ///< what the query ends with after refuse_weight
    std::size_t expanded = 0,                 ///< nodes whose neighbours were visited
        generated = 0,                        ///< nodes that were ever on the open list
        reopened = 0;                         ///< how often a closed node was reached on a cheaper way

private:
    const Graph* graph_;
    Given given_;
    Index index_;
    /// Whether Boost's map of a lambda has a default must not be asked: in clang that is an error.
    struct Kept {
        Weights map;
        explicit Kept(Weights w) : map(std::move(w)) {}
    };
    std::optional<Kept> weights_;      ///< as they were when the query began
    std::optional<Estimate> estimate_; ///< bound to the goal of this query
};

} // namespace ansatz::paths
