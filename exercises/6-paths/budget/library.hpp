// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its AStar in slices and given up, and Weighted.
#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/heuristics/weighted.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace exercise {

struct Edge {
    std::size_t to;
    double cost;
};
using Graph = std::vector<std::vector<Edge>>;
enum class Outcome { running, found, no_path };
struct Looked {
    std::size_t node;
    double g, h;
};

using Roads = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                    boost::property<boost::edge_weight_t, double>>;
using Estimate = ansatz::paths::By<std::function<double(std::size_t)>>;

/// What an AStar reads, which must stay where it is.
struct Running {
    Roads roads;
    ansatz::paths::AStar<Roads, Estimate> search;
    Running(Roads r, const std::vector<double>& h)
        : roads(std::move(r)), search(roads, Estimate{[h](std::size_t v) { return h[v]; }}) {}
};
struct Search {
    std::shared_ptr<Running> running;
    std::size_t goal;
    std::vector<double> g;
    std::vector<std::size_t> closed;
};
inline Search begin(const Graph& graph, const std::vector<double>& h, std::size_t start, std::size_t goal) {
    Roads roads(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v)
        for (const Edge& edge : graph[v]) add_edge(v, edge.to, edge.cost, roads);
    Search s{std::make_shared<Running>(roads, h), goal, std::vector<double>(graph.size()), {}};
    s.running->search.begin(start, goal);
    return s;
}
inline Outcome advance(Search& s, std::size_t most) {
    auto& search = s.running->search;
    const auto outcome = search.advance(most);
    s.closed = search.closed_list();
    for (std::size_t v = 0; v < s.g.size(); ++v)
        s.g[v] = search.node(v) ? search.node(v)->g : std::numeric_limits<double>::infinity();
    if (outcome == ansatz::paths::Outcome::found) return Outcome::found;
    // Its heap may hold old entries of nodes that are closed, by which it says only in the next slice that all is done.
    return search.open_list().empty() ? Outcome::no_path : Outcome::running;
}
/// By a search along a road on which one node comes after the other, to a goal to which none leads.
inline std::size_t nearest(const std::vector<Looked>& closed) {
    const std::size_t count = closed.size();
    Roads road(count + 2);
    for (std::size_t i = 0; i < count; ++i) add_edge(i, i + 1, 0.0, road);
    const Estimate estimate{[&](std::size_t i) { return i < count ? closed[i].h : 0; }};
    ansatz::paths::AStar search{road, estimate};
    search.find(std::size_t(0), count + 1, count);
    return closed[search.path().back()].node;
}
/// By a search that comes over an edge of the cost g to a node with this h.
inline double weighted_f(double g, double h, double w) {
    Roads road(3);
    add_edge(0, 1, g, road);
    ansatz::paths::AStar search{road, ansatz::paths::Weighted{Estimate{[h](std::size_t) { return h; }}, w}};
    search.begin(0, 2);
    search.advance(1);
    return search.node(1)->f();
}

} // namespace exercise
