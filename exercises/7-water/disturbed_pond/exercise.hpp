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
    return todo(1);
}

/// 7.3.1: how many rings begin in an update that brings the time since somebody has entered from `before` to `now`, one
/// at each stride.
inline int begun(Quantity<unit::Time> before, Quantity<unit::Time> now, Quantity<unit::Time> stride) {
    return todo(2);
}

/// 7.3.1: whether a ring that began so long ago has less than a thousandth of its height left.
inline bool faded(Quantity<unit::Time> age, Quantity<unit::Frequency> damping) {
    return todo(3);
}

} // namespace exercise
