// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the start is left out
// Why:     The loop stops when it comes to the start, and does not write it down. The walker jumps to the second
//          node.
// Read:    6.1
// Fails:   back, at-the-start, forwards

#include <algorithm>
#include <cstddef>
#include <vector>

namespace exercise {

constexpr std::size_t nobody = std::size_t(-1);

/// 6.1: from the goal by the parents to the start, both included; empty if the search has not come to the goal.
inline std::vector<std::size_t> way_back(const std::vector<std::size_t>& parents, std::size_t goal) {
    std::vector<std::size_t> way;
    if (parents[goal] == nobody) return way;
    for (std::size_t v = goal; parents[v] != v; v = parents[v]) way.push_back(v);
    return way;
}

/// The same from the start to the goal.
inline std::vector<std::size_t> path(const std::vector<std::size_t>& parents, std::size_t goal) {
    std::vector<std::size_t> way = way_back(parents, goal);
    std::reverse(way.begin(), way.end());
    return way;
}

} // namespace exercise
