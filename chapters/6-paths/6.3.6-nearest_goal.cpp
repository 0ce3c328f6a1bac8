// SPDX-License-Identifier: BSL-1.0
// 6.3.6 The nearest of several: one search to any of a set of goals, or to wherever a condition holds

// A* "finds the shortest path between two nodes". The hurt soldier of a game asks another question: where is the
// nearest medkit, by the way that must be walked? The answer by the notes' algorithm is a search for each. But nothing
// in the algorithm wants the end to be one node: step 2.2 asks whether this node is an end node, and h must not be more
// than what is left to the nearest of them. The least of the estimates for each is such an h. Starts may be several as
// well: step 1 puts them all on the open list. And where nobody can list the goals, step 2.2 asks a condition, and h
// is zero, for it is not known where that holds. (A part of section 6.3, beyond the notes.)

#include "claims.hpp"
#include "drawing.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/property_maps.hpp>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;
    const auto map = grid_from<Grid<>>({"....................", "....#######.........", "....#.....#.........",
                                        "....#.....#.........", "....#...............", "....#######.........",
                                        "....................", "...................."});
    const Cell hero{2, 3};

    //! [any]
    const std::vector<Cell> medkits{{6, 3}, {17, 0}, {12, 6}};
    AStar nearest{map, AnyGoal{}};
    nearest.find(hero, medkits);
    const Cell medkit = nearest.path().back(); // which of them it is
    //! [any]
    const std::vector<Cell> way(nearest.path().begin(), nearest.path().end());
    std::cout << "Three medkits (1, 2, 3): " << nearest.why() << '\n';
    auto rows = drawing::with_path(drawing::lists_of(map, nearest, hero, medkit), way);
    for (std::size_t i = 0; i < medkits.size(); ++i) rows[medkits[i].y][medkits[i].x] = char('1' + i);
    drawing::print(rows);

    AStar single{map};
    std::size_t each = 0;
    auto best = nearest.cost() + 1;
    std::cout << "Single searches: tiles, nodes expanded\n";
    for (const Cell goal : medkits) {
        single.find(hero, goal);
        each += single.expanded();
        best = std::min(best, single.cost());
        std::cout << "  to " << name_of(goal) << ": " << map.tiles(single.path()) << ", " << single.expanded() << '\n';
    }
    std::cout << "One search to any: " << map.tiles(way) << ", " << nearest.expanded() << "; all three: " << each
              << '\n';
    claim("one search finds what the best of three finds", nearest.cost() == best);
    claim("the medkit that is nearest as the crow flies is behind the wall: it is not the one",
          !(medkit == medkits[0]));
    claim("and it expands fewer nodes than the three together", nearest.expanded() < each);

    //! [starts]
    const std::vector<Cell> medics{{0, 0}, {8, 3}, {19, 7}};
    nearest.find(medics, std::vector<Cell>{hero}); // who is the first with the hero?
    const Cell medic = nearest.path().front();
    //! [starts]
    std::cout << "Of three medics the one at " << name_of(medic) << " is the first with the hero\n";
    claim("from several starts as well: the cheapest way, not the shortest line", medic == medics[0]);

    //! [condition]
    AStar exit{map, GoalWhere{[&](Cell c) { return c.x + 1u == map.width(); }}};
    exit.find(hero); // to the eastern border, wherever that is nearest
    //! [condition]
    std::cout << "To the eastern border: " << map.tiles(exit.path()) << " tiles, " << exit.expanded()
              << " nodes expanded\n";
    AStar guided{map, GoalWhere{[&](Cell c) { return c.x + 1u == map.width(); }},
                 By{[&](Cell c) { return Tile<std::uint32_t>::straight * (map.width() - 1u - c.x); }}};
    guided.find(hero);
    std::cout << "  with an estimate of one's own: " << guided.expanded() << '\n';
    claim("a condition is searched for evenly, unless one knows what is left at least",
          guided.cost() == exit.cost() && 2 * guided.expanded() < exit.expanded());

    //! [maps]
    AStar everywhere{map, GoalWhere{[](Cell) { return false; }}};
    everywhere.find(hero); // comes to all that can be reached
    std::vector<Cell> before(map.size());
    std::vector<std::uint32_t> costs(map.size());
    const auto number = get(boost::vertex_index, map);
    write_maps(everywhere, boost::make_iterator_property_map(before.begin(), number),
               boost::make_iterator_property_map(costs.begin(), number));
    //! [maps]
    claim("the maps of Boost.Graph hold the same costs", costs[map.index(way.back())] == best);

    const std::vector<Cell> no_medkits;
    try {
        nearest.find(hero, no_medkits);
    } catch (const std::invalid_argument& refused) {
        std::cout << "No medkits at all: \"" << refused.what() << "\"\n";
        claim("a search for nothing is refused", true);
    }

    workbook::Plot plot("6.3.6", "The nearest of three, by the way that must be walked");
    const auto kits = drawing::places(map, medkits), from = drawing::places(map, std::vector<Cell>{hero});
    drawing::with_walls(plot, map);
    drawing::way(plot, map, "the way to the nearest", way);
    plot.points("hero", from.east, from.north).points("medkit", kits.east, kits.north).write();
    return claim.result();
}
