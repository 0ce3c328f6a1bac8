// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: only four neighbours, by the sum of the differences
// Why:     A diagonal step differs by one in both. The sum is two, and it is a single step all the same.
// Read:    6.3.1, 6.3
// Fails:   eight, corners, all, one-way

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
    if (!map.contains(from) || !map.contains(to)) return false;
    if (std::abs(to.x - from.x) + std::abs(to.y - from.y) != 1) return false;
    return !map.wall(from) && !map.wall(to);
}

/// Every tile to which one step leads, in any order: one that may be made, and is not shut.
inline std::vector<Tile> neighbours(const Map& map, Tile from) {
    std::vector<Tile> all;
    for (int y = from.y - 1; y <= from.y + 1; ++y)
        for (int x = from.x - 1; x <= from.x + 1; ++x) {
            const Tile to{x, y};
            bool open = may_step(map, from, to);
            for (const Step& shut : map.shut) open = open && !(shut.from == from && shut.to == to);
            if (open) all.push_back(to);
        }
    return all;
}

} // namespace exercise
