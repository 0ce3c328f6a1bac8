// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/heuristics/by.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <vector>

namespace exercise {

enum class List { none, open, closed };
constexpr std::size_t nobody = std::size_t(-1);

struct Node {
    List list = List::none;
    double g = 0;
    double h = 0;
    std::size_t parent = nobody;
    double f() const { return g + h; }
};

/// The library keeps its open list in a heap. It takes whichever of several equal nodes it likes; by f, then by h.
inline std::size_t most_promising(const std::vector<Node>& nodes) {
    struct Nothing {};
    ansatz::paths::Heap::In<double, std::size_t> heap{ansatz::paths::Heap{}};
    heap.begin(Nothing{});
    for (std::size_t v = nodes.size(); v-- > 0;)
        if (nodes[v].list == List::open) heap.push(nodes[v].f(), nodes[v].h, v);
    if (heap.empty()) return nobody;
    const std::size_t best = heap.pop();
    for (std::size_t v = 0; v < best; ++v) // of equal ones the first, as the exercise has it
        if (nodes[v].list == List::open && nodes[v].f() == nodes[best].f() && nodes[v].h == nodes[best].h) return v;
    return best;
}

/// One turn of the library's loop, on a graph of this one edge, with its nodes as they are here.
inline void look_at(std::vector<Node>& nodes, std::size_t p, std::size_t q, double weight, double h) {
    using namespace ansatz::paths;
    using Weights = boost::property<boost::edge_weight_t, double>;
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Weights> graph(nodes.size() +
                                                                                                         1);
    add_edge(p, q, weight, graph);
    AStar turn{graph, By{[&](std::size_t v) { return v == q ? h : nodes[v < nodes.size() ? v : p].h; }}};
    turn.begin(p, nodes.size()); // to a goal that nobody comes to
    auto& search = turn.internals();
    const auto open = search.nodes.stamps().open(), closed = search.nodes.stamps().closed();
    search.nodes[p].g = nodes[p].g;
    if (nodes[q].list != List::none && q != p) {
        auto& node = search.nodes[q];
        node.g = nodes[q].g, node.h = nodes[q].h, node.parent = nodes[q].parent;
        node.stamp = nodes[q].list == List::open ? open : closed;
    }
    turn.advance(1);
    const auto* after = turn.node(q);
    if (!after || q == p) return;
    nodes[q].list = turn.is_open(q) ? List::open : List::closed;
    nodes[q].g = after->g, nodes[q].h = after->h, nodes[q].parent = after->parent;
}

} // namespace exercise
