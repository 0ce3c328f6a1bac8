// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `line_of_sight` and `smooth`: a path of a grid without its zigzag.
///
/// A grid's path turns by 45 degrees, whatever the terrain. Smoothing keeps those tiles of it between which a straight
/// walk is possible, so that the walker goes from centre to centre in straight lines of any direction. The result is
/// never longer than the path, and not always the shortest there is among walls: it follows the path that was found.

#include <ansatz/paths/grid/grid.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

namespace ansatz::paths {

namespace detail {
/// Walks along the straight line between the centres of two tiles, tile by tile, and asks of each step whether it is
/// possible. A line exactly through a corner is a diagonal step there.
template <class Step> bool walk_line(Cell a, Cell b, Step&& possible) {
    const int dx = std::abs(int(b.x) - a.x), dy = std::abs(int(b.y) - a.y);
    const int sx = b.x > a.x ? 1 : -1, sy = b.y > a.y ? 1 : -1;
    int nx = 0, ny = 0; // how many columns and rows have been crossed
    Cell at = a;
    while (nx < dx || ny < dy) {
        // The next column line is at (nx + 1/2) / dx of the way, the next row line at (ny + 1/2) / dy.
        const long long x = (2LL * nx + 1) * dy, y = (2LL * ny + 1) * dx;
        Cell next = at;
        if (x <= y) next.x = std::uint16_t(int(next.x) + sx), ++nx;
        if (y <= x) next.y = std::uint16_t(int(next.y) + sy), ++ny;
        if (!possible(at, next)) return false;
        at = next;
    }
    return true;
}
} // namespace detail

/// Whether one can walk straight from one tile's centre to another's: every step between tiles on the way is an edge of
/// the map. On a grid of four neighbours a line through a corner is none.
template <class Map> bool line_of_sight(const Map& map, Cell a, Cell b) {
    if (!map.passable(a) || !map.passable(b)) return false;
    return detail::walk_line(a, b, [&](Cell from, Cell to) { return map.passable(from, to); });
}

namespace detail {
/// The same, and all tiles that are entered weigh what the last one does.
template <class Map> bool straight_and_even(const Map& map, Cell a, Cell b) {
    const double weight = map.weight(b);
    return line_of_sight(map, a, b) && walk_line(a, b, [&](Cell, Cell to) { return map.weight(to) == weight; });
}
} // namespace detail

/// The corners of a path, from which it can be walked in straight lines: a part of the path's tiles, the first and the
/// last among them. Where the ground is uneven a line stays on ground of one weight, so that nothing gets dearer.
template <class Map> std::vector<Cell> smooth(const Map& map, std::span<const Cell> path) {
    std::vector<Cell> corners;
    if (path.empty()) return corners;
    corners.push_back(path.front());
    std::size_t from = 0;
    while (from + 1 < path.size()) {
        std::size_t to = from + 1;
        const double weight = map.weight(path[to]);
        for (std::size_t k = to + 1; k < path.size() && map.weight(path[k]) == weight; ++k)
            if (detail::straight_and_even(map, path[from], path[k])) to = k;
        corners.push_back(path[to]);
        from = to;
    }
    return corners;
}

/// How long a walk from corner to corner is, in tiles.
inline double straight_tiles(std::span<const Cell> corners) {
    double all = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        all += std::hypot(double(corners[i].x) - corners[i - 1].x, double(corners[i].y) - corners[i - 1].y);
    return all;
}

} // namespace ansatz::paths
