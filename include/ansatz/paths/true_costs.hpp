// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `true_costs`: what it really costs to get from every vertex to one, or from one to every other; the reference that
/// heuristics are held against, and what landmarks are made of. It visits the whole graph: not for every frame.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/heap.hpp>

#include <cstddef>
#include <vector>

namespace ansatz::paths {

/// Which way the costs are meant.
enum class Toward : bool {
    to_it,   ///< from every vertex to the one
    from_it, ///< from the one to every vertex
};

namespace detail {

/// The passable edges of a graph as one array, forwards or turned round.
template <class Graph, class Cost> struct EdgeTable {
    struct Half {
        std::size_t to;
        Cost weight;
    };
    std::vector<std::size_t> first;
    std::vector<Half> halves;

    template <class Given, class Use> static void each(const Graph& g, const Given& given, Use&& use) {
        const auto index = index_of(g);
        const auto weights = weights_of<Graph, Cost>(g, given);
        const auto all = vertices(g);
        for (auto v = all.first; v != all.second; ++v) {
            if (blocked(VertexOf<Graph>(*v), g)) continue;
            const auto edges = out_edges(*v, g);
            for (auto e = edges.first; e != edges.second; ++e) {
                const auto q = target(*e, g);
                const auto weight = get(weights, *e);
                if (edge_passable(*e, g) && !blocked(VertexOf<Graph>(q), g) && weight >= decltype(weight)(0))
                    use(std::size_t(get(index, *v)), std::size_t(get(index, q)), cost_of<Cost>(weight));
            }
        }
    }
    template <class Given> EdgeTable(const Graph& g, const Given& given, bool turned) : first(num_vertices(g) + 1) {
        each(g, given, [&](std::size_t p, std::size_t q, Cost) { ++first[(turned ? q : p) + 1]; });
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        halves.resize(first.back());
        auto next = first;
        each(g, given, [&](std::size_t p, std::size_t q, Cost w) {
            halves[next[turned ? q : p]++] = {turned ? p : q, w};
        });
    }
};
} // namespace detail

/// The true cost between one vertex and each, by the vertex' number; the dearest cost there is where there is no way.
/// By Dijkstra's algorithm on all of the graph.
/// \tparam Cost the number to calculate in
/// \tparam Graph numbered, and a VertexListGraph
/// \param given  `WeightsOf{map}`, where the search has one
template <class Cost = double, class Graph, class Given = detail::NotGiven>
std::vector<Cost> true_costs(const Graph& g, const VertexOf<Graph>& one, Toward toward = Toward::to_it,
                             const Given& given = {}) {
    static_assert(detail::AsksForWeights<Graph, Given>::ok);
    static_assert(detail::IsNumbered<Graph>,
                  "Ansatz paths: true_costs needs a graph whose vertices are numbered and listed");
    std::vector<Cost> costs(num_vertices(g), detail::infinite<Cost>);
    if (detail::blocked(one, g)) return costs;
    const detail::EdgeTable<Graph, Cost> edges(g, given, toward == Toward::to_it);
    typename Heap::In<Cost, std::size_t> queue{Heap{}};
    const std::size_t start = get(detail::index_of(g), one);
    costs[start] = Cost(0);
    queue.push(Cost(0), Cost(0), start);
    std::vector<bool> done(costs.size());
    while (!queue.empty()) {
        const std::size_t p = queue.pop();
        if (done[p]) continue;
        done[p] = true;
        for (std::size_t i = edges.first[p]; i < edges.first[p + 1]; ++i) {
            const auto& half = edges.halves[i];
            const Cost cost = detail::add(costs[p], half.weight);
            if (!(cost < costs[half.to])) continue;
            costs[half.to] = cost;
            queue.push(cost, Cost(0), half.to);
        }
    }
    return costs;
}

} // namespace ansatz::paths
