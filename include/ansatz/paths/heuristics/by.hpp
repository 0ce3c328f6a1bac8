// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `By`: a heuristic that is a function of yours: `By{[&](Vertex v, Vertex goal) { return ...; }}`, or of the vertex alone.

#include <ansatz/paths/graph.hpp>

#include <type_traits>
#include <utility>

namespace ansatz::paths {

/// h is what this function answers, in the unit of the weights.
template <class Function> struct By {
    using role = roles::Heuristic;
    Function function; ///< of (vertex, goal), or of (vertex)
    template <class Cost, class Graph> auto bind(const Graph&, const GoalOf<Graph>& goal) const {
        constexpr bool of_both = std::is_invocable_v<const Function&, const VertexOf<Graph>&, const GoalOf<Graph>&>;
        constexpr bool of_one = std::is_invocable_v<const Function&, const VertexOf<Graph>&>;
        static_assert(of_both || of_one,
                      "Ansatz paths: By takes a function of (vertex, goal), or of (vertex), that answers "
                      "with a number; write e.g. By{[](auto v, auto goal) { return 0.0; }}");
        if constexpr (of_both) return [f = function, goal](const VertexOf<Graph>& v) { return Cost(f(v, goal)); };
        else return [f = function](const VertexOf<Graph>& v) { return Cost(f(v)); };
    }
};
/// `By{function}` holds this function.
template <class Function> By(Function) -> By<Function>;

} // namespace ansatz::paths
