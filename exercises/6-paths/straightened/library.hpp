// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace exercise {

struct Tile {
    int x = 0, y = 0;
    bool operator==(const Tile&) const = default;
};
using Map = std::vector<std::string>;
using Terrain = ansatz::paths::Grid<ansatz::paths::Eight<>, ansatz::paths::Terrain>;
using ansatz::paths::Cell;

inline Cell cell(Tile t) { return {std::uint16_t(t.x), std::uint16_t(t.y)}; }
inline Terrain grid_of(const Map& map) {
    return ansatz::paths::grid_from<Terrain>(std::vector<std::string_view>(map.begin(), map.end()));
}

inline double walk_cost(const Map& map, const std::vector<Tile>& corners) {
    const Terrain grid = grid_of(map);
    double cost = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        cost += ansatz::paths::straight_tiles(std::array{cell(corners[i - 1]), cell(corners[i])}) *
                grid.weight(cell(corners[i]));
    return cost;
}

/// A map on which one steps to tiles of one weight only: the question is then one of sight.
struct OfOneWeight {
    const Terrain& grid;
    double weight;
    bool passable(Cell c) const { return grid.passable(c); }
    bool passable(Cell from, Cell to) const { return grid.passable(from, to) && grid.weight(to) == weight; }
};
inline bool even_line(const Map& map, Tile from, Tile to) {
    const Terrain grid = grid_of(map);
    return ansatz::paths::line_of_sight(OfOneWeight{grid, grid.weight(cell(to))}, cell(from), cell(to));
}

inline std::vector<Tile> smooth(const Map& map, const std::vector<Tile>& path) {
    std::vector<Cell> cells;
    for (const Tile t : path) cells.push_back(cell(t));
    std::vector<Tile> corners;
    for (const Cell c : ansatz::paths::smooth(grid_of(map), cells)) corners.push_back({c.x, c.y});
    return corners;
}

} // namespace exercise
