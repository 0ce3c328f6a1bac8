// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace exercise {

/// An edge leads to a node and costs something. A graph is a list of them for each node.
struct Edge {
    std::size_t to;
    double cost;
};
using Graph = std::vector<std::vector<Edge>>;

/// All that a search knows, so that it can be left and taken up again in the next frame.
struct Search {
    Graph graph;
    std::vector<double> h; ///< of each node, never too much
    std::size_t start, goal;
    std::vector<double> g;                                    ///< of each node; infinite where none is known yet
    std::set<std::tuple<double, double, std::size_t>> open{}; ///< f, h, node; the most promising one first
    std::vector<std::size_t> closed{};                        ///< in the order in which they came
};
/// A search that has the start on its open list, and has expanded nothing yet.
inline Search begin(Graph graph, std::vector<double> h, std::size_t start, std::size_t goal) {
    const std::size_t nodes = graph.size();
    Search s{std::move(graph), std::move(h), start, goal,
             std::vector<double>(nodes, std::numeric_limits<double>::infinity())};
    s.g[start] = 0;
    s.open.insert({s.h[start], s.h[start], start});
    return s;
}
/// Moves the most promising node from the open list, on which there must be one, to the closed list.
/// \return this node
inline std::size_t take(Search& s) {
    const std::size_t p = std::get<2>(*s.open.begin());
    s.open.erase(s.open.begin());
    s.closed.push_back(p);
    return p;
}
/// Follows all edges that lead out of a node, which puts their ends on the open list: this is what costs the time.
inline void expand(Search& s, std::size_t p) {
    for (const Edge& edge : s.graph[p]) {
        const double g = s.g[p] + edge.cost, h = s.h[edge.to];
        if (!(g < s.g[edge.to])) continue;
        s.open.erase({s.g[edge.to] + h, h, edge.to});
        s.open.insert({g + h, h, edge.to});
        s.g[edge.to] = g;
    }
}

enum class Outcome {
    running, ///< the budget is used up, and it goes on in the next frame
    found,   ///< the goal was taken from the open list
    no_path  ///< the goal was not, and nothing is left on the open list
};
/// 6.3.3: goes on with a search, and expands up to `most` nodes. The goal itself need not be expanded. Is not called
/// any more when it has found the goal, or that there is no path.
inline Outcome advance(Search& s, std::size_t most) {
    return todo(1);
}

/// A node of the closed list.
struct Looked {
    std::size_t node;
    double g, h;
};
/// Where to go when a search is given up: to the node, of those that it has expanded, from which the rest of the way
/// is estimated to be the shortest; of several to the one that was expanded first. There is one at least, the start.
inline std::size_t nearest(const std::vector<Looked>& closed) {
    return todo(2);
}

/// The f by which a search in a hurry takes its nodes from the open list: the estimate counts w times.
inline double weighted_f(double g, double h, double w) {
    return todo(3);
}

} // namespace exercise
