// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/grid.hpp>

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
struct Map {
    std::vector<std::string> rows;
    std::vector<Step> shut;

    bool contains(Tile t) const { return t.x >= 0 && t.y >= 0 && t.y < int(rows.size()) && t.x < int(rows[0].size()); }
    bool wall(Tile t) const { return rows[std::size_t(t.y)][std::size_t(t.x)] == '#'; }
};

inline ansatz::paths::Cell cell(Tile t) { return {std::uint16_t(t.x), std::uint16_t(t.y)}; }

/// The library keeps a byte for each tile that says which steps lead out of it.
inline ansatz::paths::Grid<> grid_of(const Map& map) {
    ansatz::paths::Grid<> grid(map.rows[0].size(), map.rows.size());
    for (int y = 0; y < int(map.rows.size()); ++y)
        for (int x = 0; x < int(map.rows[0].size()); ++x) grid.set_passable(cell({x, y}), !map.wall({x, y}));
    return grid;
}
inline bool may_step(const Map& map, Tile from, Tile to) { // a tile outside has no number
    return map.contains(from) && map.contains(to) && grid_of(map).passable(cell(from), cell(to));
}
inline std::vector<Tile> neighbours(const Map& map, Tile from) {
    auto grid = grid_of(map);
    for (const Step& shut : map.shut) grid.set_passable(cell(shut.from), cell(shut.to), false);
    std::vector<Tile> all;
    const auto edges = out_edges(cell(from), grid);
    for (auto e = edges.first; e != edges.second; ++e) all.push_back({(*e).to.x, (*e).to.y});
    return all;
}

} // namespace exercise
