// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <cstddef>
#include <vector>

namespace exercise {

/// What an edge cost, and what it costs now; infinite where it is blocked.
struct Event {
    std::size_t from = 0, to = 0;
    double before = 1, after = 1;
};

/// 6.3.5: whether the rest of the path is wrong now, for a walker who stands at path[at].
inline bool must_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    // task 1: return todo(1);
    if (!(event.after > event.before)) return false;
    for (std::size_t i = at; i + 1 < path.size(); ++i)
        if (path[i] == event.from && path[i + 1] == event.to) return true;
    return false;
    // end of task 1
}

/// Whether there may be a better path than the rest of this one.
inline bool should_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    // task 2: return todo(2);
    return must_search(path, at, event) || event.after < event.before;
    // end of task 2
}

} // namespace exercise
