// SPDX-License-Identifier: BSL-1.0
// 6.3.4 Two agents in one corridor: why A* is a method for one

// "A* only works in practice for single agent path finding. Multi agent path finding is PSPACE difficult", say the
// notes. Two who want to pass each other in a corridor show it. Each one's path is the best there is, and both together
// are a collision. If each takes the other for a wall and searches again, they stand before each other for ever: the
// way out, that one of them steps into the bay and lets the other pass, is a detour that neither would choose for
// itself.
//
// A* does find it, over another graph: its nodes are both places at once. But that graph has n^2 nodes for two agents
// and n^k for k, and that is the difficulty. How hard it is at least depends on the rules: the shortest plan on a grid
// is NP-hard, to find any plan on an undirected graph is not, and PSPACE-hard are rectangles that slide in a rectangle.
// (A part of section 6.3.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

using Corridor = Grid<Four>;
const auto map = grid_from<Corridor>({"####.####", ".........", "#########"});
const Cell a_start{0, 1}, a_goal{8, 1}, b_start{8, 1}, b_goal{0, 1};

drawing::Rows drawn(Cell a, Cell b) {
    auto rows = drawing::map_of(map, [](Cell) { return '.'; });
    rows[a.y][a.x] = 'A', rows[b.y][b.x] = 'B';
    return rows;
}

/// Both at once: a node for each pair of free tiles, an edge for each pair of steps in which nobody runs into the
/// other.
//! [joint]
using Joint = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
struct Together {
    std::vector<Cell> tiles;
    Joint graph;

    explicit Together(const Corridor& corridor) {
        for (std::uint16_t y = 0; y < corridor.height(); ++y)
            for (std::uint16_t x = 0; x < corridor.width(); ++x)
                if (corridor.passable(Cell{x, y})) tiles.push_back({x, y});
        const std::size_t n = tiles.size();
        graph = Joint(n * n);
        auto may_step = [&](std::size_t i, std::size_t k) {
            return i == k || corridor.passable(tiles[i], tiles[k]);
        }; // or wait
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b)
                for (std::size_t to_a = 0; to_a < n; ++to_a)
                    for (std::size_t to_b = 0; to_b < n; ++to_b)
                        if (a != b && to_a != to_b && may_step(a, to_a) && may_step(b, to_b) &&
                            !(to_a == b && to_b == a))
                            add_edge(a * n + b, to_a * n + to_b, graph);
    }
    std::size_t number(Cell c) const { return std::size_t(std::find(tiles.begin(), tiles.end(), c) - tiles.begin()); }
    std::size_t node(Cell a, Cell b) const { return number(a) * tiles.size() + number(b); }
    Cell a_of(std::size_t v) const { return tiles[v / tiles.size()]; }
    Cell b_of(std::size_t v) const { return tiles[v % tiles.size()]; }
};
//! [joint]

std::size_t steps(Cell from, Cell to) { return std::size_t(std::abs(from.x - to.x) + std::abs(from.y - to.y)); }

} // namespace

int main() {
    workbook::Claims claim;

    // Each for itself.
    //! [alone]
    AStar search{map, Manhattan{}};
    search.find(a_start, a_goal);
    const std::vector<Cell> a_path(search.path().begin(), search.path().end());
    search.find(b_start, b_goal);
    const std::vector<Cell> b_path(search.path().begin(), search.path().end());
    //! [alone]
    std::size_t meet = 0;
    while (meet + 1 < a_path.size() && a_path[meet] != b_path[meet]) ++meet;
    drawing::print(drawn(a_start, b_start));
    std::cout << "Each has a best path of " << a_path.size() - 1 << " steps; after " << meet << " of them both are at "
              << name_of(a_path[meet]) << '\n';
    claim("two best paths, one collision", meet + 1 < a_path.size() && a_path[meet] == b_path[meet]);

    // Each walks its path, and takes the other for a wall where it stands in the way.
    //! [wall]
    auto seen = map; // with the other as a wall
    AStar around{seen, Manhattan{}};
    Cell a = a_start, b = b_start;
    std::size_t moves = 0, searches = 0;
    auto turn = [&](Cell& own, Cell other, Cell goal) {
        around.find(own, goal);
        if (around.path()[1] == other) { // it stands in the way: is there another?
            seen.set_passable(other, false);
            around.find(own, goal);
            ++searches;
            seen.set_passable(other, true);
            if (around.outcome() != Outcome::found) return; // wait
        }
        own = around.path()[1];
        ++moves;
    };
    for (int round = 0; round < 100; ++round) turn(a, b, a_goal), turn(b, a, b_goal);
    //! [wall]
    workbook::say() << "Each with the other as a wall: after 100 rounds, " << moves << " moves and " << searches
                    << " searches for another way they stand like this\n";
    drawing::print(drawn(a, b));
    claim("they never come past each other", a != a_goal && b != b_goal && searches > 180);

    // Both at once.
    //! [plan]
    const Together together(map);
    const By farther{[&](std::size_t v) { // both walk at the same time: the farther one decides
        return double(std::max(steps(together.a_of(v), a_goal), steps(together.b_of(v), b_goal)));
    }};
    AStar both{together.graph, farther, CostIn<double>{}};
    both.find(together.node(a_start, b_start), together.node(a_goal, b_goal));
    //! [plan]
    std::cout << "Planned together: " << both.cost() << " steps, " << both.expanded() << " nodes expanded, of "
              << num_vertices(together.graph) << '\n';
    std::vector<std::string> titles;
    std::vector<drawing::Rows> pictures;
    const auto plan = both.path();
    for (const std::size_t i : {std::size_t(4), std::size_t(5), std::size_t(6)}) {
        titles.push_back("step " + std::to_string(i));
        pictures.push_back(drawn(together.a_of(plan[i]), together.b_of(plan[i])));
    }
    drawing::print_beside(titles, pictures);
    bool apart = true, aside = false;
    for (const auto v : plan) {
        apart = apart && together.a_of(v) != together.b_of(v);
        aside = aside || together.a_of(v).y == 0 || together.b_of(v).y == 0;
    }
    claim("over the graph of both places A* finds a plan, in which one steps aside",
          both.outcome() == Outcome::found && apart && aside);
    claim("it is longer than either's own path", both.cost() > double(a_path.size() - 1));
    std::cout << "Nodes of such a graph with " << together.tiles.size() << " free tiles:\n ";
    for (int k = 1; k <= 6; ++k)
        std::cout << (k > 1 ? ", " : " ") << std::pow(double(together.tiles.size()), k) << " for " << k;
    std::cout << '\n';

    workbook::Plot plot("6.3.4", "A plan for both: one waits in the bay");
    std::vector<double> time;
    std::vector<Quantity<unit::Length>> a_east, b_east;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        time.push_back(double(i));
        a_east.push_back(x(map.position(together.a_of(plan[i]))));
        b_east.push_back(x(map.position(together.b_of(plan[i]))));
    }
    plot.x("step").y("east").linked_points("A", time, a_east).linked_points("B", time, b_east).write();

    workbook::Plot corridor("6.3.4-map", "In the middle B has stepped aside, and A passes");
    drawing::Places a_way, b_way;
    for (const auto v : plan) a_way.add(map, together.a_of(v)), b_way.add(map, together.b_of(v));
    for (auto& north : a_way.north) north += 0.12 * map.tile(); // side by side, where both walk the corridor
    for (auto& north : b_way.north) north -= 0.12 * map.tile();
    drawing::with_walls(corridor, map).line("A", a_way.east, a_way.north).line("B", b_way.east, b_way.north).write();
    return claim.result();
}
