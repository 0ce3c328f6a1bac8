// SPDX-License-Identifier: BSL-1.0
// The map of section 6.3 searched with your heuristic, beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <memory>

using namespace ansatz;
using namespace ansatz::paths;

const auto map = grid_from<Grid<>>({"................................", ".......####.....................",
                                    "..........#.....#####...........", "..........#.........#...........",
                                    "..........#.........#...........", "....#######.........#...........",
                                    "................#####...........", "................................"});
const Cell start{3, 3}, goal{27, 4};

template <class Heuristic> void show(const char* who, Heuristic heuristic, workbook::Play& table) {
    auto search = std::make_shared<AStar<Grid<>, Heuristic, CostIn<double>>>(map, heuristic, CostIn<double>{});
    search->find(start, goal);
    table.row(who, {map.tiles(search->path()), double(search->expanded())}, 1, [search] { search->find(start, goal); });
}

int main() {
    workbook::Play table("A* on a map of 32 x 8 tiles, from (3, 3) to (27, 4).", {"path, tiles", "nodes expanded"});
    table.timed("ns a search");
    show("yours", By{[](Cell a, Cell b) { return exercise::eight_neighbours(int(b.x) - a.x, int(b.y) - a.y); }}, table);
    show("library", Octile{}, table);
    show("none", ZeroHeuristic{}, table);
    return table.print();
}
