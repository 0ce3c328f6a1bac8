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
    // task 1: return todo(1);
    auto sum = 0.0 * cubic_metre;
    for (const Column& column : columns) sum += column.height * column.footprint;
    return sum;
    // end of task 1
}

/// 7.2.3: brings all heights into the range, and returns what was cut off above less what was filled in below, in m^3.
inline Quantity<unit::Volume> cut(Columns& columns, Quantity<unit::Length> low, Quantity<unit::Length> high) {
    // task 2: return todo(2);
    auto sum = 0.0 * cubic_metre;
    for (Column& column : columns) {
        const auto kept = max(low, min(column.height, high));
        sum += (column.height - kept) * column.footprint;
        column.height = kept;
    }
    return sum;
    // end of task 2
}

/// 7.2.3: the same, and spreads what was cut off over the columns that have room; returns what none has room for.
inline Quantity<unit::Volume> clamp(Columns& columns, Quantity<unit::Length> low, Quantity<unit::Length> high) {
    // task 3: return todo(3);
    auto left = cut(columns, low, high);
    for (std::size_t pass = 0; pass < columns.size(); ++pass) {
        auto has_room = [&](const Column& column) {
            return left > 0.0 * cubic_metre ? column.height < high : column.height > low;
        };
        auto room = 0.0 * square_metre;
        for (const Column& column : columns)
            if (has_room(column)) room += column.footprint;
        if (left == 0.0 * cubic_metre || room == 0.0 * square_metre) break;
        const auto more = left / room;
        for (Column& column : columns)
            if (has_room(column)) column.height += more;
        left = cut(columns, low, high);
    }
    return left;
    // end of task 3
}

} // namespace exercise
