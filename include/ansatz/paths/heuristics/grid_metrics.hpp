// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Manhattan`, `Octile` and `Chebyshev`: how far it is on a grid without walls, counted in tiles of the least weight.
///
/// | policy      | h                                                 | exact on an empty grid of         |
/// |-------------|---------------------------------------------------|-----------------------------------|
/// | `Manhattan` | \f$ s\,(dx + dy) \f$                              | four neighbours                   |
/// | `Octile`    | \f$ d \min(dx, dy) + s\,\vert dx - dy \vert \f$   | eight neighbours                  |
/// | `Chebyshev` | \f$ s \max(dx, dy) \f$                            | eight, if diagonals cost no more  |
///
/// s and d are what a straight and a diagonal step cost on the lightest ground of the grid, and dx, dy the distances in
/// columns and rows. On eight neighbours Manhattan is an overestimate, and it is for you to choose.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/grid/cell.hpp>

#include <algorithm>
#include <cstdint>

namespace ansatz::paths {

namespace detail {
/// Distances in columns and rows.
struct Apart {
    std::uint32_t dx, dy;
    Apart(Cell a, Cell b) : dx(between(column(a), column(b))), dy(between(row(a), row(b))) {}
    static std::uint32_t between(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; }
};
} // namespace detail

namespace detail {
/// What the three have in common: they ask the grid what its lightest tile costs.
template <class Metric> struct OnTiles {
    using role = roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        static_assert(
            requires {
                g.template least_step<Cost>();
                VertexOf<Graph>{}.x;
            }, "Ansatz paths: Manhattan, Octile and Chebyshev count the tiles of a grid; on a graph with coordinates "
               "take Euclid, on any other ZeroHeuristic or By{...}");
        const auto least = g.template least_step<Cost>();
        return bind_tiles<Cost>(g, goal, least.straight, least.diagonal);
    }
    /// \param straight, diagonal what a step costs at least
    template <class Cost, class Graph>
    auto bind_tiles(const Graph&, const GoalOf<Graph>& goal, Cost straight, Cost diagonal) const {
        return [goal, straight, diagonal](const VertexOf<Graph>& v) {
            return Metric::template of<Cost>(Apart(v, goal), straight, diagonal);
        };
    }
};
} // namespace detail

/// Columns plus rows.
struct Manhattan : detail::OnTiles<Manhattan> {
    /// h, for so many columns and rows and the costs of a straight and a diagonal step.
    template <class Cost, class Apart> static Cost of(const Apart& a, Cost straight, Cost) {
        return straight * Cost(a.dx + a.dy);
    }
};
/// The fewest steps, diagonal ones at their own price.
struct Octile : detail::OnTiles<Octile> {
    /// h, for so many columns and rows and the costs of a straight and a diagonal step.
    template <class Cost, class Apart> static Cost of(const Apart& a, Cost straight, Cost diagonal) {
        const std::uint32_t less = std::min(a.dx, a.dy), more = std::max(a.dx, a.dy);
        return diagonal * Cost(less) + straight * Cost(more - less);
    }
};
/// The larger of columns and rows.
struct Chebyshev : detail::OnTiles<Chebyshev> {
    /// h, for so many columns and rows and the costs of a straight and a diagonal step.
    template <class Cost, class Apart> static Cost of(const Apart& a, Cost straight, Cost) {
        return straight * Cost(std::max(a.dx, a.dy));
    }
};

} // namespace ansatz::paths
