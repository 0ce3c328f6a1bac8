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
    return todo(1);
}

/// 6.3.9: whether one can walk along that line: over free tiles, and between free ones where it steps diagonally.
inline bool sees(const Room& room, Tile from, Tile to) {
    return todo(2);
}

} // namespace exercise
