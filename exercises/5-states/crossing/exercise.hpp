// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/units.hpp>

#include <cmath>

using namespace ansatz;

namespace exercise {

/// 5.2.1: whether a value that was `before` at the previous update and is `now` at this one has gone through a limit,
/// in either direction. It has when it was beside the limit and is on it or on its other side now.
inline bool crossed(Quantity<unit::Length> before, Quantity<unit::Length> now, Quantity<unit::Length> limit) {
    return todo(1);
}

/// A guard that sees a value at every update.
class CrossingGuard {
public:
    explicit CrossingGuard(Quantity<unit::Length> limit) : limit_(limit) {}

    /// The value of the next update, and whether it has crossed the limit since the last one. The first value has no
    /// predecessor and has crossed nothing. A value that is not a number is passed over: it crosses nothing, and the
    /// next one is held against the last good one.
    bool update(Quantity<unit::Length> now) {
        return todo(2);
    }

private:
    Quantity<unit::Length> limit_;
    Quantity<unit::Length> previous_{};
    bool known_ = false;
};

} // namespace exercise
