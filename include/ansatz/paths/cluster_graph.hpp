// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ClusterGraph`: the gates of a grid with a start and a goal, as a graph of Boost.Graph: what a `GateSearch`
/// searches.
///
/// Its vertices are tiles, of which only gates, the start and the goal have edges; they have the numbers that the grid
/// gives them. It has as much of Boost.Graph's IncidenceGraph as a search asks for; edges do not know where they begin.
/// The start is joined to the gates of its square, and the gates of the goal's square to the goal.

#include <ansatz/paths/clusters.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/implicit_graph.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// The gates of a grid with a start and a goal, as a graph of Boost.Graph: what a `GateSearch` searches.
template <class Map> class ClusterGraph {
public:
    using default_cost = std::uint32_t;                        ///< as on a grid
    using default_heuristic = typename Map::default_heuristic; ///< as on the grid
    /// \param clusters read, never copied
    explicit ClusterGraph(const Clusters<Map>& clusters) : clusters_(&clusters) {}
    const Clusters<Map>& clusters() const { return *clusters_; } ///< without start and goal
    /// The least that a step costs: what Octile and Manhattan ask for.
    template <class Number> Steps<Number> least_step() const { return clusters_->template least_step<Number>(); }

    /// Between these two.
    void set_ends(Cell start, Cell goal) {
        start_ = start, goal_ = goal;
        too_far_ = !clusters_->ways_to(goal, steps_, costs_);
        away_.clear();
        if (clusters_->is_gate(start)) return;
        for (const Cell gate : clusters_->gates_of(clusters_->square_of(start)))
            if (const auto cost = clusters_->cost_to(gate, start); cost != Clusters<Map>::no_way)
                away_.push_back({gate, cost});
    }
    /// The edges that lead away from a gate or the start, but for that to the goal.
    std::pair<const GateEdge*, const GateEdge*> edges_of(Cell c) const {
        if (clusters_->is_gate(c)) return clusters_->edges_of(c);
        return {away_.data(), away_.data() + away_.size()};
    }
    /// The edge to the goal inside of its square; its cost is `no_way` where there is none.
    GateEdge last_edge(Cell c) const {
        if (c == goal_ || clusters_->square_of(c) != clusters_->square_of(goal_)) return {goal_, Clusters<Map>::no_way};
        return {goal_, costs_[clusters_->local(c)]};
    }
    /// Whether a way, to a gate or to the goal, costs more than its number holds, and so is none here.
    bool too_far() const { return too_far_ || clusters_->too_far(); }
    /// The direction of the next step to the goal, inside of its square.
    std::uint8_t step_to_goal(Cell from) const { return steps_[clusters_->local(from)]; }

private:
    const Clusters<Map>* clusters_;
    Cell start_, goal_;
    bool too_far_ = false;            ///< a way to the goal inside of its square
    std::vector<GateEdge> away_;      ///< from the start
    std::vector<std::uint8_t> steps_; ///< to the goal, inside of its square
    std::vector<std::uint32_t> costs_;
};

/// The edges that lead away from a gate, and that to the goal.
class GateEdges {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = GateEdge;
    using difference_type = std::ptrdiff_t;
    using pointer = const GateEdge*;
    using reference = GateEdge;
    GateEdges() = default;
    /// At the first of those up to `end`; behind them comes `last`, if it leads anywhere.
    GateEdges(const GateEdge* at, const GateEdge* end, GateEdge last, std::uint8_t left)
        : at_(at), end_(end), last_(last), left_(left) {}
    GateEdge operator*() const { return at_ != end_ ? *at_ : last_; }
    GateEdges& operator++() {
        if (at_ != end_) ++at_;
        else left_ = 0;
        return *this;
    }
    GateEdges operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const GateEdges& a, const GateEdges& b) { return a.at_ == b.at_ && a.left_ == b.left_; }

private:
    const GateEdge *at_ = nullptr, *end_ = nullptr;
    GateEdge last_;
    std::uint8_t left_ = 0; ///< whether the last one is still to come
};

template <class M> std::pair<GateEdges, GateEdges> out_edges(Cell c, const ClusterGraph<M>& g) {
    const auto [at, end] = g.edges_of(c);
    const auto last = g.last_edge(c);
    const bool leads = last.cost != Clusters<M>::no_way;
    return {GateEdges(at, end, last, leads), GateEdges(end, end, last, 0)};
}
template <class M> std::size_t out_degree(Cell c, const ClusterGraph<M>& g) {
    const auto edges = out_edges(c, g);
    return std::size_t(std::distance(edges.first, edges.second));
}
template <class M> Cell target(const GateEdge& e, const ClusterGraph<M>&) { return e.to; }
template <class M> std::size_t num_vertices(const ClusterGraph<M>& g) { return g.clusters().map().size(); }
template <class M> auto get(boost::vertex_index_t tag, const ClusterGraph<M>& g) {
    return get(tag, g.clusters().map());
}
/// What an edge costs, as a property map.
struct GateWeights {
    using key_type = GateEdge;
    using value_type = std::uint32_t;
    using reference = std::uint32_t;
    using category = boost::readable_property_map_tag;
    friend std::uint32_t get(const GateWeights&, const GateEdge& e) { return e.cost; }
};
template <class M> GateWeights get(boost::edge_weight_t, const ClusterGraph<M>&) { return {}; }
/// For Buckets.
template <class M, class Cost> double bucket_width(const ClusterGraph<M>& g, std::type_identity<Cost>) {
    return 2 * double(g.template least_step<Cost>().straight);
}
template <class M> bool has_vertex(Cell c, const ClusterGraph<M>& g) { return g.clusters().map().contains(c); }
template <class M> bool is_blocked(Cell c, const ClusterGraph<M>& g) { return !g.clusters().map().passable(c); }
template <class M> std::string name_of(Cell c, const ClusterGraph<M>&) { return name_of(c); }

} // namespace ansatz::paths

namespace boost {
template <class M>
struct graph_traits<ansatz::paths::ClusterGraph<M>>
    : ansatz::paths::ImplicitGraphTraits<ansatz::paths::Cell, ansatz::paths::GateEdge, ansatz::paths::GateEdges> {};
template <class M> struct property_map<ansatz::paths::ClusterGraph<M>, vertex_index_t> {
    using type = ansatz::paths::GridIndex;
    using const_type = type;
};
template <class M> struct property_map<ansatz::paths::ClusterGraph<M>, edge_weight_t> {
    using type = ansatz::paths::GateWeights;
    using const_type = type;
};
} // namespace boost
