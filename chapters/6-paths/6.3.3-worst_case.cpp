// SPDX-License-Identifier: BSL-1.0
// 6.3.3 The worst case: a goal that cannot be reached costs the whole map, and what a game does about it

// "A* is an expensive algorithm and in the worst case will perform a full exploration of the search space", say the
// notes. The worst case is not rare: it is every goal behind a locked door, for the search knows that there is no path
// only when it has seen all that can be reached. Three remedies: spread the search over frames, give it a budget and go
// to where it came nearest, or accept a path that is not the best. (A part of section 6.3.)

#include "claims.hpp"
#include "columns.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <iostream>
#include <random>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;

    // A castle with a door, on a map with stones.
    Grid map(96, 64);
    std::mt19937 random(6);
    for (std::uint16_t y = 0; y < 64; ++y)
        for (std::uint16_t x = 0; x < 96; ++x)
            if (random() % 100 < 12) map.set_passable(Cell{x, y}, false);
    for (std::uint16_t y = 20; y <= 30; ++y)
        for (std::uint16_t x = 70; x <= 82; ++x) map.set_passable(Cell{x, y}, y > 20 && y < 30 && x > 70 && x < 82);
    const Cell door{82, 25}, start{4, 40}, goal{76, 25};
    map.set_passable(start, true);

    AStar search{map, Octile{}};
    map.set_passable(door, true);
    search.find(start, goal);
    const std::size_t open_door = search.expanded();
    //! [locked]
    map.set_passable(door, false);
    search.find(start, goal);
    workbook::say() << search.why() << '\n';
    //! [locked]
    const std::size_t locked = search.expanded();
    AStar all{map, ZeroHeuristic{}};
    all.find(start, goal);
    workbook::say() << "with the door open: " << open_door << " nodes expanded; locked: " << locked
                    << "; without any heuristic: " << all.expanded() << '\n';
    claim("no path: everything that can be reached was expanded, and a heuristic does not help",
          search.outcome() == Outcome::no_path && locked == all.expanded());
    claim("but only that: the inside of the castle was not", !search.node(goal));

    // Spread over frames.
    //! [slices]
    map.set_passable(door, true);
    int frames = 0;
    search.begin(start, goal);
    while (search.advance(200) == Outcome::running) ++frames; // 200 expansions a frame
    //! [slices]
    std::cout << "In slices of 200 expansions: " << frames + 1 << " frames, " << search.expanded() << " nodes, "
              << name_of(search.outcome()) << '\n';
    AStar at_once{map, Octile{}};
    at_once.find(start, goal);
    claim("in slices it finds the same path, node by node",
          std::equal(search.path().begin(), search.path().end(), at_once.path().begin(), at_once.path().end()));

    // A budget.
    //! [budget]
    map.set_passable(door, false);
    const auto outcome = search.find(start, goal, 1000);
    workbook::say() << search.why() << '\n';
    //! [budget]
    const Cell nearest = search.path().back();
    claim("given up, it has a path to where it came nearest",
          outcome == Outcome::gave_up && search.path().front() == start && search.expanded() == 1000);
    std::size_t nearer = 0;
    for (const Cell c : search.closed_list()) nearer += search.node(c)->h < search.node(nearest)->h;
    claim("no node that it expanded is estimated to be nearer", nearer == 0);

    // Not the best.
    map.set_passable(door, true);
    std::vector<double> weights, expansions;
    std::vector<double> lengths;
    bool within = true;
    workbook::Columns table({"w", "nodes expanded", "length over the best"});
    //! [weighted]
    for (const double w : {1.0, 1.2, 1.5, 2.0, 5.0}) {
        AStar hasty{map, Weighted{Octile{}, w}, NoReopening{}};
        hasty.find(start, goal);
        const double longer = map.tiles(hasty.path()) / map.tiles(at_once.path());
        within = within && longer <= w + 1e-9;
        table.row(w, hasty.expanded(), longer);
        //! [weighted]
        weights.push_back(w);
        expansions.push_back(double(hasty.expanded()));
        lengths.push_back(longer);
    }
    std::cout << table;
    claim("weighted by w, the path costs at most w times the best", within);
    claim("and a small w saves most of what there is to save", expansions[2] < 0.5 * expansions[0]);

    AStar hasty{map, Weighted{Octile{}, 1.5}, NoReopening{}};
    hasty.find(start, goal);
    workbook::Plot plot("6.3.3",
                        "Through the castle's door: what is expanded for the best path, and with a weight of 1.5");
    drawing::with_walls(plot, map);
    drawing::fill(plot, map, "expanded for the best", at_once.closed_list());
    drawing::fill(plot, map, "with w = 1.5", hasty.closed_list());
    drawing::way(plot, map, "its path", hasty.path());
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
