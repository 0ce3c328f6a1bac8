// SPDX-License-Identifier: BSL-1.0
// The corridor of section 6.3.4, planned for both at once over your pairs; beside the library's ConflictBased.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/conflict_based.hpp>
#include <ansatz/paths/grid/from_rows.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;
using exercise::Both;
using exercise::Place;

namespace {

const exercise::Room rows{"####.####", ".........", "#########"};
const Both start{{0, 1}, {8, 1}}, goals{{8, 1}, {0, 1}};

/// A node for each pair of tiles, and the edges that you give.
struct Together {
    static constexpr int width = 9, tiles = 27;
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph{std::size_t(tiles) * tiles};
    static std::size_t node(const Both& p) {
        return std::size_t(p.a.y * width + p.a.x) * tiles + std::size_t(p.b.y * width + p.b.x);
    }
    static Both pair(std::size_t v) {
        const int a = int(v) / tiles, b = int(v) % tiles;
        return {{a % width, a / width}, {b % width, b / width}};
    }
    Together() {
        for (std::size_t v = 0; v < std::size_t(tiles) * tiles; ++v) {
            const Both now = pair(v);
            if (now.a == now.b || rows[std::size_t(now.a.y)][std::size_t(now.a.x)] == '#' ||
                rows[std::size_t(now.b.y)][std::size_t(now.b.x)] == '#')
                continue;
            for (const Both& next : exercise::next_pairs(rows, now)) add_edge(v, node(next), graph);
        }
    }
};

} // namespace

int main() {
    workbook::Play table("Two pass each other in a corridor with a bay.", {"steps", "of them in the bay"});
    table.timed("ns a search");
    const Together together;
    AStar both{together.graph, By{[](std::size_t v) { return exercise::estimate(Together::pair(v), goals); }},
               CostIn<double>{}};
    const auto plan = [&] { both.find(Together::node(start), Together::node(goals)); };
    plan();
    double aside = 0;
    for (const std::size_t v : both.path()) aside += (Together::pair(v).a.y == 0) + (Together::pair(v).b.y == 0);
    table.row("yours", {both.cost(), aside}, 1, plan);

    const auto map = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    ConflictBased search{map};
    const std::vector<Errand> errands{{{0, 1}, {8, 1}}, {{8, 1}, {0, 1}}};
    search.find(errands);
    double library_aside = 0, steps = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        steps = std::max(steps, double(search.plan(i).size() - 1));
        for (const Cell c : search.plan(i)) library_aside += c.y == 0;
    }
    table.row("library", {steps, library_aside}, 1, [&] { search.find(errands); });
    return table.print();
}
