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
    // task 1: return todo(1);
    switch (now) {
    case State::patrol:
        if (distance < 7.0 * metre) return State::chase;
        break;
    case State::search:
        if (distance < 7.0 * metre) return State::chase;
        if (in_state >= 3.0 * second) return State::patrol;
        break;
    case State::chase:
        if (distance < 1.0 * metre) return State::strike;
        if (distance > 9.0 * metre) return State::search;
        break;
    case State::strike:
        if (in_state >= 2.0 * second) return State::chase;
        break;
    }
    return now;
    // end of task 1
}

/// The state after a noise was heard.
inline State heard(State now) {
    // task 2: return todo(2);
    return now == State::patrol ? State::search : now;
    // end of task 2
}

} // namespace exercise
