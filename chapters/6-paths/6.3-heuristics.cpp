// SPDX-License-Identifier: BSL-1.0
// 6.3 Heuristics compared: the less an estimate underestimates, the fewer nodes are expanded

// "When using Euclidean distance as a heuristic in A* it is common to greatly underestimate the lowest distance", and
// that "can result in greater computational cost", say the notes. On a grid one cannot walk along the straight line, so
// the straight distance is less than any path. Counting steps as they are made (Octile) is exact on an empty map, costs
// no root, and expands fewer nodes. "More complex heuristics" know more of the map: the distances from a landmark give
// a lower bound for every node, and the larger one of two lower bounds is a lower bound again.

#include "claims.hpp"
#include "columns.hpp"
#include "drawing.hpp"
#include "growth.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

const auto map = grid_from<Grid<>>(
    {"................................", "................................", ".......####.....................",
     "..........#.....#####...........", "..........#.........#...........", "..........#.........#...........",
     "..........#.........#...........", "....#######.........#...........", "....................#...........",
     "................#####...........", "................................", "................................"});
const Cell start{3, 5}, goal{27, 6};

struct Row {
    std::string name;
    std::size_t expanded = 0;
    double tiles = 0;
    drawing::Rows drawing;
    std::vector<Cell> closed;
};
/// What a search with this heuristic expands.
//! [compare]
template <class... Policies> Row compare(std::string name, Policies... policies) {
    AStar search{map, policies...};
    search.find(start, goal);
    return {std::move(name), search.expanded(), map.tiles(search.path()),
            drawing::with_path(drawing::lists_of(map, search, start, goal), search.path()), search.closed_list()};
}
//! [compare]

} // namespace

int main() {
    workbook::Claims claim;

    // A landmark: how far every tile is from one corner. |d(v) - d(goal)| is never more than the way from v to the
    // goal.
    //! [landmark]
    const auto from_corner = true_costs(map, Cell{31, 11});
    const auto number = get(boost::vertex_index, map);
    const By landmark{[&](Cell c, Cell to) { // in tiles; a search in whole numbers would want them in its own unit
        return std::abs(from_corner[number[c]] - from_corner[number[to]]);
    }};
    //! [landmark]

    //! [rows]
    const std::vector<Row> rows{compare("ZeroHeuristic", ZeroHeuristic{}),
                                compare("Chebyshev", Chebyshev{}),
                                compare("Euclid", Euclid{}),
                                compare("Octile", Octile{}),
                                compare("Octile and landmark", Maximum{Octile{}, landmark}, CostIn<double>{}),
                                compare("1.5 x Octile", Weighted{Octile{}, 1.5}, NoReopening{}),
                                compare("Octile and 8 landmarks", Maximum{Octile{}, Landmarks<std::uint32_t>(map, 8)})};
    //! [rows]
    std::cout << "S start, G goal, # wall, x closed list, o open list, * path\n\n";
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
        if (i > 0) std::cout << '\n';
        drawing::print_beside({rows[i].name, rows[i + 1].name}, {rows[i].drawing, rows[i + 1].drawing});
    }
    workbook::Columns table({"heuristic", "nodes expanded", "length of the path in tiles"});
    for (const Row& row : rows) table.row(row.name, row.expanded, row.tiles);
    std::cout << '\n' << table;

    const Row &zero = rows[0], &chebyshev = rows[1], &euclid = rows[2], &octile = rows[3], &both = rows[4],
              &weighted = rows[5], &landmarks = rows[6];
    claim("without an estimate nearly all of the map is expanded", zero.expanded > map.size() * 3 / 4);
    claim("the larger a lower bound is, the fewer nodes: nothing, Chebyshev, Euclid, Octile, Octile and a landmark",
          zero.expanded > chebyshev.expanded && chebyshev.expanded > euclid.expanded &&
              euclid.expanded > octile.expanded && octile.expanded >= both.expanded);
    claim("and all of them find the same length",
          std::abs(zero.tiles - chebyshev.tiles) + std::abs(zero.tiles - euclid.tiles) +
                  std::abs(zero.tiles - octile.tiles) + std::abs(zero.tiles - both.tiles) <
              1e-9);
    claim("weighted by 1.5 it expands fewer still, and the path is at most 1.5 times as long",
          weighted.expanded < octile.expanded && weighted.tiles <= 1.5 * octile.tiles);
    claim("eight landmarks of the library know the walls better than one, and the path is the best",
          landmarks.expanded < both.expanded && std::abs(landmarks.tiles - octile.tiles) < 1e-9);
    claim("what Octile closes, Dijkstra's search closes too",
          std::includes(zero.closed.begin(), zero.closed.end(), octile.closed.begin(), octile.closed.end()));

    workbook::Film film(
        "6.3", "One map, four heuristics: what each search expands",
        "Four searches grow over the same map, turn by turn, and each ends with its path. Dijkstra's search expands "
        "nearly all of the map, Euclid half as much, Octile a third of it, and 1.5 x Octile a quarter.",
        {.middle = metres(0, 1.7, 0), .width = workbook::Film::wide / 18.0 * metre, .height = 32.4 * metre});
    const auto grow = [](const char* name, auto search) { return drawing::grow(name, search, start, goal); };
    drawing::side_by_side(film.rate(12).hold(30), map,
                          {grow("Dijkstra: no heuristic", AStar{map, ZeroHeuristic{}}),
                           grow("Euclid", AStar{map, Euclid{}}), grow("Octile", AStar{map, Octile{}}),
                           grow("1.5 x Octile", AStar{map, Weighted{Octile{}, 1.5}, NoReopening{}})});
    film.write();

    // What each of three expands beyond what the next, larger one does.
    workbook::Plot plot("6.3", "What is expanded, by the heuristic");
    auto beyond = [](const Row& more, const Row& less) {
        std::vector<Cell> cells;
        std::set_difference(more.closed.begin(), more.closed.end(), less.closed.begin(), less.closed.end(),
                            std::back_inserter(cells));
        return cells;
    };
    drawing::with_walls(plot, map);
    drawing::fill(plot, map, "without a heuristic", beyond(zero, euclid));
    drawing::fill(plot, map, "Euclid too", beyond(euclid, octile));
    drawing::fill(plot, map, "Octile too", octile.closed);
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
