// SPDX-License-Identifier: BSL-1.0
// The swamp of section 6.1.3, whose path is pulled straight by you and by the library.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string_view>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

const exercise::Map swamp{"........................", "....44444444....#.......", "....44444444....#.......",
                          "....44444444....#.......", "....44444444....#.......", "................#.......",
                          "........................"};

int main() {
    const auto grid = grid_from<Grid<Eight<>, Terrain>>(std::vector<std::string_view>(swamp.begin(), swamp.end()));
    AStar quickest{grid, Octile{}};
    quickest.find(Cell{1, 3}, Cell{22, 2});
    std::vector<exercise::Tile> path;
    for (const Cell c : quickest.path()) path.push_back({c.x, c.y});

    const auto yours = exercise::smooth(swamp, path);
    std::vector<exercise::Tile> library;
    for (const Cell c : smooth(grid, quickest.path())) library.push_back({c.x, c.y});
    auto rows = swamp;
    const auto mark = [&](exercise::Tile t, char letter) { rows[std::size_t(t.y)][std::size_t(t.x)] = letter; };
    for (const auto t : path) mark(t, '*');
    for (const auto t : yours) mark(t, 'C');
    for (const auto& row : rows) std::cout << row << '\n';
    std::cout << "The path is * and C; C are your corners.\n\n";

    workbook::Play table("Round a swamp of weight 4 and a wall.", {"corners", "cost"});
    table.timed("ns a path");
    volatile std::size_t sink = 0;
    table.row("yours", {double(yours.size()), exercise::walk_cost(swamp, yours)}, 1,
              [&] { sink = exercise::smooth(swamp, path).size(); });
    table.row("library", {double(library.size()), exercise::walk_cost(swamp, library)}, 1,
              [&] { sink = smooth(grid, quickest.path()).size(); });
    return table.print();
}
