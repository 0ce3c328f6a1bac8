// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

struct Column {
    Quantity<unit::Length> height;  ///< of the water in it
    Quantity<unit::Area> footprint; ///< on which it stands
    double part;                    ///< how much of it belongs to the ring, 0 to 1
};
using Columns = std::vector<Column>;

/// 7.4: how much of the water goes into each column; 1 in sum.
inline std::vector<double> shares(const Columns& columns) {
    return todo(1);
}

/// 7.4: raises the columns by their shares of a volume.
inline void press_up(Columns& columns, Quantity<unit::Volume> volume) {
    todo(2);
}

/// 7.4: how high the water stands around the body, in m.
inline Quantity<unit::Length> level(const Columns& columns) {
    return todo(3);
}

/// 7.4: what an upright box displaces whose bottom is at that height, in m^3; the columns are as without it.
inline Quantity<unit::Volume> displaced(const Columns& columns, Quantity<unit::Area> section,
                                        Quantity<unit::Length> bottom) {
    return todo(4);
}

} // namespace exercise
