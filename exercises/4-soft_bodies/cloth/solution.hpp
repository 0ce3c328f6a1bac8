// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <utility>
#include <vector>

using namespace ansatz;

namespace exercise {

/// A flat sheet: vertex i + columns * j is in column i and row j.
struct Sheet {
    int columns, rows;             ///< how many vertices, at least 2 each
    Quantity<unit::Length> width;  ///< from column 0 to the last
    Quantity<unit::Length> height; ///< from row 0 to the last
};
using Springs = std::vector<std::pair<int, int>>; ///< the two vertices of each

/// 4: the springs along the lines of the grid, from each vertex to the one `by` farther.
inline Springs along(const Sheet& sheet, int by) {
    // task 1: return todo(1);
    Springs all;
    for (int j = 0; j < sheet.rows; ++j)
        for (int i = 0; i < sheet.columns; ++i) {
            const int here = i + sheet.columns * j;
            if (i + by < sheet.columns) all.emplace_back(here, here + by);
            if (j + by < sheet.rows) all.emplace_back(here, here + sheet.columns * by);
        }
    return all;
    // end of task 1
}

/// 4: both diagonals of each cell.
inline Springs diagonals(const Sheet& sheet) {
    // task 2: return todo(2);
    Springs all;
    for (int j = 0; j + 1 < sheet.rows; ++j)
        for (int i = 0; i + 1 < sheet.columns; ++i) {
            const int here = i + sheet.columns * j;
            all.emplace_back(here, here + sheet.columns + 1);
            all.emplace_back(here + 1, here + sheet.columns);
        }
    return all;
    // end of task 2
}

/// 4: how far two vertices of a flat sheet are apart.
inline Quantity<unit::Length> rest_length(const Sheet& sheet, int a, int b) {
    // task 3: return todo(3);
    const auto dx = sheet.width / double(sheet.columns - 1) * double(b % sheet.columns - a % sheet.columns);
    const auto dy = sheet.height / double(sheet.rows - 1) * double(b / sheet.columns - a / sheet.columns);
    return sqrt(dx * dx + dy * dy);
    // end of task 3
}

/// 4: what a vertex weighs, each having the mass of the area around it.
inline Quantity<unit::Mass> mass(const Sheet& sheet, int vertex, Quantity<unit::AreaDensity> mass_per_area) {
    // task 4: return todo(4);
    const int i = vertex % sheet.columns, j = vertex / sheet.columns;
    const double part_x = i == 0 || i == sheet.columns - 1 ? 0.5 : 1.0;
    const double part_y = j == 0 || j == sheet.rows - 1 ? 0.5 : 1.0;
    const Quantity<unit::Area> cell = sheet.width / double(sheet.columns - 1) * (sheet.height / double(sheet.rows - 1));
    return mass_per_area * (part_x * part_y * cell);
    // end of task 4
}

} // namespace exercise
