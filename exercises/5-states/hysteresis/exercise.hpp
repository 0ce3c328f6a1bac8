// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/units.hpp>

using namespace ansatz;

namespace exercise {

/// 5.2.3: whether a machine is "above" after an update, with a band of hysteresis around a threshold. It becomes above
/// when the value is more than `half_width` above the threshold, below when it is more than that below, and stays what
/// it is in between. `above` is what it was.
inline bool above_after(bool above, Quantity<unit::Length> value, Quantity<unit::Length> threshold,
                        Quantity<unit::Length> half_width) {
    return todo(1);
}

/// A state that turns no faster than its dwell time allows, however often it is asked to.
class Dwelling {
public:
    explicit Dwelling(Quantity<unit::Time> dwell) : dwell_(dwell) {}

    /// One update of length `dt`, in which the machine would like to be in the other state, or not. It turns when it
    /// wants to and has been in its state for the dwell time; answers whether it turned.
    bool update(bool wants_to_turn, Quantity<unit::Time> dt) {
        return todo(2);
    }

private:
    Quantity<unit::Time> dwell_;
    Quantity<unit::Time> in_state_{};
};

} // namespace exercise
