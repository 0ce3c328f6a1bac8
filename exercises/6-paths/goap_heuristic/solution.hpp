// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace exercise {

/// A bit for each fact that holds.
using State = std::uint64_t;

/// The facts in `care` should be as they are in `value`.
struct Goal {
    State value = 0, care = 0;
};
/// Sets the facts in `care` to what they are in `value`, for a cost.
struct Action {
    State value = 0, care = 0;
    double cost = 1;
};

/// 6.2: how many facts are not as the goal wants them.
inline int unmet(State state, const Goal& goal) {
    // task 1: return todo(1);
    return std::popcount((state ^ goal.value) & goal.care);
    // end of task 1
}

/// A cost that no plan from this state to the goal is below: the least that one fact of the goal costs, for each that
/// is not as the goal wants it. 0 where no action meets any.
inline double estimate(State state, const Goal& goal, const std::vector<Action>& actions) {
    // task 2: return todo(2);
    double least = std::numeric_limits<double>::infinity();
    for (const Action& a : actions) {
        const int met = std::popcount(a.care & goal.care & ~(a.value ^ goal.value));
        if (met > 0 && a.cost / met < least) least = a.cost / met;
    }
    if (least == std::numeric_limits<double>::infinity()) return 0;
    return unmet(state, goal) * least;
    // end of task 2
}

} // namespace exercise
