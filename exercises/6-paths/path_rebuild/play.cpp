// SPDX-License-Identifier: BSL-1.0
// A search of a map by the library, and the path that you read off its nodes.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <memory>

using namespace ansatz;
using namespace ansatz::paths;

const auto map = grid_from<Grid<>>({"................................", ".......####.....................",
                                    "..........#.....#####...........", "..........#.........#...........",
                                    "..........#.........#...........", "....#######.........#...........",
                                    "................#####...........", "................................"});
const Cell start{3, 3}, goal{27, 4};

int main() {
    AStar search{map, Octile{}};
    search.find(start, goal);
    const auto index = get(boost::vertex_index, map);
    std::vector<std::size_t> parents(map.size(), exercise::nobody);
    const auto all = vertices(map);
    for (auto c = all.first; c != all.second; ++c)
        if (const auto* node = search.node(*c)) parents[index[*c]] = index[node->parent];

    std::vector<Cell> cells;
    for (const std::size_t v : exercise::path(parents, index[goal]))
        cells.push_back({std::uint16_t(v % map.width()), std::uint16_t(v / map.width())});
    std::vector<std::string> rows{"................................", ".......####.....................",
                                  "..........#.....#####...........", "..........#.........#...........",
                                  "..........#.........#...........", "....#######.........#...........",
                                  "................#####...........", "................................"};
    for (std::size_t i = 0; i < cells.size(); ++i)
        rows[cells[i].y][cells[i].x] = i == 0 ? 'S' : i + 1 == cells.size() ? 'G' : '*';
    for (const auto& row : rows) std::cout << row << '\n';
    std::cout << '\n';

    workbook::Play table("The path, first node to last.", {"nodes", "tiles"});
    table.timed("ns a path");
    table.row("yours", {double(cells.size()), map.tiles(cells)}, 1, [&] { exercise::path(parents, index[goal]); });
    table.row("library", {double(search.path().size()), map.tiles(search.path())}, 1,
              [&] { const std::vector<Cell> copy(search.path().begin(), search.path().end()); });
    return table.print();
}
