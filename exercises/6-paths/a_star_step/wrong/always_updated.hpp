// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: g and parent of a known node change, cheaper or not
// Why:     Whoever looks last wins. A detour overwrites the better way that was known.
// Read:    6.1
// Fails:   not-cheaper, whole

#include <cstddef>
#include <vector>

namespace exercise {

enum class List { none, open, closed };
constexpr std::size_t nobody = std::size_t(-1);

/// 6.1: what A* knows of a node.
struct Node {
    List list = List::none;
    double g = 0;                ///< what the cheapest known way from the start costs
    double h = 0;                ///< what the way to the goal is estimated to cost
    std::size_t parent = nobody; ///< the node before it on the cheapest known way
    double f() const { return g + h; }
};

/// 2: the node of the open list with the least f; of several the one with the least h, and of those the first. `nobody`
/// if the open list is empty.
inline std::size_t most_promising(const std::vector<Node>& nodes) {
    std::size_t best = nobody;
    for (std::size_t v = 0; v < nodes.size(); ++v) {
        const Node& n = nodes[v];
        if (n.list != List::open) continue;
        if (best == nobody || n.f() < nodes[best].f() || (n.f() == nodes[best].f() && n.h < nodes[best].h)) best = v;
    }
    return best;
}

/// 2.3: P is on the closed list, an edge leads from P to Q and costs `weight`; `h` is the estimate for Q.
inline void look_at(std::vector<Node>& nodes, std::size_t p, std::size_t q, double weight, double h) {
    const bool known = nodes[q].list != List::none;
    if (!known) nodes[q].h = h;
    nodes[q].g = nodes[p].g + weight;
    nodes[q].parent = p;
    nodes[q].list = List::open;
}

} // namespace exercise
