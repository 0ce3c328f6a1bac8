// SPDX-License-Identifier: BSL-1.0
// A search of a map with your turns, beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <memory>

using namespace ansatz;
using namespace ansatz::paths;

const auto map = grid_from<Grid<>>({"................................", ".......####.....................",
                                    "..........#.....#####...........", "..........#.........#...........",
                                    "..........#.........#...........", "....#######.........#...........",
                                    "................#####...........", "................................"});
const Cell start{3, 3}, goal{27, 4};

/// The notes' workflow around your two functions. What the path costs, and how many turns that took.
std::pair<double, int> search_with_yours() {
    const auto h = Octile{}.bind<double>(map, goal);
    const auto index = get(boost::vertex_index, map);
    const auto weight = get(boost::edge_weight, map);
    std::vector<exercise::Node> nodes(map.size());
    nodes[index[start]] = {exercise::List::open, 0, h(start), index[start]};
    for (int turns = 0;; ++turns) {
        const std::size_t p = exercise::most_promising(nodes);
        if (p == exercise::nobody) return {-1, turns};
        nodes[p].list = exercise::List::closed;
        if (p == index[goal]) return {nodes[p].g, turns};
        const Cell at{std::uint16_t(p % map.width()), std::uint16_t(p / map.width())};
        const auto edges = out_edges(at, map);
        for (auto e = edges.first; e != edges.second; ++e)
            exercise::look_at(nodes, p, index[(*e).to], get(weight, *e), h((*e).to));
    }
}

int main() {
    workbook::Play table("A* on a map of 32 x 8 tiles, from (3, 3) to (27, 4).", {"path, tiles", "nodes expanded"});
    table.timed("ns a search");
    const auto yours = search_with_yours();
    table.row("yours", {yours.first, double(yours.second)}, 1, [] { search_with_yours(); });
    auto search = std::make_shared<AStar<Grid<>, Octile, CostIn<double>>>(map, Octile{}, CostIn<double>{});
    search->find(start, goal);
    table.row("library", {search->cost(), double(search->expanded())}, 1, [search] { search->find(start, goal); });
    return table.print();
}
