// SPDX-License-Identifier: BSL-1.0
// 6.3.1 Flags against infinite weights: what nobody can walk on should not be searched

// "Nodes or edges that are not traversable can be marked with a boolean flag to prevent them from being considered by
// the A* algorithm (as opposed to assigning an infinite weight)", say the notes. A search that skips a flagged node
// never comes to what lies behind it. One that is given an infinite weight instead reads the weight each time, and
// boost::astar_search even puts the node behind it on its list, with an infinite g: where there is no way it goes
// through the whole map. A large weight is worse: it is an answer. And in whole numbers infinity plus one is zero. (A
// part of section 6.3.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <boost/graph/astar_search.hpp>

#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

const std::vector<std::string_view> rows{"....................", "....................", "..............#####.",
                                         "..............#...#.", "..............#...#.", "..............#####.",
                                         "....................", "...................."};
const Cell start{1, 4}, inside{16, 3};
bool wall(Cell c) { return rows[c.y][c.x] == '#'; }

/// Steps on a map without flags: what it costs to step onto a wall, or off it, stands here.
struct WallWeights {
    using key_type = GridEdge;
    using value_type = double;
    using reference = double;
    using category = boost::readable_property_map_tag;
    const double* wall_weight;
    std::size_t* asked;
    friend double get(const WallWeights& map, const GridEdge& e) {
        ++*map.asked;
        if (wall(e.from) || wall(e.to)) return *map.wall_weight;
        return e.diagonal ? Tile<double>::diagonal : Tile<double>::straight;
    }
};
struct Expansions : boost::default_astar_visitor {
    std::size_t* count;
    void examine_vertex(Cell, const Grid<>&) { ++*count; }
};

} // namespace

int main() {
    workbook::Claims claim;
    constexpr double infinite = std::numeric_limits<double>::infinity();

    // A room without a door, four times.
    //! [flag]
    const auto flagged = grid_from<Grid<>>(rows);
    AStar by_flag{flagged, ZeroHeuristic{}}; // where there is no way, no estimate helps
    by_flag.find(start, inside);
    //! [flag]
    //! [weight]
    const Grid open(flagged.width(), flagged.height()); // not a flag on it
    std::size_t asked = 0;
    double wall_weight = infinite;
    const WallWeights weights{&wall_weight, &asked};
    AStar by_weight{open, ZeroHeuristic{}, WeightsOf{weights}};
    by_weight.find(start, inside);
    //! [weight]
    const std::size_t by_weight_expanded = by_weight.expanded(), by_weight_asked = asked;
    std::cout << "flags:             " << name_of(by_flag.outcome()) << ", " << by_flag.expanded()
              << " nodes expanded, of " << flagged.size() << '\n'
              << "infinite weights:  " << name_of(by_weight.outcome()) << ", " << by_weight_expanded
              << " nodes expanded, and " << by_weight_asked << " weights\n";
    claim("with flags there is no path, and no tile of the room was seen",
          by_flag.outcome() == Outcome::no_path && !by_flag.node(inside));
    claim("the library takes an infinite weight as no way too",
          by_weight.outcome() == Outcome::no_path && by_weight_expanded == by_flag.expanded());

    //! [boost]
    std::size_t examined = 0;
    std::vector<double> g(num_vertices(open));
    const auto index = get(boost::vertex_index, open);
    boost::astar_search(
        open, start, [](Cell) { return 0.0; },
        boost::weight_map(weights)
            .distance_map(boost::make_iterator_property_map(g.begin(), index))
            .distance_inf(infinite)
            .visitor(Expansions{{}, &examined}));
    //! [boost]
    workbook::say() << "boost::astar_search with infinite weights: " << examined
                    << " nodes expanded; the goal has g = " << g[index[inside]] << '\n';
    claim("it goes through every tile of the map, walls and room too",
          examined == open.size() && g[index[inside]] == infinite);

    //! [large]
    wall_weight = 1000;
    by_weight.find(start, inside);
    //! [large]
    std::cout << "a weight of 1000:  " << name_of(by_weight.outcome()) << ", a path for " << by_weight.cost()
              << ", through the wall\n";
    std::size_t tiles_of_wall = 0;
    for (const Cell c : by_weight.path()) tiles_of_wall += wall(c);
    claim("a large weight finds a way through the wall", by_weight.outcome() == Outcome::found && tiles_of_wall == 1);

    //! [overflow]
    const std::uint32_t no_way = std::numeric_limits<std::uint32_t>::max();
    const std::uint32_t f = no_way + 1; // whole numbers begin again
    //! [overflow]
    std::cout << "infinity plus one in 32 bits: " << f << ", which would stand first on the open list\n";
    claim("infinity in whole numbers overflows to the least f there is", f == 0);

    // Edges have flags too, and a flag is changed in place.
    //! [drop]
    Grid cliff(5, 2);
    for (std::uint16_t x = 0; x < 5; ++x)
        for (int to = x - 1; to <= x + 1; ++to) // down, but not up again
            if (to >= 0 && to < 5) cliff.set_passable(Cell{x, 1}, Cell{std::uint16_t(to), 0}, false);
    AStar climber{cliff, Octile{}};
    const auto down = climber.find(Cell{2, 0}, Cell{2, 1});
    const auto up = climber.find(Cell{2, 1}, Cell{2, 0});
    cliff.set_passable(Cell{4, 1}, Cell{4, 0}, true); // a ladder
    const auto by_ladder = climber.find(Cell{2, 1}, Cell{2, 0});
    //! [drop]
    std::cout << "Down a cliff: " << name_of(down) << "; up: " << name_of(up)
              << "; with a ladder at its end: " << name_of(by_ladder) << ", " << cliff.tiles(climber.path())
              << " tiles\n";
    claim("a flag on an edge holds in one direction", down == Outcome::found && up == Outcome::no_path);
    claim("and the next search sees it changed", by_ladder == Outcome::found && cliff.tiles(climber.path()) == 5);

    workbook::Plot plot("6.3.1", "A room without a door: a search stops at a flag, a large weight is walked through");
    drawing::with_walls(plot, flagged);
    drawing::fill(plot, flagged, "closed list, with flags", by_flag.closed_list());
    drawing::way(plot, open, "path, with walls of weight 1000", by_weight.path());
    drawing::with_ends(plot, open, by_weight.path().front(), by_weight.path().back()).write();
    return claim.result();
}
