// SPDX-License-Identifier: BSL-1.0
// 6.1.2 Boost.Graph: A* over any graph of it, a grid that is one, and boost::astar_search as one of the engines

// "Operates over a graph described by nodes and edges connecting them", say the notes. The graph is Boost.Graph's: the
// search asks for its concepts and property maps (out_edges, target, edge_weight, vertex_index) and not for a class of
// ours. So it runs on a graph that you have, and what Boost.Graph has runs on our grid. Boost's own boost::astar_search
// is one of the engines; the default one stops without an exception, reads no node that the search does not come to,
// and can be left and resumed. (A part of section 6.1, which the notes do not divide.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// What a call of boost::astar_search expanded, and the exception that ends it.
struct Count {
    std::size_t prepared = 0, expanded = 0;
};
struct Reached {};
struct Counting : boost::default_astar_visitor {
    Count* count;
    Cell goal;
    void initialize_vertex(Cell, const Grid<>&) { ++count->prepared; }
    void examine_vertex(Cell c, const Grid<>&) {
        if (c == goal) throw Reached{};
        ++count->expanded;
    }
};

} // namespace

int main() {
    workbook::Claims claim;

    // A graph that somebody has: an adjacency_list, with weights as a property.
    //! [own]
    struct Road {
        double minutes = 0;
        bool flooded = false;
    };
    using Roads = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Road>;
    enum Town : std::size_t { Mill, Bridge, Ford, Castle, Inn };
    Roads roads(5);
    add_edge(Mill, Ford, {10, false}, roads), add_edge(Ford, Castle, {8, false}, roads);
    add_edge(Mill, Bridge, {15, false}, roads), add_edge(Bridge, Castle, {12, false}, roads),
        add_edge(Castle, Inn, {3, false}, roads);

    AStar ride{roads,
               WeightsOf{get(&Road::minutes, roads)}}; // no coordinates: ZeroHeuristic, which is Dijkstra's search
    ride.find(Mill, Inn);
    //! [own]
    const double dry = ride.cost();
    //! [filtered]
    roads[edge(Ford, Castle, roads).first].flooded = true;
    const auto passable = [&](const auto& e) { return !roads[e].flooded; };
    const boost::filtered_graph<Roads, decltype(passable)> dry_roads(roads, passable);
    AStar detour{dry_roads, WeightsOf{get(&Road::minutes, dry_roads)}};
    detour.find(Mill, Inn);
    //! [filtered]
    std::cout << "From the mill to the inn: " << dry << " minutes; when the ford is flooded: " << detour.cost() << '\n';
    claim("over an adjacency_list: by the ford, 10 + 8 + 3", dry == 21);
    claim("over a filtered_graph, Boost.Graph's own way to leave edges out: by the bridge, 15 + 12 + 3",
          detour.cost() == 30);

    // Our grid in an algorithm of Boost.Graph.
    //! [dijkstra]
    const auto map = grid_from<Grid<>>({".........", ".#######.", ".......#.", ".#####.#.", ".#.....#."});
    const Cell start{2, 4}, goal{8, 4};
    std::vector<double> costs(num_vertices(map));
    std::vector<Cell> parents(num_vertices(map));
    const auto index = get(boost::vertex_index, map);
    boost::dijkstra_shortest_paths(map, start,
                                   boost::vertex_index_map(index)
                                       .weight_map(get(boost::edge_weight, map))
                                       .distance_map(boost::make_iterator_property_map(costs.begin(), index))
                                       .predecessor_map(boost::make_iterator_property_map(parents.begin(), index)));
    //! [dijkstra]
    AStar search{map, Octile{}};
    search.find(start, goal);
    std::cout << "boost::dijkstra_shortest_paths on our grid: " << costs[index[goal]]
              << " tiles; A*: " << map.tiles(search.path()) << '\n';
    claim("the grid is a graph of Boost.Graph, and its Dijkstra agrees with A*",
          std::abs(costs[index[goal]] - map.tiles(search.path())) < 1e-12);

    // The engines.
    //! [engines]
    AStar ours{map, Octile{}};
    AStar boosts{map, Octile{}, BoostAStar{}};
    ours.find(start, goal);
    boosts.find(start, goal);
    //! [engines]
    drawing::print_beside({"OwnLoop", "BoostAStar"},
                          {drawing::with_path(drawing::lists_of(map, ours, start, goal), ours.path()),
                           drawing::with_path(drawing::lists_of(map, boosts, start, goal), boosts.path())});
    claim("boost::astar_search as the engine finds a path of the same cost", ours.cost() == boosts.cost());
    claim("and its lists and values can be read in the same way", boosts.is_closed(start) && boosts.node(goal)->h == 0);

    // A near path on a large map: boost::astar_search called by itself, with a visitor that counts and that ends it.
    Grid plain(1000, 1000);
    //! [near]
    AStar near{plain, Octile{}};
    const Cell here{500, 500}, there{505, 503};
    near.find(here, there);

    Count count;
    const auto estimate = Octile{}.bind<double>(plain, there); // h, bound to a goal
    try {
        boost::astar_search(plain, here, estimate, boost::visitor(Counting{{}, &count, there}));
    } catch (const Reached&) { // its documented way to stop
    }
    //! [near]
    workbook::say() << "A path of " << near.path().size() - 1 << " steps on a map of a million tiles: our loop wrote "
                    << near.generated() << " nodes, boost::astar_search prepared " << count.prepared << " and expanded "
                    << count.expanded << '\n';
    claim("what Boost's search prepares is the whole map", count.prepared == plain.size());
    claim("what ours writes is what it sees", near.generated() < 100);

    workbook::Plot plot("6.1.2", "A grid as a graph of Boost.Graph: A* and Dijkstra agree");
    std::vector<Cell> back;
    for (Cell c = goal;; c = parents[index[c]]) {
        back.push_back(c);
        if (c == start) break;
    }
    const auto theirs = drawing::places(map, back);
    drawing::way(drawing::with_walls(plot, map), map, "A*", search.path());
    plot.reference("boost::dijkstra_shortest_paths", theirs.east, theirs.north);
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
