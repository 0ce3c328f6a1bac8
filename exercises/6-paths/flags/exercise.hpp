// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <cstdlib>
#include <string>
#include <vector>

namespace exercise {

struct Tile {
    int x = 0, y = 0;
    friend bool operator==(Tile a, Tile b) { return a.x == b.x && a.y == b.y; }
};
struct Step {
    Tile from, to;
};
/// Rows of '.' and '#', and steps that are shut, each in one direction.
struct Map {
    std::vector<std::string> rows;
    std::vector<Step> shut;

    bool contains(Tile t) const { return t.x >= 0 && t.y >= 0 && t.y < int(rows.size()) && t.x < int(rows[0].size()); }
    bool wall(Tile t) const { return rows[std::size_t(t.y)][std::size_t(t.x)] == '#'; }
};

/// 6.3.1: whether walls, edges of the map and corners let one walk from a tile to one of its eight neighbours.
inline bool may_step(const Map& map, Tile from, Tile to) {
    return todo(1);
}

/// Every tile to which one step leads, in any order: one that may be made, and is not shut.
inline std::vector<Tile> neighbours(const Map& map, Tile from) {
    return todo(2);
}

} // namespace exercise
