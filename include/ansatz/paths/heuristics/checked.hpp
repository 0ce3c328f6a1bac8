// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `check_heuristic` and `Checked`: does a heuristic ever estimate too much, and where?
///
/// The notes: a heuristic **must** be an underestimate or exact. This finds out, by the true cost of every vertex, and
/// names the node. To learn and to test with: it visits the whole graph for every goal. It judges in the number in
/// which the search counts, since an estimate is right or wrong only in that: on a Grid a tile is 33461, not 1.

#include <ansatz/paths/true_costs.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// A node at which a heuristic is too much.
template <class Vertex> struct Overestimate {
    Vertex node{};        ///< where it is
    double estimate = 0;  ///< h, in the number of the search
    double true_cost = 0; ///< of the cheapest way from there to the goal, in the same
    std::string sentence; ///< the same, to be read
};

namespace detail {
/// By how much an estimate may pass the truth: what rounding of sums does.
template <class Guess, class Cost> bool too_much(Guess estimate, Cost truth) {
    if constexpr (std::is_integral_v<Cost>) return estimate > Guess(truth);
    else
        return truth<infinite<Cost>&& double(estimate)> double(truth) *
               (1 + 256 * double(std::numeric_limits<Cost>::epsilon()));
}
template <class Guess, class Cost, class Graph>
[[gnu::cold]] std::string overestimates(const Graph& g, const VertexOf<Graph>& v, Guess estimate, Cost truth) {
    return "the heuristic overestimates at node " + name_of_vertex(v, g) + ": h is " + name_of_cost(estimate, g) +
           ", the true cost to the goal is " + name_of_cost(truth, g);
}
/// The weights among policies, or none.
template <class... Policies> auto weights_among(const Policies&... policies) {
    static_assert(
        (true && ... && (HasRole<Policies, roles::Weights> || HasRole<Policies, roles::Cost>)),
        "Ansatz paths: to check a heuristic takes WeightsOf{map} and CostIn<Number>{} beside it, as the search "
        "has them");
    return take<roles::Weights, NotGiven>(policies...);
}
/// The number that a search with these policies counts in.
template <class Graph, class... Policies>
using CostWith =
    typename pick<roles::Cost, CostIn<typename NaturalCost<Graph, pick<roles::Weights, NotGiven, Policies...>>::type>,
                  Policies...>::type;
} // namespace detail

/// The node at which a heuristic is most above the true cost; none if it never is. It is judged as a search with the
/// same policies would use it: `check_heuristic(map, Octile{}, goal)`, `check_heuristic(roads, h, goal,
/// WeightsOf{lengths})`.
/// \tparam Number   in which to estimate; without it that of the search: on a Grid whole, 33461 a tile
/// \param policies  `WeightsOf{map}` and `CostIn<Number>{}`, where the search has them
template <class Number = void, class Graph, class Heuristic, class... Policies>
std::optional<Overestimate<VertexOf<Graph>>> check_heuristic(const Graph& g, const Heuristic& heuristic,
                                                             const GoalOf<Graph>& goal, const Policies&... policies) {
    using Cost =
        typename std::conditional_t<std::is_void_v<Number>, std::type_identity<detail::CostWith<Graph, Policies...>>,
                                    std::type_identity<Number>>::type;
    const auto costs = true_costs<Cost>(g, goal, Toward::to_it, detail::weights_among(policies...));
    const auto estimate = heuristic.template bind<Cost>(g, goal);
    using Guess = detail::Guess<Cost, std::decay_t<decltype(estimate(goal))>>;
    const auto index = detail::index_of(g);
    std::optional<Overestimate<VertexOf<Graph>>> worst;
    const auto all = vertices(g);
    for (auto at = all.first; at != all.second; ++at) {
        const VertexOf<Graph> v = *at;
        const Cost truth = costs[std::size_t(get(index, v))];
        const Guess h = Guess(estimate(v));
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
template <class Heuristic, class Given = detail::NotGiven> struct Checked {
    using role = roles::Heuristic;
    /// Whether it judges by weights that it was given, as the search must be too.
    static constexpr bool knows_weights = !std::is_same_v<Given, detail::NotGiven>;
    Heuristic of;            ///< the one that is watched
    HeuristicReport* report; ///< what it has seen is written there
    Given given;             ///< the weights of the search, where the graph's own are not meant
    /// Watches h; the report must live as long.
    /// \param weights `WeightsOf{map}`, where the search has one
    Checked(Heuristic h, HeuristicReport& r, Given weights = {}) : of(h), report(&r), given(weights) {}
    template <class Cost, class Graph> auto bind(const Graph& g, const GoalOf<Graph>& goal) const {
        auto costs = std::make_shared<std::vector<Cost>>(true_costs<Cost>(g, goal, Toward::to_it, given));
        return [&g, costs, h = of.template bind<Cost>(g, goal), seen = report](const VertexOf<Graph>& v) {
            using Guess = detail::Guess<Cost, std::decay_t<decltype(h(v))>>;
            const Guess estimate = Guess(h(v));
            const Cost truth = (*costs)[std::size_t(get(detail::index_of(g), v))];
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
/// `Checked{heuristic, report}`.
template <class Heuristic> Checked(Heuristic, HeuristicReport&) -> Checked<Heuristic>;
/// `Checked{heuristic, report, WeightsOf{map}}`.
template <class Heuristic, class Given> Checked(Heuristic, HeuristicReport&, Given) -> Checked<Heuristic, Given>;

} // namespace ansatz::paths
