// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Weighted`: another heuristic, multiplied by a weight w. With w > 1 the search heads for the goal, expands far fewer
/// nodes, and finds a path that costs at most w times the best, if the heuristic itself was never too much.
///
/// Take it with `NoReopening`: the bound holds without, and opening nodes again costs more than the weight saves. A w
/// between 1.2 and 1.5 gives most of the gain.
///
/// Where costs are whole numbers w times h is counted in 64 bits, and f with it: only the path has to fit into the
/// number of the costs, not its estimate.
///
/// \see I. Pohl, "Heuristic search viewed as path finding in a graph", Artificial Intelligence 1 (1970).

#include <ansatz/core/error.hpp>
#include <ansatz/paths/graph.hpp>

#include <cmath>

namespace ansatz::paths {

/// w times h, rounded down where costs are whole numbers.
template <class Heuristic> struct Weighted {
    using role = roles::Heuristic;
    Heuristic of;      ///< the one that gives h
    double weight = 1; ///< finite, not negative
    /// \throws std::invalid_argument for a weight that is negative, infinite or not a number
    Weighted(Heuristic h, double w) : of(h), weight(w) {
        if (!std::isfinite(w) || w < 0) refuse_value("Weighted", "weight", w, "it must be finite and not negative");
    }
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        return [h = of.template bind<Cost>(g, goal), w = weight](const VertexOf<Graph>& v) {
            return detail::scaled(detail::Wide<Cost>(h(v)), w);
        };
    }
};

} // namespace ansatz::paths
