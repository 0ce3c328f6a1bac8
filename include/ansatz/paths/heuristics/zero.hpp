// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ZeroHeuristic`: h = 0 everywhere. Never an overestimate, and never a help: A* with it is Dijkstra's algorithm. Take
/// it on graphs of which nothing is known, and as the reference that others are held against.

#include <ansatz/paths/graph.hpp>

namespace ansatz::paths {

/// h = 0.
struct ZeroHeuristic {
    using role = roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph&, const GoalOf<Graph>&) const {
        return [](const VertexOf<Graph>&) { return Cost(0); };
    }
};

} // namespace ansatz::paths
