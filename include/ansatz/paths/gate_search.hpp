// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `GateSearch`: long paths on large grids, found from gate to gate and then step by step (HPA*, Botea, Mueller and
/// Schaeffer 2004; notes 6.3).
///
/// ```
/// GateSearch search{map};                                           // once for a map
/// if (search.find(start, goal) == Outcome::found) walk(search.path());
/// ```
///
/// A search expands gates (`Clusters`) where A* expands tiles, and then follows ways that are known. What is found is
/// longer than the best path by what gates are off it; `find` takes most of that back, piece by piece: the way between
/// two places of it is searched again on the tiles, and the shorter one is kept. A near goal is searched on the
/// tiles at once.
///
/// Take it where a map is large and paths are long; on MovingAI's maps they come out a few per cent longer at worst
/// (\ref paths_costs "what it costs"), on uneven ground nothing is promised. Where the best path is wanted, or paths
/// are short, take `AStar`. Before each search the map is checked for changes; one costs the squares that it
/// touches.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/cluster_graph.hpp>
#include <ansatz/paths/clusters.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics/grid_metrics.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ansatz::paths {

/// \tparam Map a Grid
template <class Map> class GateSearch {
    static_assert(
        requires { typename Map::neighbours; },
        "Ansatz paths: GateSearch cuts a map of tiles into squares; it needs a Grid. On any other graph take AStar");

public:
    using Cost = std::uint32_t; ///< as on a grid
    /// \param map  read, never copied: it must live as long as this
    /// \param side of a square, in tiles
    /// \throws std::invalid_argument for a side that is not from 4 to 64
    explicit GateSearch(const Map& map, std::size_t side = 32)
        : clusters_(map, side),
          graph_(clusters_),
          gates_(graph_, Buckets{}, CostIn<std::uint64_t>{}),
          tiles_(map, Buckets{}) {}
    explicit GateSearch(const Map&&, std::size_t = 32) = delete; // a map that is gone after this line
    GateSearch(const GateSearch&) = delete;                      ///< its searches read its own gates
    GateSearch& operator=(const GateSearch&) = delete;           ///< the same

    /// Finds a path.
    /// \throws std::invalid_argument for a start or goal outside the map; the last path is kept
    Outcome find(Cell start, Cell goal) {
        const Map& map = clusters_.map();
        detail::require_vertex("GateSearch::find", "start", map, start);
        detail::require_vertex("GateSearch::find", "goal", map, goal);
        remade_ = clusters_.update();
        path_.clear();
        looked_at_ = 0;
        const std::size_t near = 4 * clusters_.side() * clusters_.side();
        outcome_ = Outcome::gave_up;
        if (apart(start, goal) <= 2 * clusters_.side()) {
            outcome_ = tiles_.find(start, goal, near);
            looked_at_ += tiles_.expanded();
            if (outcome_ == Outcome::found) path_.assign(tiles_.path().begin(), tiles_.path().end());
        }
        if (outcome_ != Outcome::gave_up) return outcome_;
        if (!map.passable(start) || !map.passable(goal)) return outcome_ = Outcome::blocked;
        graph_.set_ends(start, goal);
        outcome_ = gates_.find(start, goal);
        looked_at_ += gates_.expanded();
        if (outcome_ == Outcome::no_path && graph_.too_far()) { // whether there is a way is for wider numbers to say
            AStar wide{map, CostIn<std::uint64_t>{}};
            if (wide.find(start, goal) == Outcome::found) outcome_ = Outcome::too_far;
            looked_at_ += wide.expanded();
        }
        if (outcome_ != Outcome::found) return outcome_;
        refine(gates_.path());
        if (improves) shorten();
        return outcome_;
    }
    Outcome outcome() const { return outcome_; } ///< of the last search
    /// From start to goal, both included, tile by tile; empty where there is none. Valid until the next search.
    std::span<const Cell> path() const { return path_; }
    /// What it costs, in tiles.
    double cost() const { return clusters_.map().cost(path_); }
    std::size_t expanded() const { return looked_at_; }         ///< gates and tiles whose neighbours were visited
    std::size_t remade() const { return remade_; }              ///< squares that were made again before the last search
    const Clusters<Map>& clusters() const { return clusters_; } ///< what is searched first
    bool improves = true; ///< whether the path is searched again piece by piece; without is quicker, and longer

private:
    static std::size_t apart(Cell a, Cell b) {
        const detail::Apart d(a, b);
        return std::max(d.dx, d.dy);
    }
    /// From gate to gate along the ways that are known.
    void refine(std::span<const Cell> gates) {
        path_.push_back(gates.front());
        for (std::size_t i = 1; i < gates.size(); ++i) {
            Cell at = gates[i - 1];
            const Cell to = gates[i];
            if (clusters_.square_of(at) != clusters_.square_of(to)) {
                path_.push_back(to);
                continue;
            }
            const bool gate = clusters_.is_gate(to);
            while (!(at == to)) {
                at = detail::step(at, gate ? clusters_.step_to(to, at) : graph_.step_to_goal(at));
                path_.push_back(at);
            }
        }
    }
    Cost cost_between(std::size_t from, std::size_t to) const {
        const auto weights = clusters_.map().template weights<Cost>();
        Cost sum = 0;
        for (std::size_t i = from + 1; i <= to; ++i)
            sum = detail::add(sum, weights.of(clusters_.map().index(path_[i]),
                                              path_[i].x != path_[i - 1].x && path_[i].y != path_[i - 1].y));
        return sum;
    }
    /// Searches pieces of the path again on the tiles, each begun three quarters of a piece further, and keeps what is
    /// shorter.
    void shorten() {
        const std::size_t part = clusters_.side() * 3 / 4;
        const std::size_t most = clusters_.side() * clusters_.side();
        for (std::size_t from = 0; from + 1 < path_.size();) {
            const std::size_t to = std::min(from + part, path_.size() - 1);
            const Cost now = cost_between(from, to);
            const auto least = typename Map::default_heuristic{}.template bind<Cost>(clusters_.map(), path_[to]);
            std::size_t next = to == path_.size() - 1 ? to : from + (to - from) * 3 / 4;
            if (now > least(path_[from])) {
                const auto outcome = tiles_.find(path_[from], path_[to], most);
                looked_at_ += tiles_.expanded();
                if (outcome == Outcome::found && tiles_.cost() < now) {
                    const auto found = tiles_.path();
                    // What follows is moved up behind it.
                    tail_.assign(path_.begin() + std::ptrdiff_t(to) + 1, path_.end());
                    path_.resize(from);
                    path_.insert(path_.end(), found.begin(), found.end());
                    const std::size_t end = path_.size() - 1;
                    path_.insert(path_.end(), tail_.begin(), tail_.end());
                    next = tail_.empty() ? end : from + (end - from) * 3 / 4;
                }
            }
            from = std::max(next, from + 1);
        }
    }

    Clusters<Map> clusters_;
    ClusterGraph<Map> graph_;
    // In 64 bits: a gate may lie on a heavy tile that the path in the end goes round.
    AStar<ClusterGraph<Map>, Buckets, CostIn<std::uint64_t>> gates_;
    AStar<Map, Buckets> tiles_;
    std::vector<Cell> path_, tail_;
    std::size_t looked_at_ = 0, remade_ = 0;
    Outcome outcome_ = Outcome::not_begun;
};
/// `GateSearch{map}`.
template <class Map> GateSearch(const Map&) -> GateSearch<Map>;
/// `GateSearch{map, 16}`.
template <class Map> GateSearch(const Map&, std::size_t) -> GateSearch<Map>;

} // namespace ansatz::paths
