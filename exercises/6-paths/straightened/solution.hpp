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
    // task 1: return todo(1);
    double cost = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Tile a = corners[i - 1], b = corners[i];
        cost += std::hypot(b.x - a.x, b.y - a.y) * weight(map, b);
    }
    return cost;
    // end of task 1
}

/// 6.1.3: whether one can walk straight from tile to tile on ground of one weight.
inline bool even_line(const Map& map, Tile from, Tile to) {
    // task 2: return todo(2);
    if (weight(map, from) == 0 || weight(map, to) == 0) return false;
    const std::vector<Tile> tiles = line(from, to);
    for (std::size_t i = 1; i < tiles.size(); ++i) {
        const Tile a = tiles[i - 1], b = tiles[i];
        if (weight(map, b) != weight(map, to)) return false;
        if (weight(map, {a.x, b.y}) == 0 || weight(map, {b.x, a.y}) == 0) return false;
    }
    return true;
    // end of task 2
}

/// 6.1.3: the corners of a path, from each of which one walks straight to the next and pays no more than along the
/// path.
inline std::vector<Tile> smooth(const Map& map, const std::vector<Tile>& path) {
    // task 3: return todo(3);
    std::vector<Tile> corners;
    if (path.empty()) return corners;
    corners.push_back(path[0]);
    std::size_t from = 0;
    while (from + 1 < path.size()) {
        const int ground = weight(map, path[from + 1]);
        std::size_t to = from + 1;
        for (std::size_t k = from + 2; k < path.size(); ++k) {
            if (weight(map, path[k]) != ground) break;
            if (even_line(map, path[from], path[k])) to = k;
        }
        corners.push_back(path[to]);
        from = to;
    }
    return corners;
    // end of task 3
}

} // namespace exercise
