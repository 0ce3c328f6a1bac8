// SPDX-License-Identifier: BSL-1.0
// A graph of Boost.Graph made of your steps, searched beside the library's grid.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <cmath>
#include <memory>

using namespace ansatz;
using namespace ansatz::paths;

const exercise::Map map{
    {"........#.......", ".###....#..###..", "...#....#....#..", "...#.........#..", "...#....#......."}, {}};
constexpr std::size_t columns = 16;

using Weight = boost::property<boost::edge_weight_t, double>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Weight>;

Graph graph_of_yours(double& edges) {
    Graph graph(map.rows.size() * columns);
    for (std::size_t v = 0; v < num_vertices(graph); ++v) {
        const exercise::Tile from{int(v % columns), int(v / columns)};
        for (const auto to : exercise::neighbours(map, from)) {
            add_edge(v, std::size_t(to.y) * columns + std::size_t(to.x), std::hypot(to.x - from.x, to.y - from.y),
                     graph);
            ++edges;
        }
    }
    return graph;
}

int main() {
    workbook::Play table("A map of 16 x 5 tiles, from (0, 4) to (15, 0).", {"path, tiles", "edges of the graph"});
    table.timed("ns a search");
    double steps = 0;
    const auto graph = std::make_shared<Graph>(graph_of_yours(steps));
    auto yours = std::make_shared<AStar<Graph>>(*graph);
    yours->find(4 * columns, 15);
    table.row("yours", {yours->cost(), steps}, 1, [yours, graph] { yours->find(4 * columns, 15); });

    Grid<> grid(columns, map.rows.size());
    double edges = 0;
    for (std::uint16_t y = 0; y < map.rows.size(); ++y)
        for (std::uint16_t x = 0; x < columns; ++x) grid.set_passable(Cell{x, y}, map.rows[y][x] == '.');
    for (std::uint16_t y = 0; y < map.rows.size(); ++y)
        for (std::uint16_t x = 0; x < columns; ++x) edges += double(out_degree(Cell{x, y}, grid));
    AStar library{grid, ZeroHeuristic{}, CostIn<double>{}};
    library.find(Cell{0, 4}, Cell{15, 0});
    table.row("library", {library.cost(), edges}, 1, [&] { library.find(Cell{0, 4}, Cell{15, 0}); });
    return table.print();
}
