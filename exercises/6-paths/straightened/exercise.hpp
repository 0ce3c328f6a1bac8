// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
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
/// Row by row: '#' is a wall, '1' to '9' a free tile of that weight, and '.' one of weight 1.
using Map = std::vector<std::string>;

/// 0 for a wall, and outside the map.
inline int weight(const Map& map, Tile t) {
    const bool inside = t.x >= 0 && t.y >= 0 && t.y < int(map.size()) && t.x < int(map[0].size());
    const char c = inside ? map[std::size_t(t.y)][std::size_t(t.x)] : '#';
    return c == '#' ? 0 : c == '.' ? 1 : c - '0';
}

/// Every tile that the straight line between two centres enters, in order, both ends included: those of the rectangle
/// between the two that are near enough to the line. Exactly through a corner it steps diagonally.
inline std::vector<Tile> line(Tile from, Tile to) {
    const int dx = to.x - from.x, dy = to.y - from.y;
    std::vector<Tile> tiles;
    for (int y = std::min(from.y, to.y); y <= std::max(from.y, to.y); ++y)
        for (int x = std::min(from.x, to.x); x <= std::max(from.x, to.x); ++x)
            if (from == to || 2 * std::abs(dx * (y - from.y) - dy * (x - from.x)) < std::abs(dx) + std::abs(dy))
                tiles.push_back({x, y});
    const auto along = [=](Tile t) { return dx * (t.x - from.x) + dy * (t.y - from.y); };
    std::sort(tiles.begin(), tiles.end(), [&](Tile a, Tile b) { return along(a) < along(b); });
    return tiles;
}

/// 6.1.3: what a walk from corner to corner costs, straight from centre to centre.
inline double walk_cost(const Map& map, const std::vector<Tile>& corners) {
    return todo(1);
}

/// 6.1.3: whether one can walk straight from tile to tile on ground of one weight.
inline bool even_line(const Map& map, Tile from, Tile to) {
    return todo(2);
}

/// 6.1.3: the corners of a path, from each of which one walks straight to the next and pays no more than along the
/// path.
inline std::vector<Tile> smooth(const Map& map, const std::vector<Tile>& path) {
    return todo(3);
}

} // namespace exercise
