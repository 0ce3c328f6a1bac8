// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `AnyAngle`: the shorter of two paths for one who walks straight from corner to corner of a grid: that of
/// `LazyTheta`, and A*'s with the zigzag taken out (`smooth`). Never longer than either.
///
/// Take it where a path is found rarely and walked long; it searches twice. How often which is the shorter is on the
/// chapter's page.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/lazy_theta.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <span>
#include <vector>

namespace ansatz::paths {

/// \tparam Map     a Grid on even ground
/// \tparam Queue   of the search along the tiles: `Heap`, `Buckets`
template <class Map, class Queue = Heap> class AnyAngle {
public:
    /// \param map read, never copied: it must live as long as this
    explicit AnyAngle(const Map& map, Queue queue = {}) : along_tiles_(map, queue), straight_(map, LazyTheta{}) {}
    explicit AnyAngle(const Map&&, Queue = {}) = delete; // a map that is gone after this line

    /// Finds both paths, and keeps the shorter one.
    /// \throws std::invalid_argument for a start or goal outside the map
    Outcome find(Cell start, Cell goal) {
        const Outcome outcome = along_tiles_.find(start, goal);
        smoothed_ = smooth(along_tiles_.graph(), along_tiles_.path());
        straight_.find(start, goal);
        tiles_.clear();
        const auto corners = straight_.path();
        if (!corners.empty()) tiles_.push_back(corners.front());
        for (std::size_t i = 1; i < corners.size(); ++i)
            detail::walk_line(corners[i - 1], corners[i], [&](Cell, Cell to) { return tiles_.push_back(to), true; });
        taut_ = smooth(straight_.graph(), tiles_); // its parents are neighbours' parents, which leaves bends
        if (straight_tiles(corners) < straight_tiles(taut_)) taut_.assign(corners.begin(), corners.end());
        by_theta_ = outcome == Outcome::found && straight_tiles(taut_) < straight_tiles(smoothed_);
        return outcome;
    }
    /// Its corners, from start to goal, both included; empty where there is none. Valid until the next query.
    std::span<const Cell> path() const { return by_theta_ ? taut_ : smoothed_; }
    double tiles() const { return straight_tiles(path()); }      ///< its length, walked straight from corner to corner
    bool by_theta() const { return by_theta_; }                  ///< whether it is LazyTheta's, perhaps smoothed
    const auto& theta() const { return straight_; }              ///< the search of any angle
    const auto& a_star() const { return along_tiles_; }          ///< the search along the tiles
    std::span<const Cell> smoothed() const { return smoothed_; } ///< the corners of the path along the tiles

private:
    AStar<Map, Queue> along_tiles_;
    AStar<Map, LazyTheta> straight_;
    std::vector<Cell> smoothed_, tiles_, taut_;
    bool by_theta_ = false;
};
/// `AnyAngle{map}`.
template <class Map> AnyAngle(const Map&) -> AnyAngle<Map>;
/// `AnyAngle{map, Buckets{}}`.
template <class Map, class Queue> AnyAngle(const Map&, Queue) -> AnyAngle<Map, Queue>;

} // namespace ansatz::paths
