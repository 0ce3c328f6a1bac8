// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `FlowField`: one search backwards from the goal that tells every vertex its cost and the next step; for groups whose
/// members go to one place from many (notes 6.3).
///
/// ```
/// FlowField field{map, Buckets{}};
/// field.aim(gate);                                        // or any of several goals
/// for (Walker& w : horde) w.head_for(field.next(w.cell)); // no search, and no list of members
/// ```
///
/// Take it where many walkers go to one goal, or to the nearest of several: it costs one search of all that can reach
/// the goal, and then a table lookup for each. For a few walkers on a large map single searches are cheaper, since
/// they expand less (\ref section_6_3_7 "6.3.7" has the number). Members of a squad who keep their places need one
/// path and a `Formation`.
///
/// It reads the graph and does not copy it. After a change of the graph aim again: `is_current()` tells, on graphs
/// that count their changes. On a Grid nothing is allocated once warm; on other graphs the roads are turned round each
/// time, since a graph that knows where its edges lead does not know where they come from.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/paths/heap.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/units/quantity.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

namespace detail {

/// The passable edges of a graph by the vertex that they lead to.
template <class Graph, class Cost> class EdgesInto {
public:
    /// \throws std::invalid_argument for a weight that is negative or no number
    template <class Given> void read(const Graph& g, const Given& given) {
        const auto index = index_of(g);
        std::vector<std::size_t> first(num_vertices(g) + 1);
        each(g, given, [&](const auto&, const auto& q, Cost) { ++first[std::size_t(get(index, q)) + 1]; });
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        std::vector<Half> halves(first.back());
        auto next = first;
        each(g, given, [&](const auto& p, const auto& q, Cost weight) {
            halves[next[std::size_t(get(index, q))]++] = {p, weight};
        });
        first_.swap(first), halves_.swap(halves);
    }
    /// Every edge into a vertex: use(from, weight).
    template <class Use> void into(const Graph& g, const VertexOf<Graph>& v, Use&& use) const {
        const auto i = std::size_t(get(index_of(g), v));
        for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) use(halves_[k].from, halves_[k].weight);
    }

private:
    struct Half {
        VertexOf<Graph> from;
        Cost weight;
    };
    template <class Given, class Use> static void each(const Graph& g, const Given& given, Use&& use) {
        const auto weights = weights_of<Graph, Cost>(g, given);
        const auto all = vertices(g);
        for (auto at = all.first; at != all.second; ++at) {
            const VertexOf<Graph> p = *at;
            if (blocked(p, g)) continue;
            const auto edges = out_edges(p, g);
            for (auto e = edges.first; e != edges.second; ++e) {
                const VertexOf<Graph> q = target(*e, g);
                if (!edge_passable(*e, g) || blocked(q, g)) continue;
                const auto weight = get(weights, *e);
                if (!(weight >= decltype(weight)(0)))
                    refuse_value("FlowField",
                                 "the weight of the edge from " + name_of_vertex(p, g) + " to " + name_of_vertex(q, g),
                                 describe(double(weight)), "a weight is a number and not negative");
                use(p, q, cost_of<Cost>(weight));
            }
        }
    }
    std::vector<std::size_t> first_;
    std::vector<Half> halves_;
};

/// A grid, whose steps back are found as they are asked for.
template <class Graph>
concept HasTiles = requires(const Graph& g) {
    g.open_directions();
    g.index_offsets();
    g.width();
};
template <class Graph, class Cost> class StepsInto {
public:
    template <class Given> void read(const Graph&, const Given&) {}
    /// Every step onto a tile: use(from, weight).
    template <class Use> void into(const Graph& g, Cell c, Use&& use) const {
        const auto weights = g.template weights<Cost>();
        const auto i = std::uint32_t(g.index(c));
        const Cost weight[2]{weights.of(i, false), weights.of(i, true)}; // that of the tile which is entered
        for (unsigned d = 0; d < 8; ++d) {
            const int x = int(c.x) - direction_x[d], y = int(c.y) - direction_y[d];
            if (x < 0 || y < 0 || x >= int(g.width()) || y >= int(g.height())) continue;
            const std::size_t from = std::size_t(std::ptrdiff_t(i) - g.index_offsets()[d]);
            if ((g.open_directions()[from] >> d & 1) != 0)
                use(Cell{std::uint16_t(x), std::uint16_t(y)}, weight[d >= 4 ? 1 : 0]);
        }
    }
};

} // namespace detail

/// The way to a goal from everywhere; see the file's description.
/// \tparam Graph    a VertexListGraph whose vertices are numbered
/// \tparam Policies a queue (`Heap`, `Buckets`), `CostIn<Number>`, `WeightsOf{map}`, in any order
template <class Graph, class... Policies> class FlowField {
    using Given = detail::pick<roles::Weights, detail::NotGiven, Policies...>;
    static_assert(((HasRole<Policies, roles::Queue> || HasRole<Policies, roles::Cost> ||
                    HasRole<Policies, roles::Weights>)&&...),
                  "Ansatz paths: FlowField takes a queue (Heap{}, Buckets{}), CostIn<Number>{} and WeightsOf{map}; it "
                  "visits the whole graph, and has no use for a heuristic");
    static_assert(detail::AsksForWeights<Graph, Given>::ok);
    static_assert(detail::IsNumbered<Graph>,
                  "Ansatz paths: FlowField needs a graph whose vertices are numbered and listed");
    using Natural = CostIn<typename detail::NaturalCost<Graph, Given>::type>;
    using QueuePolicy = detail::pick<roles::Queue, Heap, Policies...>;

public:
    using Vertex = VertexOf<Graph>; ///< a vertex of the graph
    /// The number it counts in: on a Grid whole, 33461 a tile (`Tile<Cost>::straight`).
    using Cost = typename detail::pick<roles::Cost, Natural, Policies...>::type;
    static_assert(!std::is_integral_v<Cost> ||
                      std::is_integral_v<std::decay_t<decltype(get(
                          detail::weights_of<Graph, Cost>(std::declval<const Graph&>(), std::declval<const Given&>()),
                          std::declval<const EdgeOf<Graph>&>()))>>,
                  "Ansatz paths: the weights of this graph have fractions, which a whole-number cost would cut off; "
                  "take CostIn<double>");

    /// \param graph read, never copied: it must live as long as this
    explicit FlowField(const Graph& graph, Policies... policies)
        : graph_(&graph),
          given_(detail::take<roles::Weights, detail::NotGiven>(policies...)),
          queue_(detail::take<roles::Queue, Heap>(policies...)) {}
    explicit FlowField(const Graph&&, Policies...) = delete; // a graph that is gone after this line

    /// Finds the way from everywhere to the nearest of these. Blocked ones are passed over.
    /// \return found, blocked where each of them is, or too_far where all ways from somewhere cost more than its
    ///         number holds: such a way counts as none, so take CostIn<std::uint64_t> or CostIn<double>
    /// \throws std::invalid_argument, and keeps what it had, for no goal, for one that the graph does not have, and
    ///         for a weight that is negative or no number
    Outcome aim(std::span<const Vertex> goals) {
        const Graph& g = *graph_;
        detail::require_vertices("FlowField", "goal", "the number of goals", g, goals);
        back_.read(g, given_);
        const std::size_t n = num_vertices(g);
        costs_.assign(n, detail::infinite<Cost>);
        next_.resize(n);
        waits_.assign(n, 0);
        queue_.begin(g);
        expanded_ = 0;
        version_ = version_of(g);
        bool any = false;
        for (const Vertex& goal : goals) {
            const std::size_t i = number(goal);
            if (detail::blocked(goal, g) || waits_[i] != 0) continue;
            costs_[i] = Cost(0), next_[i] = goal, waits_[i] = 1;
            if (any) queue_.push(Cost(0), Cost(0), goal);
            else queue_.start(Cost(0), Cost(0), goal);
            any = true;
        }
        while (!queue_.empty()) spread(queue_.pop());
        if (std::integral<Cost> && std::find(waits_.begin(), waits_.end(), beyond) != waits_.end())
            return Outcome::too_far;
        return any ? Outcome::found : Outcome::blocked;
    }
    /// The same for one goal.
    Outcome aim(const Vertex& goal) { return aim(std::span<const Vertex>(&goal, 1)); }

    /// What the way to the nearest goal costs; the dearest cost there is where there is none.
    Cost cost(const Vertex& v) const { return known(v) ? costs_[number(v)] : detail::infinite<Cost>; }
    /// Whether there is a way from here to a goal.
    bool reaches(const Vertex& v) const { return cost(v) < detail::infinite<Cost>; }
    /// The next vertex on that way; the vertex itself at a goal, and where there is no way.
    Vertex next(const Vertex& v) const { return reaches(v) ? next_[number(v)] : v; }
    /// Whither that is: of length 1, or 0 at a goal and where there is no way. In the coordinates of the graph; on a
    /// Grid y grows with the rows.
    auto direction(const Vertex& v) const {
        auto towards = (place(next(v)) - place(v)).value().eval();
        const auto length = towards.norm();
        if (length > 0) towards /= length;
        return towards;
    }
    /// The way from a vertex to its goal, both included; empty where there is none.
    /// \param path its memory is used again
    void path(const Vertex& from, std::vector<Vertex>& path) const {
        path.clear();
        if (!reaches(from)) return;
        path.push_back(from);
        for (Vertex at = from, then = next(at); !(then == at); at = then, then = next(at)) path.push_back(then);
    }
    /// Whether the graph is as it was when the field was aimed. Graphs that do not count their changes
    /// (`version()`) are held to be.
    bool is_current() const { return !costs_.empty() && version_ == version_of(*graph_); }
    std::size_t expanded() const { return expanded_; } ///< how often the edges into a vertex were followed
    const Graph& graph() const { return *graph_; }     ///< what is searched

private:
    using Back = std::conditional_t<detail::HasTiles<Graph> && std::is_same_v<Given, detail::NotGiven>,
                                    detail::StepsInto<Graph, Cost>, detail::EdgesInto<Graph, Cost>>;
    static std::size_t version_of(const Graph& g) {
        if constexpr (requires { g.version(); }) return g.version();
        else return 0;
    }
    std::size_t number(const Vertex& v) const { return std::size_t(get(detail::index_of(*graph_), v)); }
    bool known(const Vertex& v) const { return detail::contains(v, *graph_) && number(v) < costs_.size(); }
    auto place(const Vertex& v) const {
        static_assert(
            requires(const Graph& g) { position_of(v, g); } || requires(const Graph& g) { g.position(v); },
            "Ansatz paths: directions need coordinates: a Grid, Waypoints, or a graph of yours with position_of(v, g)");
        if constexpr (requires { position_of(v, *graph_); }) return position_of(v, *graph_);
        else return graph_->position(v);
    }
    /// From every vertex with an edge to this one a way is known now. In whatever order the queue has them: one whose
    /// cost falls again is expanded again.
    void spread(const Vertex& p) {
        const std::size_t at = number(p);
        if (waits_[at] == 0) return; // an old entry
        waits_[at] = 0;
        ++expanded_;
        const Cost cost = costs_[at];
        back_.into(*graph_, p, [&](const Vertex& q, const Cost weight) {
            const Cost through = detail::add(cost, weight);
            const std::size_t i = number(q);
            if constexpr (std::integral<Cost>)
                if (through == detail::infinite<Cost> && costs_[i] == through) waits_[i] = beyond;
            if (!(through < costs_[i])) return;
            costs_[i] = through, next_[i] = p, waits_[i] = 1;
            queue_.push(through, Cost(0), q);
        });
    }
    const Graph* graph_;
    Given given_;
    typename QueuePolicy::template In<Cost, Vertex> queue_;
    Back back_;
    std::vector<Cost> costs_;  ///< by the number of the vertex
    std::vector<Vertex> next_; ///< where there is a way
    /// 1 while it is in the queue with a cost that has not been passed on yet, `beyond` while all that is known is a
    /// way that costs more than a number holds.
    std::vector<std::uint8_t> waits_;
    static constexpr std::uint8_t beyond = 2;
    std::size_t version_ = 0, expanded_ = 0;
};
/// The field of a graph, `FlowField{map, Buckets{}}`.
template <class Graph, class... Policies> FlowField(const Graph&, Policies...) -> FlowField<Graph, Policies...>;

} // namespace ansatz::paths
