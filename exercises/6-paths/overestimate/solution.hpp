// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace exercise {

/// A step from one node to another, and what it costs. It leads one way: the way back is another edge.
struct Edge {
    std::size_t from, to;
    double cost; ///< not negative
};

constexpr std::size_t nobody = std::size_t(-1);

/// 6.1.1: the node at which h is most above the true cost of the way to the goal, the first of several; `nobody` where
/// h is admissible. Both lists are by node. From where no way leads to the goal, the true cost is infinite.
inline std::size_t worst_overestimate(const std::vector<double>& h, const std::vector<double>& true_cost) {
    // task 1: return todo(1);
    std::size_t worst = nobody;
    double most = 0;
    for (std::size_t v = 0; v < h.size(); ++v) {
        const double above = h[v] - true_cost[v];
        if (above > most) most = above, worst = v;
    }
    return worst;
    // end of task 1
}

/// Whether h is consistent: it falls along no edge by more than that edge costs.
inline bool consistent(const std::vector<Edge>& edges, const std::vector<double>& h) {
    // task 2: return todo(2);
    for (const Edge& e : edges)
        if (h[e.from] > e.cost + h[e.to]) return false;
    return true;
    // end of task 2
}

/// The largest number w, but no more than 1, with which w h is consistent.
inline double factor(const std::vector<Edge>& edges, const std::vector<double>& h) {
    // task 3: return todo(3);
    double w = 1;
    for (const Edge& e : edges) {
        const double fall = h[e.from] - h[e.to];
        if (fall > 0) w = std::min(w, e.cost / fall);
    }
    return w;
    // end of task 3
}

} // namespace exercise
