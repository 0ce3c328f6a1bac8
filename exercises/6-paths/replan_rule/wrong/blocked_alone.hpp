// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: only what is blocked
// Why:     Mud is a reason too: the rest of the path costs more than was thought, and there may be a better one.
// Read:    6.3.5, 6.1.3
// Fails:   ahead, touched

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
    if (event.after < 1e300) return false;
    for (std::size_t i = at; i + 1 < path.size(); ++i)
        if (path[i] == event.from && path[i + 1] == event.to) return event.before < event.after;
    return false;
}

/// Whether there may be a better path than the rest of this one.
inline bool should_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    return must_search(path, at, event) || event.after < event.before;
}

} // namespace exercise
