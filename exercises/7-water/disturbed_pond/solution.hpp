// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/units.hpp>

#include <cmath>
#include <cstddef>

using namespace ansatz;

namespace exercise {

/// What the pond is.
enum class State { calm, stirred, settling };

/// 7.3.1: the state after an update: whether somebody wades now, and how many rings are left.
inline State next(State now, bool somebody_wades, std::size_t rings) {
    // task 1: return todo(1);
    switch (now) {
    case State::calm:
        if (somebody_wades) return State::stirred;
        break;
    case State::stirred:
        if (!somebody_wades) return State::settling;
        break;
    case State::settling:
        if (somebody_wades) return State::stirred;
        if (rings == 0) return State::calm;
        break;
    }
    return now;
    // end of task 1
}

/// 7.3.1: how many rings begin in an update that brings the time since somebody has entered from `before` to `now`, one
/// at each stride.
inline int begun(Quantity<unit::Time> before, Quantity<unit::Time> now, Quantity<unit::Time> stride) {
    // task 2: return todo(2);
    return int(std::floor(double(now / stride))) - int(std::floor(double(before / stride)));
    // end of task 2
}

/// 7.3.1: whether a ring that began so long ago has less than a thousandth of its height left.
inline bool faded(Quantity<unit::Time> age, Quantity<unit::Frequency> damping) {
    // task 3: return todo(3);
    return std::exp(-double(damping * age)) < 1e-3;
    // end of task 3
}

} // namespace exercise
