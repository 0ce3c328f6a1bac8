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
    return todo(1);
}

/// The same from the start to the goal.
inline std::vector<std::size_t> path(const std::vector<std::size_t>& parents, std::size_t goal) {
    return todo(2);
}

} // namespace exercise
