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
    return todo(1);
}

/// 4: both diagonals of each cell.
inline Springs diagonals(const Sheet& sheet) {
    return todo(2);
}

/// 4: how far two vertices of a flat sheet are apart.
inline Quantity<unit::Length> rest_length(const Sheet& sheet, int a, int b) {
    return todo(3);
}

/// 4: what a vertex weighs, each having the mass of the area around it.
inline Quantity<unit::Mass> mass(const Sheet& sheet, int vertex, Quantity<unit::AreaDensity> mass_per_area) {
    return todo(4);
}

} // namespace exercise
