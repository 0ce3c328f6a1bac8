// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: every state follows a noise
// Why:     The event was handled without asking in which state it came: a chase ends because something fell over.
// Read:    5.1.1
// Fails:   noise

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
}

/// The state after a noise was heard.
inline State heard(State now) {
    return State::search;
}

} // namespace exercise
