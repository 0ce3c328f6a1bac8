// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Maximum`: the largest of several heuristics, node by node. If none of them is ever too much, nor is this; it
/// expands no more than the best of them, and asks them all.

#include <ansatz/paths/graph.hpp>

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace ansatz::paths {

/// The largest of these: `Maximum{Octile{}, landmarks}`.
template <class... Heuristics> struct Maximum {
    static_assert(sizeof...(Heuristics) > 0,
                  "Ansatz paths: Maximum of no heuristics; write e.g. Maximum{Octile{}, Euclid{}}");
    static_assert((HasRole<Heuristics, roles::Heuristic> && ...),
                  "Ansatz paths: Maximum takes heuristics alone; write e.g. Maximum{Octile{}, Euclid{}}");
    using role = roles::Heuristic;
    std::tuple<Heuristics...> of; ///< those it asks
    /// Asks these.
    explicit Maximum(Heuristics... hs) : of(hs...) {}
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        return std::apply(
            [&](const auto&... hs) {
                return [bound = std::tuple(hs.template bind<Cost>(g, goal)...)](const VertexOf<Graph>& v) {
                    return std::apply([&](const auto&... each) { return largest<Cost>(each(v)...); }, bound);
                };
            },
            of);
    }

private:
    template <class Cost, class... H> static auto largest(const H&... h) {
        using Number = std::common_type_t<detail::Guess<Cost, H>...>; // one of them may be wider than the costs
        return std::max({Number(detail::Guess<Cost, H>(h))...});
    }
};

} // namespace ansatz::paths
