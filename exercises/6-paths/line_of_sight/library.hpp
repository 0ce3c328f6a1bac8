// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace exercise {

struct Tile {
    int x = 0, y = 0;
    bool operator==(const Tile&) const = default;
};
using Room = std::vector<std::string>;

inline ansatz::paths::Cell cell(Tile t) { return {std::uint16_t(t.x), std::uint16_t(t.y)}; }

/// A map without walls, which writes down the steps that it is asked about.
struct Recording {
    std::vector<Tile>& tiles;
    bool passable(ansatz::paths::Cell) const { return true; }
    bool passable(ansatz::paths::Cell, ansatz::paths::Cell to) const {
        tiles.push_back({to.x, to.y});
        return true;
    }
};
inline std::vector<Tile> line(Tile from, Tile to) {
    std::vector<Tile> tiles{from};
    ansatz::paths::line_of_sight(Recording{tiles}, cell(from), cell(to));
    return tiles;
}

/// The library asks of each step whether it is an edge of the grid, which knows the rule for corners.
inline bool sees(const Room& room, Tile from, Tile to) {
    ansatz::paths::Grid<> grid(room[0].size(), room.size());
    for (int y = 0; y < int(room.size()); ++y)
        for (int x = 0; x < int(room[0].size()); ++x)
            grid.set_passable(cell({x, y}), room[std::size_t(y)][std::size_t(x)] != '#');
    return ansatz::paths::line_of_sight(grid, cell(from), cell(to));
}

} // namespace exercise
