// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

struct Column {
    Quantity<unit::Length> height;
    Quantity<unit::Area> footprint; ///< on which it stands
};
using Columns = std::vector<Column>;

/// 7.2: what all columns hold, in m^3.
inline Quantity<unit::Volume> volume(const Columns& columns) {
    return todo(1);
}

/// 7.2.3: brings all heights into the range, and returns what was cut off above less what was filled in below, in m^3.
inline Quantity<unit::Volume> cut(Columns& columns, Quantity<unit::Length> low, Quantity<unit::Length> high) {
    return todo(2);
}

/// 7.2.3: the same, and spreads what was cut off over the columns that have room; returns what none has room for.
inline Quantity<unit::Volume> clamp(Columns& columns, Quantity<unit::Length> low, Quantity<unit::Length> high) {
    return todo(3);
}

} // namespace exercise
