// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <vector>

namespace exercise {

/// A hierarchy: the parent of each state. State 0 is the machine itself, around all others; it has no parent: -1.
using Parents = std::vector<int>;

/// 5.3: the innermost state that is around both, and is neither of them.
inline int around_both(const Parents& parents, int source, int target) {
    return todo(1);
}

/// What a transition leaves and enters, in order.
struct Way {
    std::vector<int> left, entered;
};
/// The way of a transition: from `source`, an innermost state, out to the state around both, and in to `target`.
inline Way way(const Parents& parents, int source, int target) {
    return todo(2);
}

/// A transition on a condition.
struct Transition {
    int source;
    bool holds; ///< whether its condition holds now
};
/// Which transition an update takes, by its number; -1 for none. The active innermost state is asked first, then its
/// parent, and so on; of the transitions of one state the first that holds is taken.
inline int taken(const Parents& parents, int innermost, const std::vector<Transition>& transitions) {
    return todo(3);
}

} // namespace exercise
