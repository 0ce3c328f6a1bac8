// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Unscaled`: a grid's heuristic without regard to its ground, as if every tile weighed 1.
///
/// The heuristics of this library ask the grid for its least weight and count every tile with that, so that they never
/// estimate too much. Without it, one road of weight 0.5 makes them overestimate, and the path may be worse than the
/// best: take Unscaled to see that, or where you know that the least weight lies nowhere near.

#include <ansatz/paths/graph.hpp>

namespace ansatz::paths {

/// As `Heuristic`, for tiles of weight 1.
template <class Heuristic> struct Unscaled {
    using role = roles::Heuristic;
    Heuristic of; ///< the one that it asks
    /// Asks this one.
    explicit Unscaled(Heuristic h) : of(h) {}
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        static_assert(
            requires { of.template bind_tiles<Cost>(g, goal, Cost(1), Cost(1)); },
            "Ansatz paths: Unscaled takes Manhattan, Octile, Chebyshev or Euclid on a grid");
        return of.template bind_tiles<Cost>(g, goal, Tile<Cost>::straight, Tile<Cost>::diagonal);
    }
};

} // namespace ansatz::paths
