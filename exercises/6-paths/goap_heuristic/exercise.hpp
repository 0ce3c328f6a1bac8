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
    return todo(1);
}

/// A cost that no plan from this state to the goal is below: the least that one fact of the goal costs, for each that
/// is not as the goal wants it. 0 where no action meets any.
inline double estimate(State state, const Goal& goal, const std::vector<Action>& actions) {
    return todo(2);
}

} // namespace exercise
