// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the whole path, from its beginning
// Why:     What lies behind the walker does not matter any more. Every gate that closes behind it is a search for
//          nothing.
// Read:    6.3.5
// Fails:   behind, no-better

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
    if (!(event.after > event.before)) return false;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        if (path[i] == event.from && path[i + 1] == event.to) return true;
    return false;
}

/// Whether there may be a better path than the rest of this one.
inline bool should_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    return must_search(path, at, event) || event.after < event.before;
}

} // namespace exercise
