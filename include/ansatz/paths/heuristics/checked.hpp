// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `check_heuristic` and `Checked`: does a heuristic ever estimate too much, and where?
///
/// The notes: a heuristic **must** be an underestimate or exact. This finds out, by the true cost of every vertex, and names
/// the node. To learn and to test with: it looks at the whole graph for every goal.

#include <ansatz/paths/true_costs.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// A node at which a heuristic is too much.
template <class Vertex> struct Overestimate {
    Vertex node{};        ///< where it is
    double estimate = 0;  ///< h, in the unit of the weights
    double true_cost = 0; ///< of the cheapest way from there to the goal
    std::string sentence; ///< the same, to be read
};

namespace detail {
/// By how much an estimate may pass the truth: what rounding of sums does.
template <class Cost> bool too_much(Cost estimate, Cost truth) {
    if constexpr (std::is_integral_v<Cost>) return estimate > truth;
    else
        return truth<infinite<Cost>&& double(estimate)> double(truth) *
               (1 + 256 * double(std::numeric_limits<Cost>::epsilon()));
}
template <class Cost, class Graph>
[[gnu::cold]] std::string overestimates(const Graph& g, const VertexOf<Graph>& v, Cost estimate, Cost truth) {
    return "the heuristic overestimates at node " + name_of_vertex(v, g) + ": h is " + describe(estimate) +
           ", the true cost to the goal is " + describe(truth);
}
} // namespace detail

/// The node at which a heuristic is most above the true cost; none if it never is.
/// \tparam Cost in which number to estimate
template <class Cost = double, class Graph, class Heuristic>
std::optional<Overestimate<VertexOf<Graph>>> check_heuristic(const Graph& g, const Heuristic& heuristic,
                                                             const GoalOf<Graph>& goal) {
    const auto costs = true_costs<Cost>(g, goal);
    const auto estimate = heuristic.template bind<Cost>(g, goal);
    const auto index = get(boost::vertex_index, g);
    std::optional<Overestimate<VertexOf<Graph>>> worst;
    const auto all = vertices(g);
    for (auto at = all.first; at != all.second; ++at) {
        const VertexOf<Graph> v = *at;
        const Cost truth = costs[std::size_t(get(index, v))], h = estimate(v);
        if (!(truth < detail::infinite<Cost>) || !detail::too_much(h, truth)) continue;
        if (worst && double(h) - double(truth) <= worst->estimate - worst->true_cost) continue;
        worst = {v, double(h), double(truth), detail::overestimates(g, v, h, truth)};
    }
    return worst;
}

/// What a Checked heuristic has seen.
struct HeuristicReport {
    std::size_t asked = 0;         ///< how often it was asked
    std::size_t overestimates = 0; ///< how often it was too much
    std::string worst;             ///< the worst of them in a sentence with its node; empty if there was none
    double by = 0;                 ///< by how much, in the number of the search
};

/// Another heuristic under observation: `HeuristicReport report; AStar search{map, Checked{Octile{}, report}};`.
/// It answers the same. Binding it to a goal costs a search of the whole graph.
template <class Heuristic> struct Checked {
    using role = roles::Heuristic;
    Heuristic of;            ///< the one that is watched
    HeuristicReport* report; ///< what it has seen is written there
    /// Watches h; the report must live as long.
    Checked(Heuristic h, HeuristicReport& r) : of(h), report(&r) {}
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        auto costs = std::make_shared<std::vector<Cost>>(true_costs<Cost>(g, goal));
        return [&g, costs, h = of.template bind<Cost>(g, goal), seen = report](const VertexOf<Graph>& v) {
            const Cost estimate = h(v), truth = (*costs)[std::size_t(get(get(boost::vertex_index, g), v))];
            ++seen->asked;
            if (detail::too_much(estimate, truth)) {
                ++seen->overestimates;
                if (const double by = double(estimate) - double(truth); by > seen->by) {
                    seen->by = by;
                    seen->worst = detail::overestimates(g, v, estimate, truth);
                }
            }
            return estimate;
        };
    }
};

} // namespace ansatz::paths
