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
    // task 1: return todo(1);
    auto sum = 0.0 * square_metre;
    for (const Column& column : columns) sum += column.part * column.footprint;
    std::vector<double> all;
    for (const Column& column : columns) all.push_back(column.part * column.footprint / sum);
    return all;
    // end of task 1
}

/// 7.4: raises the columns by their shares of a volume.
inline void press_up(Columns& columns, Quantity<unit::Volume> volume) {
    // task 2: todo(2);
    const auto all = shares(columns);
    for (std::size_t n = 0; n < columns.size(); ++n) columns[n].height += all[n] * volume / columns[n].footprint;
    // end of task 2
}

/// 7.4: how high the water stands around the body, in m.
inline Quantity<unit::Length> level(const Columns& columns) {
    // task 3: return todo(3);
    const auto all = shares(columns);
    auto sum = 0.0 * metre;
    for (std::size_t n = 0; n < columns.size(); ++n) sum += all[n] * columns[n].height;
    return sum;
    // end of task 3
}

/// 7.4: what an upright box displaces whose bottom is at that height, in m^3; the columns are as without it.
inline Quantity<unit::Volume> displaced(const Columns& columns, Quantity<unit::Area> section,
                                        Quantity<unit::Length> bottom) {
    // task 4: return todo(4);
    Columns raised = columns;
    press_up(raised, 1.0 * cubic_metre);
    const Quantity<unit::InverseArea> feedback = (level(raised) - level(columns)) / (1.0 * cubic_metre);
    const auto depth = max(0.0 * metre, level(columns) - bottom);
    return section * depth / (1.0 - section * feedback);
    // end of task 4
}

} // namespace exercise
