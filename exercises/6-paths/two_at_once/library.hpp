// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: the steps of its grid, its rule of who meets whom, and Manhattan for each.
#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/plans.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace exercise {

struct Place {
    int x = 0, y = 0;
    bool operator==(const Place&) const = default;
};
using Room = std::vector<std::string>;
struct Both {
    Place a, b;
    bool operator==(const Both&) const = default;
};

inline ansatz::paths::Cell cell(Place p) { return {std::uint16_t(p.x), std::uint16_t(p.y)}; }
inline std::vector<Both> next_pairs(const Room& room, const Both& now) {
    using namespace ansatz::paths;
    Grid<Four> map(room[0].size(), room.size());
    for (std::size_t y = 0; y < room.size(); ++y)
        for (std::size_t x = 0; x < room[y].size(); ++x) map.set_passable(cell({int(x), int(y)}), room[y][x] == '.');
    const auto next_cells = [&](Cell c) {
        std::vector<Cell> cells{c};
        const auto edges = out_edges(c, map);
        for (auto edge = edges.first; edge != edges.second; ++edge) cells.push_back(target(*edge, map));
        return cells;
    };
    std::vector<Both> pairs;
    for (const Cell a : next_cells(cell(now.a)))
        for (const Cell b : next_cells(cell(now.b))) {
            const std::vector<std::vector<Cell>> plans{{cell(now.a), a}, {cell(now.b), b}};
            if (!first_meeting(plans)) pairs.push_back({{a.x, a.y}, {b.x, b.y}});
        }
    return pairs;
}
inline int estimate(const Both& now, const Both& goals) {
    using namespace ansatz::paths;
    const Grid<Four> empty(64, 64);
    const auto steps = [&](Place from, Place to) {
        AStar search{empty, Manhattan{}};
        search.begin(cell(from), cell(to));
        return int(search.node(cell(from))->h / Tile<std::uint32_t>::straight);
    };
    return std::max(steps(now.a, goals.a), steps(now.b, goals.b));
}

} // namespace exercise
