// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: a shut step is shut in both directions
// Why:     A drop is a step down and none up. A wall between two tiles is two entries.
// Read:    6.3.1
// Fails:   one-way

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
    if (std::abs(to.x - from.x) > 1 || std::abs(to.y - from.y) > 1 || from == to) return false;
    if (map.wall(from) || map.wall(to)) return false;
    return !map.wall({from.x, to.y}) && !map.wall({to.x, from.y});
}

/// Every tile to which one step leads, in any order: one that may be made, and is not shut.
inline std::vector<Tile> neighbours(const Map& map, Tile from) {
    std::vector<Tile> all;
    for (int y = from.y - 1; y <= from.y + 1; ++y)
        for (int x = from.x - 1; x <= from.x + 1; ++x) {
            const Tile to{x, y};
            bool open = may_step(map, from, to);
            for (const Step& shut : map.shut)
                open = open && !(shut.from == from && shut.to == to) && !(shut.from == to && shut.to == from);
            if (open) all.push_back(to);
        }
    return all;
}

} // namespace exercise
