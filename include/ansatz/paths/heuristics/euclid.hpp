// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Euclid`: the straight distance to the goal, on a grid and on every graph whose vertices have coordinates.
///
/// The notes: with it "it is common to greatly underestimate the lowest distance", and on a grid Octile is better and
/// cheaper. On way points it is what there is. Rounded down where costs are whole numbers.

#include <ansatz/paths/heuristics/grid_metrics.hpp>

#include <cmath>

namespace ansatz::paths {

/// The straight distance.
///
/// A graph of your own takes part by two functions that this finds: `position_of(v, g)`, a vector quantity, and
/// `least_cost_per_metre(g)`, a plain number.
struct Euclid {
    using role = roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        constexpr bool tiles = requires { g.template least_step<Cost>(); };
        constexpr bool coordinates = requires {
            position_of(goal, g);
            least_cost_per_metre(g);
        };
        static_assert(
            tiles || coordinates,
            "Ansatz paths: Euclid needs coordinates: a Grid, Waypoints, or a graph of yours with position_of(v, g) "
            "and least_cost_per_metre(g)");
        if constexpr (tiles) {
            const auto least = g.template least_step<Cost>();
            return bind_tiles<Cost>(g, goal, least.straight, least.diagonal);
        } else
            return [&g, at = position_of(goal, g), per_metre = least_cost_per_metre(g)](const VertexOf<Graph>& v) {
                // A little less than the rounded distance, or the sum of a straight way's parts could be below it.
                return Cost((position_of(v, g) - at).value().norm() * per_metre * (1 - 1e-15));
            };
    }
    template <class Cost, class Graph>
    auto bind_tiles(const Graph&, const GoalOf<Graph>& goal, Cost straight, Cost diagonal) const {
        const double tile = std::min(double(straight), double(diagonal) / 1.4142135623730950488);
        return [goal, tile](const VertexOf<Graph>& v) {
            const detail::Apart a(v, goal);
            return Cost(tile * std::sqrt(double(a.dx) * a.dx + double(a.dy) * a.dy));
        };
    }
};

} // namespace ansatz::paths
