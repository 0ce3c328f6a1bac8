// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: only the innermost state was asked
// Why:     Its parents are active too. Without them a hierarchy is a flat machine with most of its transitions gone.
// Read:    5.3
// Fails:   all, inner, first

#include <algorithm>
#include <vector>

namespace exercise {

/// A hierarchy: the parent of each state. State 0 is the machine itself, around all others; it has no parent: -1.
using Parents = std::vector<int>;

/// 5.3: the innermost state that is around both, and is neither of them.
inline int around_both(const Parents& parents, int source, int target) {
    int around = parents[std::size_t(source)];
    const auto is_around_target = [&](int state) {
        for (int s = parents[std::size_t(target)]; s >= 0; s = parents[std::size_t(s)])
            if (s == state) return true;
        return false;
    };
    while (!is_around_target(around)) around = parents[std::size_t(around)];
    return around;
}

/// What a transition leaves and enters, in order.
struct Way {
    std::vector<int> left, entered;
};
/// The way of a transition: from `source`, an innermost state, out to the state around both, and in to `target`.
inline Way way(const Parents& parents, int source, int target) {
    Way way;
    const int around = around_both(parents, source, target);
    for (int s = source; s != around; s = parents[std::size_t(s)]) way.left.push_back(s);
    for (int s = target; s != around; s = parents[std::size_t(s)]) way.entered.push_back(s);
    std::reverse(way.entered.begin(), way.entered.end());
    return way;
}

/// A transition on a condition.
struct Transition {
    int source;
    bool holds; ///< whether its condition holds now
};
/// Which transition an update takes, by its number; -1 for none. The active innermost state is asked first, then its
/// parent, and so on; of the transitions of one state the first that holds is taken.
inline int taken(const Parents& parents, int innermost, const std::vector<Transition>& transitions) {
    if (const int s = innermost; s >= 0)
        for (std::size_t i = 0; i < transitions.size(); ++i)
            if (transitions[i].source == s && transitions[i].holds) return int(i);
    return -1;
}

} // namespace exercise
