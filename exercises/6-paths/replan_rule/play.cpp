// SPDX-License-Identifier: BSL-1.0
// A walker on a map whose gates open and close, by your rule and by the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/route.hpp>

using namespace ansatz;
using namespace ansatz::paths;

constexpr std::uint16_t columns = 40, rows = 21;
const Cell start{0, 10}, goal{39, 10};

/// Three walls, each with a gate in the north and one in the south.
Grid<Four> land() {
    Grid<Four> map(columns, rows);
    for (const std::uint16_t x : {10, 20, 30})
        for (std::uint16_t y = 0; y < rows; ++y) map.set_passable(Cell{x, y}, y == 4 || y == 16);
    return map;
}
/// Before each step the next gate in turn is closed, or opened again.
struct Change {
    Cell gate;
    bool free;
};
Change change(int step) {
    const std::uint16_t x[] = {20, 10, 30, 20, 30, 10}, y[] = {4, 4, 16, 4, 16, 16};
    const int n = step / 5 % 6;
    return {Cell{x[n], y[n]}, step / 5 % 2 == 1};
}

struct Walk {
    double searches = 0, steps = 0;
};
Walk walk_with_yours() {
    auto map = land();
    AStar search{map};
    const auto index = get(boost::vertex_index, map);
    std::vector<std::size_t> path;
    std::size_t at = 0;
    Walk walk;
    auto find = [&](Cell from) {
        search.find(from, goal);
        ++walk.searches;
        path.clear();
        for (const Cell c : search.path()) path.push_back(index[c]);
        at = 0;
    };
    find(start);
    for (int step = 0; at + 1 < path.size() && step < 300; ++step) {
        if (step % 5 == 0) {
            const Change now = change(step);
            const bool was = map.passable(now.gate);
            map.set_passable(now.gate, now.free);
            const auto number = index[now.gate];
            const double infinite = INFINITY, before = was ? 1 : infinite, after = now.free ? 1 : infinite;
            bool again = false;
            for (const std::size_t beside :
                 {number - 1, number + 1}) { // a gate is entered from the west and from the east
                again = again || exercise::must_search(path, at, {beside, number, before, after});
                again = again || exercise::must_search(path, at, {number, beside, before, after});
            }
            if (again) find(Cell{std::uint16_t(path[at] % columns), std::uint16_t(path[at] / columns)});
        }
        if (at + 1 < path.size()) ++at, ++walk.steps;
    }
    return walk;
}
Walk walk_with_the_librarys() {
    auto map = land();
    AStar search{map};
    Route route{search};
    route.go(start, goal);
    Walk walk;
    for (int step = 0; !route.arrived() && step < 300; ++step) {
        if (step % 5 == 0) {
            const Change now = change(step);
            map.set_passable(now.gate, now.free);
            route.renew();
        }
        route.step(), ++walk.steps;
    }
    walk.searches = double(route.searches());
    return walk;
}

int main() {
    workbook::Play table("Three walls with two gates each, of which one opens or closes every five steps.",
                         {"searches", "steps"});
    table.timed("ns a walk");
    const Walk yours = walk_with_yours(), library = walk_with_the_librarys();
    table.row("yours", {yours.searches, yours.steps}, 1, [] { walk_with_yours(); });
    table.row("library", {library.searches, library.steps}, 1, [] { walk_with_the_librarys(); });
    return table.print();
}
