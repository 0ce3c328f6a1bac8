// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its Formation, and for a member's steps a search on an empty map.
#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/formation.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace exercise {

struct Tile {
    int x = 0, y = 0;
    bool operator==(const Tile&) const = default;
};
using Offset = ansatz::paths::Offset;
struct Map {
    std::vector<std::string> rows;

    bool contains(Tile t) const { return t.x >= 0 && t.y >= 0 && t.y < int(rows.size()) && t.x < int(rows[0].size()); }
    bool wall(Tile t) const { return contains(t) && rows[std::size_t(t.y)][std::size_t(t.x)] == '#'; }
};
struct Formation {
    Tile centre;
    std::vector<Offset> offsets;
};
struct Slot {
    Tile tile;
    bool blocked = false;
    bool operator==(const Slot&) const = default;
};

inline ansatz::paths::Cell cell(Tile t) { return {std::uint16_t(t.x), std::uint16_t(t.y)}; }
inline Tile tile(ansatz::paths::Cell c) { return {c.x, c.y}; }

inline Formation around_centre(const std::vector<Tile>& members) {
    std::vector<ansatz::paths::Cell> cells;
    for (const Tile m : members) cells.push_back(cell(m));
    const auto [squad, centre] = ansatz::paths::Formation::around_centre(cells);
    return {tile(centre), squad.offsets()};
}
inline std::vector<Slot> slots_at(const Map& map, Tile leader, const std::vector<Offset>& offsets) {
    ansatz::paths::Grid<> grid(map.rows[0].size(), map.rows.size());
    for (int y = 0; y < int(map.rows.size()); ++y)
        for (int x = 0; x < int(map.rows[0].size()); ++x) grid.set_passable(cell({x, y}), !map.wall({x, y}));
    std::vector<Slot> slots;
    for (const auto& slot : ansatz::paths::Formation(offsets).at(grid, cell(leader)))
        slots.push_back({tile(slot.cell), slot.blocked});
    return slots;
}
inline std::vector<int> catch_up_speeds(const std::vector<std::vector<Slot>>& slots) {
    const ansatz::paths::Grid<> empty(32, 32);
    ansatz::paths::AStar search{empty, ansatz::paths::Octile{}};
    std::vector<int> most(slots[0].size(), 0);
    for (std::size_t k = 1; k < slots.size(); ++k)
        for (std::size_t i = 0; i < most.size(); ++i) {
            search.find(cell(slots[k - 1][i].tile), cell(slots[k][i].tile));
            most[i] = std::max(most[i], int(search.path().size()) - 1);
        }
    return most;
}

} // namespace exercise
