// SPDX-License-Identifier: BSL-1.0
// The country of section 6.1.1: h counts tiles, a road is cheaper, and your factor lowers h; beside the library's
// Octile, which asks the map for its least weight.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <cstdlib>
#include <memory>

using namespace ansatz;
using namespace ansatz::paths;

using Country = Grid<Eight<>, Terrain>;
constexpr Cell farm{0, 2}, town{13, 2};

/// How far it is in tiles, whatever they cost.
double tiles(Cell a, Cell b) {
    const int dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    return std::max(dx, dy) + (Tile<double>::diagonal - 1) * std::min(dx, dy);
}

/// What you are asked for: the edges of the country, and h of each node.
double your_factor(const Country& country) {
    std::vector<exercise::Edge> edges;
    std::vector<double> h;
    const auto all = vertices(country);
    for (auto v = all.first; v != all.second; ++v) {
        h.push_back(tiles(*v, town));
        const auto out = out_edges(*v, country);
        for (auto e = out.first; e != out.second; ++e)
            edges.push_back({get(boost::vertex_index, country, *v),
                             get(boost::vertex_index, country, target(*e, country)),
                             get(boost::edge_weight, country, *e)});
    }
    return exercise::factor(edges, h);
}

template <class Heuristic>
void show(const char* who, const Country& country, Heuristic heuristic, workbook::Play& table) {
    auto search = std::make_shared<AStar<Country, Heuristic, CostIn<double>>>(country, heuristic, CostIn<double>{});
    search->find(farm, town);
    table.row(who, {country.cost(search->path()), double(search->expanded())}, 1,
              [search] { search->find(farm, town); });
}

int main() {
    auto country = grid_from<Country>({"..............", "..............", "..............", ".............."});
    for (std::uint16_t column = 0; column < 14; ++column) country.set_weight({column, 0}, 0.5);
    workbook::Play table("From farm to town, past a road on which a tile costs 0.5.", {"path, cost", "nodes expanded"});
    table.timed("ns a search");
    const double w = your_factor(country);
    show("yours", country, By{[w](Cell a, Cell b) { return w * tiles(a, b); }}, table);
    show("library", country, Octile{}, table);
    show("tiles", country, By{[](Cell a, Cell b) { return tiles(a, b); }}, table);
    show("none", country, ZeroHeuristic{}, table);
    return table.print();
}
