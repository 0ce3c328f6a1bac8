// SPDX-License-Identifier: BSL-1.0
// 6.3.7 A field for a horde: one search backwards from the goal serves everybody who goes there

// A squad that moves along one path needs one search (6.3.2). A horde comes from everywhere: no two have the same
// start, and what they share is the goal. So the search begins there and goes backwards along the edges, until every
// tile from which there is a way knows what it costs and where the next step leads. Each walker then reads the tile
// it stands on, and no path is kept for anybody. What it costs does not depend on how many there are; for a few it is
// a waste, since it expands tiles on which no walker stands. From how many on it pays is counted here. (A part of
// section 6.3, beyond the notes.)

#include "claims.hpp"
#include "drawing.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// An arrow for a step.
std::string arrow(Cell from, Cell to) {
    const int dx = int(to.x) - from.x, dy = int(to.y) - from.y;
    const char* const arrows[3][3] = {{"\\", "^", "/"}, {"<", "G", ">"}, {"/", "v", "\\"}};
    return arrows[dy + 1][dx + 1];
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto map = grid_from<Grid<>>({"....................", ".########...........", "........#...........",
                                        "........#....#####..", "........#....#......", ".....####....#......",
                                        ".............#......", ".............#......"});
    const Cell gate{16, 5};

    //! [aim]
    FlowField field{map};
    field.aim(gate); // once, for all

    std::vector<Cell> horde{{0, 0}, {3, 3}, {7, 4}, {10, 7}, {19, 0}};
    for (Cell& goblin : horde) goblin = field.next(goblin); // a turn of the game
    //! [aim]
    auto rows = drawing::map_of(map, [&](Cell c) { return arrow(c, field.next(c))[0]; });
    std::cout << "Where the next step leads, from everywhere to the gate (G)\n";
    drawing::print(rows);

    horde = {{0, 0}, {3, 3}, {7, 4}, {10, 7}, {19, 0}};
    AStar search{map};
    bool the_best = true;
    std::vector<std::vector<Cell>> ways;
    for (const Cell goblin : horde) {
        ways.emplace_back();
        field.path(goblin, ways.back());
        search.find(goblin, gate);
        the_best = the_best && field.cost(goblin) == search.cost();
    }
    claim("everybody's way costs what a search of its own would find", the_best);

    // From how many on? Nodes expanded on a map of 64 x 64 tiles, a fifth blocked, the goblins anywhere.
    std::mt19937 random(7);
    Grid<> moor(64, 64);
    for (int i = 0; i < 64 * 64 / 5; ++i)
        moor.set_passable(Cell{std::uint16_t(random() % 64), std::uint16_t(random() % 64)}, false);
    const Cell cave{32, 32};
    moor.set_passable(cave, true);
    FlowField to_the_cave{moor};
    to_the_cave.aim(cave);
    AStar each{moor};
    std::size_t goblins = 0, alone = 0;
    while (alone <= to_the_cave.expanded()) {
        const Cell goblin{std::uint16_t(random() % 64), std::uint16_t(random() % 64)};
        if (!to_the_cave.reaches(goblin)) continue;
        each.find(goblin, cave);
        alone += each.expanded(), ++goblins;
    }
    std::cout << "The field expands " << to_the_cave.expanded() << " nodes; single searches have expanded more with "
              << goblins << " goblins\n";
    claim("for a handful single searches expand fewer", goblins > 5);
    claim("for a hundred the field does", goblins < 100);

    //! [change]
    auto changing = map;
    FlowField current{changing};
    current.aim(gate);
    changing.set_passable(Cell{19, 4}, false); // a tree falls
    if (!current.is_current()) current.aim(gate);
    //! [change]
    claim("after a change it is aimed again", current.is_current() && !current.reaches(Cell{19, 4}));

    workbook::Plot plot("6.3.7", "One field, five ways");
    drawing::with_walls(plot, map);
    for (std::size_t i = 0; i < ways.size(); ++i) drawing::way(plot, map, "goblin " + std::to_string(i + 1), ways[i]);
    const auto end = drawing::places(map, std::vector<Cell>{gate});
    plot.points("gate", end.east, end.north).write();
    return claim.result();
}
