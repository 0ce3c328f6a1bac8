// SPDX-License-Identifier: BSL-1.0
#pragma once

// Graphs made at random.

#include "tests/catch.hpp"
#include "tests/paths/data.hpp"
#include "tests/refusal.hpp"

#include <ansatz/paths/grid/grid.hpp>

#include <boost/graph/adjacency_list.hpp>

#include <filesystem>
#include <limits>
#include <random>
#include <span>
#include <string>

namespace paths_tests {

using namespace ansatz;
using namespace ansatz::paths;
using Catch::Matchers::ContainsSubstring;

/// A directed graph of Boost.Graph with whole-number weights.
using Roads = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                    boost::property<boost::edge_weight_t, int>>;

inline Roads random_roads(std::mt19937& random, std::size_t n, std::size_t edges, int heaviest) {
    Roads g(n);
    std::uniform_int_distribution<std::size_t> vertex(0, n - 1);
    std::uniform_int_distribution<int> weight(0, heaviest); // zero edges among them
    for (std::size_t e = 0; e < edges; ++e) boost::add_edge(vertex(random), vertex(random), weight(random), g);
    return g;
}

/// A map of walls at random, with a margin of nothing in particular.
template <class Map = Grid<>>
Map random_map(std::mt19937& random, std::size_t width, std::size_t height, double walls) {
    Map map(width, height);
    std::bernoulli_distribution wall(walls);
    for (std::uint16_t y = 0; y < height; ++y)
        for (std::uint16_t x = 0; x < width; ++x)
            if (wall(random)) map.set_passable(Cell{x, y}, false);
    return map;
}
inline Cell random_cell(std::mt19937& random, std::size_t width, std::size_t height) {
    return {std::uint16_t(random() % width), std::uint16_t(random() % height)};
}

/// Cost of a path by the grid's own edges, or infinity.
template <class Map> double cost_along(const Map& map, std::span<const Cell> path) {
    for (std::size_t i = 1; i < path.size(); ++i)
        if (!map.passable(path[i - 1], path[i])) return std::numeric_limits<double>::infinity();
    return map.cost(path);
}

} // namespace paths_tests
