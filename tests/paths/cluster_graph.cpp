// SPDX-License-Identifier: BSL-1.0
// Gates as a graph: its edges cost what the ways on the tiles cost, and any search of the library runs on it.

#include <ansatz/paths/cluster_graph.hpp>

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/heuristics/zero.hpp>

using namespace paths_tests;

static_assert(SearchGraph<ClusterGraph<Grid<>>>);

TEST_CASE("an edge between gates costs what the best way inside of its square costs, or one step", "[hierarchy]") {
    std::mt19937 random(167);
    int inside = 0, across = 0, compared = 0;
    for (int i = 0; i < 12; ++i) {
        const auto map = random_map(random, 50, 40, 0.25);
        const Clusters squares{map, 10};
        ClusterGraph graph{squares};
        for (std::size_t s = 0; s < squares.squares(); ++s)
            for (const Cell gate : squares.gates_of(s)) {
                const auto [first, last] = squares.edges_of(gate);
                for (const auto* e = first; e != last; ++e) {
                    REQUIRE(squares.is_gate(e->to));
                    if (squares.square_of(e->to) == s) {
                        CHECK(e->cost == squares.cost_to(e->to, gate));
                        ++inside;
                    } else {
                        REQUIRE(map.passable(gate, e->to));
                        CHECK(e->cost == (gate.x != e->to.x && gate.y != e->to.y ? 47321 : 33461));
                        ++across;
                    }
                }
            }
        for (int k = 0; k < 20; ++k) {
            const Cell start = random_cell(random, 50, 40), goal = random_cell(random, 50, 40);
            if (!map.passable(start) || !map.passable(goal)) continue;
            graph.set_ends(start, goal);
            const auto edges = out_edges(start, graph);
            CHECK(std::size_t(std::distance(edges.first, edges.second)) == out_degree(start, graph));
            AStar octile{graph};
            AStar zero{graph, ZeroHeuristic{}};
            AStar buckets{graph, Buckets{}};
            AStar tiles{map};
            const auto outcome = octile.find(start, goal);
            REQUIRE(zero.find(start, goal) == outcome);
            REQUIRE(buckets.find(start, goal) == outcome);
            REQUIRE(tiles.find(start, goal) == outcome);
            if (outcome != Outcome::found) continue;
            CHECK(octile.cost() == zero.cost()); // the estimate is never too much
            CHECK(buckets.cost() == zero.cost());
            CHECK(zero.cost() >= tiles.cost());
            ++compared;
        }
    }
    CHECK(inside > 500);
    CHECK(across > 200);
    CHECK(compared > 100);
}
