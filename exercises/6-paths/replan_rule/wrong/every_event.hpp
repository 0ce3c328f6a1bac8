// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: every event that makes something dearer
// Why:     Most of the map is not on the path. What became dearer elsewhere makes no other path better.
// Read:    6.3.5
// Fails:   behind, elsewhere, direction, no-better

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
    return event.after > event.before;
}

/// Whether there may be a better path than the rest of this one.
inline bool should_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    return must_search(path, at, event) || event.after < event.before;
}

} // namespace exercise
