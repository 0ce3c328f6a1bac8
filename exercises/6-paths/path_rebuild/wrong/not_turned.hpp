// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: not turned round
// Why:     The parents lead from the goal to the start. Whoever walks that begins at the end.
// Read:    6.1
// Fails:   forwards, steps

#include <algorithm>
#include <cstddef>
#include <vector>

namespace exercise {

constexpr std::size_t nobody = std::size_t(-1);

/// 6.1: from the goal by the parents to the start, both included; empty if the search has not come to the goal.
inline std::vector<std::size_t> way_back(const std::vector<std::size_t>& parents, std::size_t goal) {
    std::vector<std::size_t> way;
    if (parents[goal] == nobody) return way;
    std::size_t v = goal;
    way.push_back(v);
    while (parents[v] != v) {
        v = parents[v];
        way.push_back(v);
    }
    return way;
}

/// The same from the start to the goal.
inline std::vector<std::size_t> path(const std::vector<std::size_t>& parents, std::size_t goal) {
    return way_back(parents, goal);
}

} // namespace exercise
