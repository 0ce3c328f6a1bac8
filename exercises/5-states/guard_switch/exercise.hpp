// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/units.hpp>

using namespace ansatz;

namespace exercise {

/// What the guard is doing.
enum class State { patrol, search, chase, strike };

/// 5.1.1: the state after an update, by the conditions of the present one. `distance` is that to the intruder;
/// `in_state` is how long the guard has been in the present state.
inline State next(State now, Quantity<unit::Length> distance, Quantity<unit::Time> in_state) {
    return todo(1);
}

/// The state after a noise was heard.
inline State heard(State now) {
    return todo(2);
}

} // namespace exercise
