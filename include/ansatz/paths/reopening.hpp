// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What becomes of a node on the closed list when a cheaper way to it is found: three policies.
///
/// It happens only where the heuristic is inconsistent (from one node to the next it falls by more than the edge
/// costs). The notes' step 2.3.3 updates such a node and leaves it closed. With an admissible but inconsistent
/// heuristic that is not enough: what had been reached *through* the node keeps its old, dearer cost.

#include <ansatz/paths/roles.hpp>

namespace ansatz::paths {

/// Back to the open list, to be expanded again (the default): optimal with every admissible heuristic.
struct Reopening {
    using role = roles::Reopening;
    /// Whether a closed node gets the cheaper g and parent.
    static constexpr bool updates = true, reopens = true; ///< whether it goes back to the open list
};
/// Left alone: for weighted searches, which stay within their weight of the best path and would only lose time.
struct NoReopening {
    using role = roles::Reopening;
    /// Whether a closed node gets the cheaper g and parent.
    static constexpr bool updates = false, reopens = false; ///< whether it goes back to the open list
};
/// The notes to the letter: g and parent change, the node stays closed. To see what goes wrong; not to be used.
struct UpdateClosed {
    using role = roles::Reopening;
    /// Whether a closed node gets the cheaper g and parent.
    static constexpr bool updates = true, reopens = false; ///< whether it goes back to the open list
};

} // namespace ansatz::paths
