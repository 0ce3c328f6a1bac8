// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `By`: a heuristic that is a function of yours: `By{[&](Vertex v, Vertex goal) { return ...; }}`, or of the vertex
/// alone.

#include <ansatz/paths/graph.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace ansatz::paths {

namespace detail {
/// What a function answered, in the number of the search. No cost is negative, so an estimate below zero says no more
/// than zero does, and one that is no number says nothing; as a whole number both would be huge.
template <class Cost, class Number> constexpr Cost estimated(const Number& h) {
    if constexpr (std::is_arithmetic_v<Number>) {
        if (!(h > Number(0))) return Cost(0);
        if constexpr (std::is_integral_v<Cost> && std::is_floating_point_v<Number>) {
            if (h >= Number(infinite<Cost>)) return infinite<Cost>;
        } else if constexpr (std::is_integral_v<Cost>) {
            if (std::uintmax_t(h) >= std::uintmax_t(infinite<Cost>)) return infinite<Cost>;
        }
    }
    return Cost(h);
}
} // namespace detail

/// h is what this function answers, in the unit of the weights: on a Grid, whose searches count in whole numbers,
/// 33461 a tile (`Tile<Cost>::straight`). Less than nothing, and what is no number, counts as nothing.
template <class Function> struct By {
    using role = roles::Heuristic;
    Function function; ///< of (vertex, goal), or of (vertex)
    template <class Cost, class Graph> auto bind(const Graph&, const GoalOf<Graph>& goal) const {
        constexpr bool of_both = std::is_invocable_v<const Function&, const VertexOf<Graph>&, const GoalOf<Graph>&>;
        constexpr bool of_one = std::is_invocable_v<const Function&, const VertexOf<Graph>&>;
        static_assert(of_both || of_one,
                      "Ansatz paths: By takes a function of (vertex, goal), or of (vertex), that answers "
                      "with a number; write e.g. By{[](auto v, auto goal) { return 0.0; }}");
        if constexpr (of_both)
            return [f = function, goal](const VertexOf<Graph>& v) { return detail::estimated<Cost>(f(v, goal)); };
        else return [f = function](const VertexOf<Graph>& v) { return detail::estimated<Cost>(f(v)); };
    }
};
/// `By{function}` holds this function.
template <class Function> By(Function) -> By<Function>;

} // namespace ansatz::paths
