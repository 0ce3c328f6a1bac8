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
    return todo(1);
}

/// 4.2: in which step each body moves first, if `from` was moved before all of them; -1 for never.
inline std::vector<int> first_steps(const Net& net, std::size_t from) {
    return todo(2);
}

} // namespace exercise
