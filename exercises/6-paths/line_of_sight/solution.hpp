// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace exercise {

/// Column x and row y, which are also the coordinates of the tile's centre.
struct Tile {
    int x = 0, y = 0;
    bool operator==(const Tile&) const = default;
};
/// Row by row: '.' is free, '#' a wall.
using Room = std::vector<std::string>;

/// What lies outside the room is not free either.
inline bool free(const Room& room, Tile t) {
    const bool inside = t.x >= 0 && t.y >= 0 && t.y < int(room.size()) && t.x < int(room[0].size());
    return inside && room[std::size_t(t.y)][std::size_t(t.x)] != '#';
}

/// 6.3.9: every tile that the straight line between two centres enters, in order, both ends included. Exactly through a
/// corner it steps diagonally.
inline std::vector<Tile> line(Tile from, Tile to) {
    // task 1: return todo(1);
    const int columns = std::abs(to.x - from.x), rows = std::abs(to.y - from.y);
    const int right = to.x > from.x ? 1 : -1, down = to.y > from.y ? 1 : -1;
    std::vector<Tile> tiles{from};
    Tile at = from;
    int x = 0, y = 0; // how many borders between columns and between rows have been crossed
    while (x < columns || y < rows) {
        // The next border of a column is at (x + 1/2) / columns of the way, that of a row at (y + 1/2) / rows.
        const int next_column = (2 * x + 1) * rows, next_row = (2 * y + 1) * columns;
        if (next_column <= next_row) at.x += right, ++x;
        if (next_row <= next_column) at.y += down, ++y;
        tiles.push_back(at);
    }
    return tiles;
    // end of task 1
}

/// 6.3.9: whether one can walk along that line: over free tiles, and between free ones where it steps diagonally.
inline bool sees(const Room& room, Tile from, Tile to) {
    // task 2: return todo(2);
    const std::vector<Tile> tiles = line(from, to);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (!free(room, tiles[i])) return false;
        if (i == 0) continue;
        const Tile a = tiles[i - 1], b = tiles[i];
        if (!free(room, {a.x, b.y}) || !free(room, {b.x, a.y})) return false;
    }
    return true;
    // end of task 2
}

} // namespace exercise
