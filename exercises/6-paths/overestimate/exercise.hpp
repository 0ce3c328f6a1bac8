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
    return todo(1);
}

/// Whether h is consistent: it falls along no edge by more than that edge costs.
inline bool consistent(const std::vector<Edge>& edges, const std::vector<double>& h) {
    return todo(2);
}

/// The largest number w, but no more than 1, with which w h is consistent.
inline double factor(const std::vector<Edge>& edges, const std::vector<double>& h) {
    return todo(3);
}

} // namespace exercise
