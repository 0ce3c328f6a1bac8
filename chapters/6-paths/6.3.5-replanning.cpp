// SPDX-License-Identifier: BSL-1.0
// 6.3.5 Replanning only when needed: a walker, and what happens on its map

// "Paths should only be recomputed when the best path is likely to change ... once when the entity in motion first
// starts to move and an additional time for each event that changes parts of the graph that form parts of the path",
// say the notes. So an event is held against the rest of the path: what lies behind the walker does not matter any
// more, and what became dearer elsewhere cannot make another path better. One kind of event slips through the rule:
// something elsewhere that becomes *cheaper*. The path stays valid, and is no longer the best. Who wants to know
// searches then too. (A part of section 6.3.)

#include "claims.hpp"
#include "columns.hpp"
#include "drawing.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/route.hpp>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// A river with a bridge in the north and one in the south.
Grid<> village() {
    return grid_from<Grid<>>({".........#.......", ".................", ".........#.......", ".........#.......",
                              ".........#.......", ".........#.......", ".................", ".........#......."});
}
const Cell start{0, 3}, goal{16, 3};

/// What happens before the walker's step of this number.
struct Event {
    int step;
    std::string what;
    Cell tile;
    bool free;
};
const std::vector<Event> events{{1, "a cart stands on the meadow", {4, 7}, false},
                                {3, "a gate behind the walker is shut", {0, 3}, false},
                                {4, "the northern bridge is closed", {9, 1}, false},
                                {6, "the ford in the middle falls dry", {9, 4}, true},
                                {10, "the cart drives on", {4, 7}, true}};

struct Walk {
    std::size_t searches = 0, expanded = 0, steps = 0;
    double tiles = 0;
    std::vector<Cell> way;
};

/// Walks from start to goal while the events happen.
template <class Rule> Walk walk(Rule rule, bool tell) {
    auto map = village();
    AStar search{map, Octile{}};
    //! [walk]
    Route route{search, rule};
    route.go(start, goal); // once, when it first starts to move
    std::size_t expanded = search.expanded();
    std::vector<Cell> way{start};
    for (int step = 0; !route.arrived(); ++step) {
        for (const Event& event : events)
            if (event.step == step) map.set_passable(event.tile, event.free);
        const bool searched = route.renew(); // searches if its rule asks for it
        if (searched) expanded += search.expanded();
        if (route.outcome() != Outcome::found) break;
        way.push_back(route.step());
        //! [walk]
        for (const Event& event : events)
            if (tell && event.step == step)
                std::cout << "  at " << name_of(way[way.size() - 2]) << ": " << event.what << ", "
                          << name_of(event.tile) << ": " << (searched ? "searches" : "walks on") << '\n';
    }
    return {route.searches(), expanded, way.size() - 1, map.tiles(way), way};
}
/// The same, with a search before each step.
Walk walk_and_search_always() {
    auto map = village();
    AStar search{map, Octile{}};
    Walk result;
    result.way.push_back(start);
    for (int step = 0; result.way.back() != goal; ++step) {
        for (const Event& event : events)
            if (event.step == step) map.set_passable(event.tile, event.free);
        search.find(result.way.back(), goal);
        ++result.searches;
        result.expanded += search.expanded();
        result.way.push_back(search.path()[1]);
    }
    result.steps = result.way.size() - 1;
    result.tiles = map.tiles(result.way);
    return result;
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto map = village();

    std::cout << "The rule: when the rest of the path is touched\n";
    const Walk touched = walk(Replan::when_touched, true);
    std::cout << "The rule: also when something becomes cheaper\n";
    const Walk cheaper = walk(Replan::also_when_cheaper, true);
    const Walk always = walk_and_search_always();
    auto drawn = [&](const Walk& walked) {
        return drawing::with_path(drawing::map_of(map, [](Cell c) { return c == start  ? 'S'
                                                                           : c == goal ? 'G'
                                                                                       : '.'; }),
                                  walked.way);
    };
    drawing::print_beside({"when touched", "also when cheaper"}, {drawn(touched), drawn(cheaper)});
    std::cout << workbook::Columns({"rule", "searches", "nodes expanded", "length of the walk in tiles"})
                     .row("when touched", touched.searches, touched.expanded, touched.tiles)
                     .row("also when cheaper", cheaper.searches, cheaper.expanded, cheaper.tiles)
                     .row("before each step", always.searches, always.expanded, always.tiles);
    claim("of five events one touches the rest of the path: two searches with the first one", touched.searches == 2);
    claim("what becomes cheaper elsewhere it does not see: the way by the ford would have been shorter",
          always.tiles < touched.tiles - 1);
    claim("the second rule sees it, and searches once in vain, for the cart", cheaper.searches == 4);
    claim("and walks no farther than one who searches before each step", std::abs(cheaper.tiles - always.tiles) < 1e-9);
    claim("with far fewer nodes expanded", 2 * cheaper.expanded < always.expanded);

    workbook::Plot plot("6.3.5", "Two walks: the bridge is closed, then the ford falls dry");
    drawing::with_walls(plot, map, "river");
    drawing::way(plot, map, "when touched", touched.way);
    drawing::way(plot, map, "also when cheaper", cheaper.way);
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
