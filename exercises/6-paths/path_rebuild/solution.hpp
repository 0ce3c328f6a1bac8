// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace exercise {

constexpr std::size_t nobody = std::size_t(-1);

/// 6.1: from the goal by the parents to the start, both included; empty if the search has not come to the goal.
inline std::vector<std::size_t> way_back(const std::vector<std::size_t>& parents, std::size_t goal) {
    // task 1: return todo(1);
    std::vector<std::size_t> way;
    if (parents[goal] == nobody) return way;
    std::size_t v = goal;
    way.push_back(v);
    while (parents[v] != v) {
        v = parents[v];
        way.push_back(v);
    }
    return way;
    // end of task 1
}

/// The same from the start to the goal.
inline std::vector<std::size_t> path(const std::vector<std::size_t>& parents, std::size_t goal) {
    // task 2: return todo(2);
    std::vector<std::size_t> way = way_back(parents, goal);
    std::reverse(way.begin(), way.end());
    return way;
    // end of task 2
}

} // namespace exercise
