// SPDX-License-Identifier: BSL-1.0
// 6.1 A*: the workflow of the notes, turn by turn, with its two lists and with f, g, h and parent of each node

// The most promising node first: that is the one of the least f = g + h, where g is what the way to it costs and h what
// the rest is estimated to cost. The program stops a search after every turn of the notes' loop and reads what the
// notes name: the open list by ascending f, the closed list, the values of each node, and in the end the parents from
// the goal back to the start. Nothing is made for the purpose: the library's search has these by name.

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

std::string tiles(std::uint32_t cost) {
    char text[20];
    std::snprintf(text, sizeof text, "%.2f", double(cost) / Tile<std::uint32_t>::straight);
    return text;
}
template <class Search> std::string values(const Search& search, Cell c) {
    const auto& n = *search.node(c);
    return name_of(c) + " f " + tiles(n.f()) + " = g " + tiles(n.g) + " + h " + tiles(n.h);
}

/// Writes down what happens in each step, with the notes' number of it.
//! [visitor]
struct Watch : Visitor {
    Cell newest{};
    int added = 0, improved_ = 0;
    template <class Node> void closed(Cell c, const Node&) { newest = c; }  // 2.1
    template <class Node> void opened(Cell, const Node&) { ++added; }       // 2.3.4, and 1 for the start
    template <class Node> void improved(Cell, const Node&) { ++improved_; } // 2.3.3
};
//! [visitor]

} // namespace

int main() {
    workbook::Claims claim;

    //! [search]
    const auto map = grid_from<Grid<>>({"...#...", "...#...", "...#...", "......."});
    const Cell start{1, 1}, goal{5, 1};
    AStar search{map, Octile{}}; // it counts in whole numbers: a straight step of a tile is 33461
    //! [search]
    workbook::say()
        << "S start, G goal, # wall; P is moved to the closed list (x), what it sees to the open list (o).\n";

    Watch watch;
    bool by_least_f = true, f_never_falls = true, no_list_twice = true;
    std::uint32_t last_f = 0;
    int turn = 0;
    //! [loop]
    search.begin(start, goal, watch); // 1: the start node on the open list
    watch.added = 0;
    while (search.outcome() == Outcome::running) {
        const Cell top = search.open_list().front(); // by ascending f: the next P
        search.advance(1, watch);                    // 2: one turn of the loop
        //! [loop]
        const auto open = search.open_list();
        by_least_f = by_least_f && search.node(top)->f() == search.node(watch.newest)->f();
        f_never_falls = f_never_falls && search.node(watch.newest)->f() >= last_f;
        last_f = search.node(watch.newest)->f();
        for (const Cell c : open) no_list_twice = no_list_twice && !search.is_closed(c);

        auto rows = drawing::lists_of(map, search, start, goal);
        rows[watch.newest.y][watch.newest.x] = 'P';
        drawing::Rows texts{"turn " + std::to_string(++turn), "P " + values(search, watch.newest),
                            "neighbours new on the open list: " + std::to_string(watch.added) +
                                "; reached by a cheaper way: " + std::to_string(watch.improved_),
                            "open:"};
        for (std::size_t i = 0; i < open.size() && i < 3; ++i)
            texts.back() +=
                " " + name_of(open[i]) + " " + tiles(search.node(open[i])->f()) + (i + 1 < open.size() ? "," : "");
        if (open.size() > 3) texts.back() += " and " + std::to_string(open.size() - 3) + " more";
        if (search.outcome() == Outcome::found) texts[2] = "P is the goal: the path is found";
        std::cout << '\n';
        drawing::print(rows, texts);
        watch.added = watch.improved_ = 0;
    }
    std::cout << '\n';
    claim("P was always a node of the least f on the open list", by_least_f);
    claim("from turn to turn the f of P never fell: what is left cannot be better than the goal when its turn comes",
          f_never_falls);
    claim("no node was on both lists", no_list_twice);
    claim("the h of every node of the path was no more than what the rest of the path costs", [&] {
        for (const Cell c : search.path())
            if (search.node(c)->h > search.cost() - search.node(c)->g) return false;
        return true;
    }());

    //! [parents]
    std::vector<Cell> path;
    for (Cell c = goal;; c = search.node(c)->parent) { // 4
        path.insert(path.begin(), c);
        if (c == start) break; // the start is its own parent
    }
    //! [parents]
    std::string parents;
    for (std::size_t i = path.size(); i-- > 0;) parents += ' ' + name_of(path[i]);
    workbook::say() << "\nThe parents, from the goal back:" << parents << '\n';
    const bool same = std::equal(path.begin(), path.end(), search.path().begin(), search.path().end());
    claim("turned round they are the path", same);
    bool closed = true;
    for (const Cell c : search.path()) closed = closed && search.is_closed(c);
    claim("every node of the path is on the closed list, but not every closed node on the path",
          closed && search.closed_list().size() > search.path().size());
    workbook::say() << search.expanded() << " nodes were expanded, " << search.generated()
                    << " were ever on the open list, of " << map.size() << "; the path is " << map.length(search.path())
                    << " long\n";
    claim("and is as long as its cheapest way: the steps of Dijkstra's search find no shorter one", [&] {
        AStar dijkstra{map, ZeroHeuristic{}};
        return dijkstra.find(start, goal) == Outcome::found && dijkstra.cost() == search.cost() &&
               dijkstra.expanded() > search.expanded();
    }());

    workbook::Plot plot("6.1", "What A* expanded, and the path that it found");
    drawing::with_walls(plot, map);
    drawing::fill(plot, map, "closed list", search.closed_list());
    drawing::fill(plot, map, "open list", search.open_list());
    drawing::way(plot, map, "path", search.path());
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
