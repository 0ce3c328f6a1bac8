// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `grid_from`: a small map written as text, for examples, exercises and tests. Maps in files: moving_ai.hpp.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/grid/grid.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// A map from rows of text: '.' is free, '#' is blocked, and on `Terrain` '1' to '9' are free tiles of that weight.
/// `grid_from<Grid<>>({"..#.", "...."})`.
/// \throws std::invalid_argument for no rows, rows of different lengths, and other letters, with row and column
template <class Map = Grid<>>
Map grid_from(const std::vector<std::string_view>& rows, Quantity<unit::Length> tile = 1.0 * metre) {
    const std::size_t width = rows.empty() ? 0 : rows.front().size();
    Map map(width, rows.size(), tile);
    std::vector<std::uint8_t> free;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (rows[y].size() != width)
            refuse_value("grid_from", "the length of row " + std::to_string(y), std::to_string(rows[y].size()),
                         "it must be " + std::to_string(width) + ", as row 0");
        for (std::size_t x = 0; x < width; ++x) {
            const char c = rows[y][x];
            const bool weight = !std::is_same_v<typename Map::ground, Even> && c >= '1' && c <= '9';
            if (c != '.' && c != '#' && !weight)
                refuse_value("grid_from", "row " + std::to_string(y) + ", column " + std::to_string(x),
                             std::string("'") + c + "'",
                             "it must be '.', '#' or, on Terrain, a weight from '1' to '9'");
            free.push_back(c != '#');
        }
    }
    map.set_passable(free);
    if constexpr (!std::is_same_v<typename Map::ground, Even>)
        for (std::size_t y = 0; y < rows.size(); ++y)
            for (std::size_t x = 0; x < width; ++x)
                if (rows[y][x] > '1' && rows[y][x] <= '9')
                    map.set_weight({std::uint16_t(x), std::uint16_t(y)}, rows[y][x] - '0');
    return map;
}

} // namespace ansatz::paths
