// SPDX-License-Identifier: BSL-1.0
// Several starts, several goals and a goal that is a condition: one search finds what the best of single searches
// finds, on grids, way points and graphs of Boost.Graph.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/property_maps.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <boost/concept_check.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace paths_tests;

namespace {

/// The best of single searches; the dearest cost there is where none finds a way.
template <class Search, class Vertices>
auto best_of_single(Search& single, const Vertices& starts, const Vertices& goals) {
    auto best = paths::detail::infinite<typename Search::Cost>;
    for (const auto& start : starts)
        for (const auto& goal : goals)
            if (single.find(start, goal) == Outcome::found) best = std::min(best, single.cost());
    return best;
}
template <class Vertices, class Vertex> bool holds(const Vertices& all, const Vertex& v) {
    return std::find(all.begin(), all.end(), v) != all.end();
}
/// Whether a search has found a path of this cost from a start to a goal, or none where there is none.
template <class Search, class Vertices, class Cost>
void require_best(const Search& search, const Vertices& starts, const Vertices& goals, Cost best) {
    INFO(search.why());
    REQUIRE((search.outcome() == Outcome::found) == (best < paths::detail::infinite<Cost>));
    if (search.outcome() != Outcome::found) return;
    REQUIRE(search.cost() == best);
    REQUIRE(holds(starts, search.path().front()));
    REQUIRE(holds(goals, search.path().back()));
}
template <class Graph> std::vector<VertexOf<Graph>> some(std::mt19937& random, const Graph& g, std::size_t most) {
    const std::vector<VertexOf<Graph>> all(vertices(g).first, vertices(g).second);
    std::vector<VertexOf<Graph>> chosen(1 + random() % most);
    for (auto& v : chosen) v = all[random() % all.size()];
    return chosen;
}

} // namespace

TEST_CASE("grids: several starts and goals in one search, equal to the best of single ones on 1000 maps", "[paths]") {
    std::mt19937 random(61);
    int found = 0, none = 0, blocked = 0;
    for (int k = 0; k < 1000; ++k) {
        const auto map = random_map(random, 6 + random() % 9, 6 + random() % 9, 0.35);
        const auto starts = some(random, map, 3), goals = some(random, map, 5); // walls and repetitions among them
        AStar single{map};
        const auto best = best_of_single(single, starts, goals);
        AStar heap{map, AnyGoal{}};
        heap.find(starts, goals);
        require_best(heap, starts, goals, best);
        if (heap.outcome() == Outcome::found)
            REQUIRE(cost_along(map, heap.path()) * Tile<std::uint32_t>::straight == Approx(best));
        AStar buckets{map, Buckets{}, AnyGoal{}};
        buckets.find(starts, goals);
        require_best(buckets, starts, goals, best);
        AStar jumping{map, JumpPoints{}, AnyGoal{}};
        jumping.find(starts, goals);
        require_best(jumping, starts, goals, best);
        AStar where{map, GoalWhere{[&](Cell c) { return holds(goals, c); }}};
        where.begin(starts, {});
        while (where.advance(3) == Outcome::running) {
        }
        require_best(where, starts, goals, best);
        found += heap.outcome() == Outcome::found, none += heap.outcome() == Outcome::no_path;
        blocked += heap.outcome() == Outcome::blocked;
    }
    CHECK(found > 500);
    CHECK(none > 50);
    CHECK(blocked > 50);
}

TEST_CASE("graphs of Boost.Graph and way points: several starts and goals", "[paths]") {
    std::mt19937 random(62);
    for (int k = 0; k < 200; ++k) {
        const Roads g = random_roads(random, 20, 50, 9);
        const auto starts = some(random, g, 3), goals = some(random, g, 4);
        AStar single{g};
        const int best = best_of_single(single, starts, goals);
        AStar any{g, AnyGoal{}};
        any.find(starts, goals);
        require_best(any, starts, goals, best);
        AStar by_boost{g, AnyGoal{}, BoostAStar{}}; // from one start
        const std::vector<std::size_t> first{starts.front()};
        by_boost.find(first.front(), goals);
        require_best(by_boost, first, goals, best_of_single(single, first, goals));

        using Linked = boost::adjacency_list<boost::listS, boost::listS, boost::directedS, boost::no_property,
                                             boost::property<boost::edge_weight_t, int>>;
        Linked linked(20); // its vertices have no numbers: they are hashed
        const std::vector<VertexOf<Linked>> places(vertices(linked).first, vertices(linked).second);
        for (auto e = edges(g); e.first != e.second; ++e.first)
            add_edge(places[source(*e.first, g)], places[target(*e.first, g)], get(boost::edge_weight, g, *e.first),
                     linked);
        std::vector<VertexOf<Linked>> from, to;
        for (const auto v : starts) from.push_back(places[v]);
        for (const auto v : goals) to.push_back(places[v]);
        AStar hashed{linked, AnyGoal{}};
        hashed.find(from, to);
        require_best(hashed, from, to, best);

        Waypoints<> roads;
        for (int i = 0; i < 20; ++i) roads.add(metres(double(random() % 99), double(random() % 99), 0.0));
        for (int i = 0; i < 40; ++i) roads.connect(random() % 20, random() % 20);
        roads.set_passable(random() % 20, false);
        AStar straight{roads};
        AStar by_road{roads, AnyGoal{}};
        by_road.find(starts, goals);
        const double shortest = best_of_single(straight, starts, goals);
        REQUIRE((by_road.outcome() == Outcome::found) == std::isfinite(shortest));
        if (by_road.outcome() == Outcome::found) REQUIRE(by_road.cost() == Approx(shortest).epsilon(1e-14));
    }
}

TEST_CASE("goals: the estimate is the least for each, a condition's that of the vertex; copies do not share",
          "[paths]") {
    const Grid<> map(60, 20);
    const std::vector<Cell> goals{{50, 10}, {20, 10}, {59, 19}};
    AStar any{map, AnyGoal{}};
    AStar blind{map, AnyGoal{}, ZeroHeuristic{}};
    REQUIRE(any.find(Cell{10, 10}, goals) == Outcome::found);
    REQUIRE(blind.find(Cell{10, 10}, goals) == Outcome::found);
    CHECK(any.path().back() == Cell{20, 10});
    CHECK(any.expanded() == 10); // straight there: exact on an empty map
    CHECK(blind.expanded() > 10 * any.expanded());
    CHECK(any.why() == "the path from (10, 10) to (20, 10) costs 10 tiles");

    AStar guided{map, GoalWhere{[](Cell c) { return c.x == 40; }},
                 By{[](Cell c) { return double(Tile<std::uint32_t>::straight) * std::abs(int(c.x) - 40); }}};
    REQUIRE(guided.find(Cell{10, 10}) == Outcome::found);
    CHECK(guided.expanded() == 30);

    any.begin(Cell{10, 10}, goals); // a copy in the middle of a search is one of its own
    any.advance(3);
    auto copy = any;
    any.find(Cell{10, 10}, std::vector<Cell>{{0, 0}});
    CHECK(any.path().back() == Cell{0, 0});
    CHECK(copy.advance(100) == Outcome::found);
    CHECK(copy.path().back() == Cell{20, 10});
    REQUIRE(copy.find(Cell{50, 11}, copy.goal().all().first(2)) == Outcome::found); // of what it holds itself
    CHECK(copy.goal().all().size() == 2);
    CHECK(copy.path().back() == Cell{50, 10});
    REQUIRE(copy.find(copy.path(), copy.path()) == Outcome::found); // and of the path that it forgets
    CHECK(copy.cost() == 0);
}

TEST_CASE("goals: what is refused, and what is said where there is no way", "[paths]") {
    Grid<> map(8, 8);
    AStar any{map, AnyGoal{}};
    const std::vector<Cell> none, one{{3, 3}}, outside{{3, 3}, {8, 0}};
    REQUIRE(any.find(Cell{1, 1}, one) == Outcome::found);
    CHECK(test::refusal([&] {
              any.find(Cell{1, 1}, none);
          }) == "AStar: the number of goals is 0; there must be one at least");
    CHECK(test::refusal([&] { any.find(none, one); }) ==
          "AStar: the number of starts is 0; there must be one at least");
    CHECK(test::refusal([&] { any.find(Cell{1, 1}, outside); }) == "AStar: goal is (8, 0); the map has 8 x 8 tiles");
    CHECK(test::refusal([&] { any.find(outside, one); }) == "AStar: start is (8, 0); the map has 8 x 8 tiles");
    CHECK(any.outcome() == Outcome::found); // refused before anything was touched
    CHECK(any.path().back() == Cell{3, 3});

    map.set_passable(Cell{3, 3}, false);
    CHECK(any.find(Cell{1, 1}, one) == Outcome::blocked);
    CHECK(any.why() == "there is no path from (1, 1) to (3, 3): the goal is blocked");
    const std::vector<Cell> two{{3, 3}, {7, 7}};
    CHECK(any.find(two, std::vector<Cell>{{3, 3}, {5, 7}}) == Outcome::found); // the free ones
    CHECK(any.path().front() == Cell{7, 7});
    CHECK(any.find(one, two) == Outcome::blocked);
    CHECK(any.why() == "there is no path from (3, 3) to any of 2 goals: the start is blocked");
    for (std::uint16_t y = 0; y < 8; ++y) map.set_passable(Cell{4, y}, false);
    CHECK(any.find(std::vector<Cell>{{0, 0}, {1, 1}}, two) == Outcome::no_path);
    CHECK(any.why() == "there is no path from any of 2 starts to any of 2 goals: all 31 nodes that can be reached were "
                       "expanded");
    AStar where{map, GoalWhere{[](Cell c) { return c.x == 6; }}};
    CHECK(where.find(Cell{0, 0}) == Outcome::no_path);
    CHECK_THAT(where.why(), ContainsSubstring("no path from (0, 0) to a node that meets the condition"));
}

TEST_CASE("what a search found as Boost.Graph's maps: equal to its own Dijkstra's", "[paths]") {
    std::mt19937 random(63);
    for (int k = 0; k < 100; ++k) {
        const Roads g = random_roads(random, 30, 60, 9);
        AStar all{g, GoalWhere{[](std::size_t) { return false; }}};
        REQUIRE(all.find(7) == Outcome::no_path);
        using Search = decltype(all);
        BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<PredecessorMap<Search>, std::size_t>));
        BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<DistanceMap<Search>, std::size_t>));
        std::vector<std::size_t> before(30), theirs_before(30);
        std::vector<int> costs(30), theirs(30);
        write_maps(all, boost::make_iterator_property_map(before.begin(), get(boost::vertex_index, g)),
                   boost::make_iterator_property_map(costs.begin(), get(boost::vertex_index, g)));
        boost::dijkstra_shortest_paths(g, 7, boost::distance_map(theirs.data()).predecessor_map(theirs_before.data()));
        REQUIRE(costs == theirs);
        for (std::size_t v = 0; v < 30; ++v) { // of equally cheap ways either will do
            REQUIRE((before[v] == v) == (theirs_before[v] == v));
            const auto step = boost::edge(before[v], v, g);
            REQUIRE((before[v] == v || (step.second && costs[before[v]] <= costs[v])));
        }
    }
}
