// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: one distance for seeing and for losing
// Why:     8 m for both: an intruder who steps to and fro there changes the state with every step. The band from 7 m to
//          9 m is there for that.
// Read:    5.2.3
// Fails:   sees, chase

#include <ansatz/units.hpp>

using namespace ansatz;

namespace exercise {

/// What the guard is doing.
enum class State { patrol, search, chase, strike };

/// 5.1.1: the state after an update, by the conditions of the present one. `distance` is that to the intruder; `in_state`
/// is how long the guard has been in the present state.
inline State next(State now, Quantity<unit::Length> distance, Quantity<unit::Time> in_state) {
    switch (now) {
        case State::patrol:
            if (distance < 8.0 * metre) return State::chase;
            break;
        case State::search:
            if (distance < 8.0 * metre) return State::chase;
            if (in_state >= 3.0 * second) return State::patrol;
            break;
        case State::chase:
            if (distance < 1.0 * metre) return State::strike;
            if (distance > 8.0 * metre) return State::search;
            break;
        case State::strike:
            if (in_state >= 2.0 * second) return State::chase;
            break;
    }
    return now;
}

/// The state after a noise was heard.
inline State heard(State now) {
    return now == State::patrol ? State::search : now;
}

} // namespace exercise
