// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <utility>
#include <vector>

namespace exercise {

/// Bodies, by number from 0, and the springs between them, which are at rest.
struct Net {
    std::vector<bool> held; ///< of each body
    std::vector<std::pair<std::size_t, std::size_t>> springs;
};

/// 4.2: who has moved after another step.
inline std::vector<bool> one_step(const Net& net, const std::vector<bool>& moved) {
    // task 1: return todo(1);
    std::vector<bool> next = moved;
    for (const auto& [a, b] : net.springs) {
        if (moved[a] && !net.held[b]) next[b] = true;
        if (moved[b] && !net.held[a]) next[a] = true;
    }
    return next;
    // end of task 1
}

/// 4.2: in which step each body moves first, if `from` was moved before all of them; -1 for never.
inline std::vector<int> first_steps(const Net& net, std::size_t from) {
    // task 2: return todo(2);
    std::vector<int> first(net.held.size(), -1);
    std::vector<bool> moved(net.held.size(), false);
    moved[from] = true;
    for (int step = 0; step <= int(net.held.size()); ++step) {
        for (std::size_t i = 0; i < moved.size(); ++i)
            if (moved[i] && first[i] < 0) first[i] = step;
        moved = one_step(net, moved);
    }
    return first;
    // end of task 2
}

} // namespace exercise
