// SPDX-License-Identifier: BSL-1.0
// 6.1.1 The heuristic: an overestimate finds a worse path, and an honest one needs the closed list opened again

// "This must be either an underestimate or the exact cost. Providing a heuristic that is an overestimate will result in
// a path other than the optimal path being found", say the notes. It may: that depends on where it is too much. A map
// with a fast road shows how it happens by accident, for counting tiles is an overestimate as soon as a tile costs less
// than one.
//
// There is a second condition, which the notes leave out. Their step 2.3.3 gives a node on the closed list its cheaper
// g, and leaves it there. Where h falls by more than an edge costs, that is too late: what was reached through the node
// keeps its old, dearer g. The node must go back to the open list. (A part of section 6.1, which the notes do not
// divide.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;

    // A road along the upper edge, on which a step costs half as much.
    //! [road]
    using Country = Grid<Eight<>, Terrain>;
    auto country = grid_from<Country>({"..............", "..............", "..............", ".............."});
    for (std::uint16_t column = 0; column < 14; ++column) country.set_weight({column, 0}, 0.5);
    const Cell farm{0, 2}, town{13, 2};

    AStar by_tiles{country, Unscaled{Octile{}}}; // as if every tile weighed 1
    AStar by_road{country, Octile{}};            // counts with the least weight there is, 0.5
    by_tiles.find(farm, town);
    by_road.find(farm, town);
    //! [road]
    const double straight_on = country.cost(by_tiles.path()), on_the_road = country.cost(by_road.path());
    auto drawn = [&](const auto& search) {
        auto rows = drawing::with_path(drawing::lists_of(country, search, farm, town), search.path());
        for (char& letter : rows[0])
            if (letter == '.') letter = '='; // the road, where it was not expanded
        return rows;
    };
    std::cout << "From farm to town; = a road of weight 0.5, x closed list, o open list, * path:\n";
    drawing::print_beside({"h counts tiles", "h counts the cheapest tiles"}, {drawn(by_tiles), drawn(by_road)});
    std::cout << "The first path costs " << straight_on << ", the second " << on_the_road << "; " << by_tiles.expanded()
              << " and " << by_road.expanded() << " nodes were expanded\n";
    AStar dijkstra{country, ZeroHeuristic{}};
    dijkstra.find(farm, town);
    claim("the overestimate found a path that is not the best", straight_on > on_the_road);
    claim("the underestimate found the best", by_road.cost() == dijkstra.cost());

    //! [check]
    const auto wrong = check_heuristic(country, Unscaled{Octile{}}, town);
    if (wrong) workbook::say() << wrong->sentence << '\n';
    //! [check]
    claim("checking names the node where it is worst", wrong && wrong->estimate > wrong->true_cost);
    claim("and finds nothing wrong with the other", !check_heuristic(country, Octile{}, town));

    // It may, not it will: here every node is overestimated by the same share, and the path is the best all the same.
    Grid field(9, 9);
    AStar four_ways{field, Manhattan{}}; // on eight neighbours columns plus rows are too much
    four_ways.find(Cell{0, 0}, Cell{8, 8});
    claim("an overestimate need not lead astray: on an empty field Manhattan finds the best path",
          check_heuristic(field, Manhattan{}, Cell{8, 8}) &&
              field.tiles(four_ways.path()) == 8 * Tile<double>::diagonal);

    // An admissible heuristic that falls from B to C by 6, over an edge of 3.
    //! [inconsistent]
    using Weighted_ = boost::property<boost::edge_weight_t, double>;
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Weighted_> places(4);
    enum { A, B, C, D };
    add_edge(A, B, 3.0, places), add_edge(B, C, 3.0, places), add_edge(C, D, 3.0, places);
    add_edge(A, C, 8.0, places), add_edge(A, D, 10.0, places);
    const std::vector<double> h{9, 6, 0, 0};
    const By estimate{[&](auto v) { return h[v]; }};

    AStar letter{places, estimate, UpdateClosed{}}; // the notes to the letter
    AStar reopens{places, estimate};                // Reopening is the default
    letter.find(A, D);
    reopens.find(A, D);
    //! [inconsistent]
    auto shown = [](auto path) {
        std::string text;
        for (const auto v : path) text += (text.empty() ? "" : "-") + std::string(1, "ABCD"[v]);
        return text;
    };
    std::cout << "A-B 3, B-C 3, C-D 3, A-C 8, A-D 10; h of A 9, of B 6, of C and D 0\n"
              << "  the notes' step 2.3.3 to the letter: " << shown(letter.path()) << " for " << letter.cost() << '\n'
              << "  with C opened again:                 " << shown(reopens.path()) << " for " << reopens.cost()
              << '\n';
    claim("h is nowhere more than the true cost", !check_heuristic(places, estimate, D));
    claim("updated and left closed, the path is not the best", letter.cost() == 10);
    claim("opened again, it is", reopens.cost() == 9 && reopens.reopened() == 1);

    workbook::Plot plot("6.1.1", "With an estimate that is too high the road is never seen");
    std::vector<Cell> road;
    for (std::uint16_t column = 0; column < 14; ++column) road.push_back({column, 0});
    drawing::fill(drawing::on_map(plot, country), country, "road", road);
    drawing::fill(plot, country, "closed list of the overestimate", by_tiles.closed_list());
    drawing::way(plot, country, "found by the overestimate", by_tiles.path());
    drawing::way(plot, country, "the best, on the road", by_road.path());
    drawing::with_ends(plot, country, farm, town).write();
    return claim.result();
}
