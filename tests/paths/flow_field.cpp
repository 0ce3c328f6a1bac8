// SPDX-License-Identifier: BSL-1.0
// A flow field holds the true costs: Bellman and Ford's on graphs made at random, those of the files on MovingAI's
// maps; its steps are steps of the graph and add up to them.
// Compiled with optimisation: it asks for the true cost of every tile of large maps, which takes a minute without.
// Runs long with the sanitizers.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/moving_ai.hpp>
#include <ansatz/paths/true_costs.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace paths_tests;

namespace {

template <class Cost> constexpr Cost never = paths::detail::infinite<Cost>;

/// What it costs from each vertex to the nearest goal: relaxed over all edges until nothing changes.
template <class Cost, class Graph, class Weight>
std::vector<Cost> brute_force(const Graph& g, const std::vector<VertexOf<Graph>>& goals, Weight&& weight) {
    const auto index = get(boost::vertex_index, g);
    std::vector<Cost> costs(num_vertices(g), never<Cost>);
    for (const auto& goal : goals)
        if (!paths::detail::blocked(goal, g)) costs[get(index, goal)] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (auto all = vertices(g); all.first != all.second; ++all.first) {
            const VertexOf<Graph> v = *all.first;
            if (paths::detail::blocked(v, g)) continue;
            for (auto out = out_edges(v, g); out.first != out.second; ++out.first) {
                const auto edge = *out.first;
                const VertexOf<Graph> q = target(edge, g);
                if (!paths::detail::edge_passable(edge, g) || paths::detail::blocked(q, g)) continue;
                const Cost beyond = costs[get(index, q)];
                if (beyond == never<Cost> || !(beyond + Cost(weight(edge)) < costs[get(index, v)])) continue;
                costs[get(index, v)] = beyond + Cost(weight(edge)), changed = true;
            }
        }
    }
    return costs;
}
/// A field against the costs: equal everywhere, and every step leads to a vertex from where so much less is left.
template <class Field, class Weight>
void require_true(const Field& field, const std::vector<typename Field::Cost>& costs, Weight&& weight) {
    const auto& g = field.graph();
    const auto index = get(boost::vertex_index, g);
    for (auto all = vertices(g); all.first != all.second; ++all.first) {
        const typename Field::Vertex v = *all.first, next = field.next(v);
        REQUIRE(field.cost(v) == costs[get(index, v)]);
        if (field.cost(v) == 0 || !field.reaches(v)) {
            REQUIRE((next == v || field.cost(next) == 0)); // an edge may cost nothing
            continue;
        }
        auto least = never<typename Field::Cost>;
        for (auto out = out_edges(v, g); out.first != out.second; ++out.first)
            if (target(*out.first, g) == next && paths::detail::edge_passable(*out.first, g))
                least = std::min(least, typename Field::Cost(weight(*out.first)));
        REQUIRE(least < never<typename Field::Cost>);
        REQUIRE(field.cost(next) + least == field.cost(v));
    }
}
/// A map at random, whose ground and thin walls are too.
template <class Map> Map wild(std::mt19937& random) {
    auto map = random_map<Map>(random, 3 + random() % 8, 3 + random() % 8, 0.25);
    for (int i = 0; i < 8; ++i) { // steps that lead one way only
        const Cell c = random_cell(random, map.width(), map.height());
        const Cell east{std::uint16_t(c.x + 1), c.y};
        if (map.contains(east)) random() % 2 ? map.set_passable(c, east, false) : map.set_passable(east, c, false);
    }
    if constexpr (std::is_same_v<typename Map::ground, Terrain>)
        for (int i = 0; i < 20; ++i)
            map.set_weight(random_cell(random, map.width(), map.height()), double(1 + random() % 7));
    return map;
}
template <class Map> void check_maps(std::uint32_t seed, int maps) {
    std::mt19937 random(seed);
    for (int k = 0; k < maps; ++k) {
        const Map map = wild<Map>(random);
        std::vector<Cell> goals(1 + random() % 3);
        for (auto& goal : goals) goal = random_cell(random, map.width(), map.height());
        const auto weights = edge_weights(map, std::type_identity<std::uint32_t>{});
        const auto weight = [&](const GridEdge& e) { return get(weights, e); };
        const auto costs = brute_force<std::uint32_t>(map, goals, weight);
        FlowField heap{map};
        FlowField buckets{map, Buckets{}};
        for (int again = 0; again < 2; ++again) { // warm as cold
            REQUIRE(heap.aim(goals) == buckets.aim(goals));
            require_true(heap, costs, weight);
            require_true(buckets, costs, weight);
        }
    }
}

} // namespace

TEST_CASE("a flow field on maps at random holds the costs of brute force", "[paths]") {
    check_maps<Grid<>>(71, 150);
    check_maps<Grid<Eight<OneFree>>>(72, 50);
    check_maps<Grid<Four>>(73, 50);
    check_maps<Grid<Eight<>, Terrain>>(74, 100);
}

TEST_CASE("a flow field on graphs of Boost.Graph and on way points", "[paths]") {
    std::mt19937 random(75);
    for (int k = 0; k < 150; ++k) {
        const Roads g = random_roads(random, 16, 40, 6);
        const std::vector<std::size_t> goals{random() % 16, random() % 16};
        const auto weight = [&](const EdgeOf<Roads>& e) { return get(boost::edge_weight, g, e); };
        FlowField field{g};
        REQUIRE(field.aim(goals) == Outcome::found);
        require_true(field, brute_force<int>(g, goals, weight), weight);
        FlowField fewest{g, WeightsOf{boost::make_static_property_map<EdgeOf<Roads>>(1)}, Buckets{}};
        REQUIRE(fewest.aim(goals) == Outcome::found);
        const auto one = [](const EdgeOf<Roads>&) { return 1; };
        require_true(fewest, brute_force<int>(g, goals, one), one);

        Waypoints<ByTime> roads;
        for (int i = 0; i < 16; ++i) roads.add(metres(double(random() % 99), double(random() % 99), 0.0));
        for (int i = 0; i < 40; ++i)
            roads.connect(random() % 16, random() % 16, double(1 + random() % 4) * metre / second);
        roads.set_passable(random() % 16, false);
        roads.set_road_passable(random() % 40, false);
        FlowField quickest{roads};
        quickest.aim(goals);
        const auto time = [&](const Road& r) { return roads.cost_of(r.number); };
        require_true(quickest, brute_force<double>(roads, goals, time), time);
    }
}

TEST_CASE("a flow field: ways, directions, changes of the map, and what is refused", "[paths]") {
    auto map = grid_from<Grid<>>({"......", ".####.", "....#.", "....##"});
    FlowField field{map};
    CHECK_FALSE(field.is_current()); // nobody has aimed it
    CHECK_FALSE(field.reaches(Cell{0, 0}));
    CHECK(field.next(Cell{0, 0}) == Cell{0, 0});
    REQUIRE(field.aim(Cell{5, 2}) == Outcome::found);
    std::vector<Cell> way;
    field.path(Cell{3, 3}, way);
    AStar search{map};
    REQUIRE(search.find(Cell{3, 3}, Cell{5, 2}) == Outcome::found);
    CHECK(field.cost(Cell{3, 3}) == search.cost());
    CHECK(map.tiles(way) == map.tiles(search.path()));
    CHECK((way.front() == Cell{3, 3} && way.back() == Cell{5, 2}));
    CHECK(field.direction(Cell{0, 0}) == Vector<double, 2>(1, 0));
    CHECK(field.direction(Cell{5, 0}) == Vector<double, 2>(0, 1));
    CHECK(field.direction(Cell{2, 3}).norm() == Approx(1));
    CHECK(field.direction(Cell{5, 2}).norm() == 0);
    CHECK(field.cost(Cell{9, 9}) == never<std::uint32_t>); // outside

    CHECK(field.is_current());
    const auto copy = field;
    map.set_passable(Cell{5, 1}, false);
    CHECK_FALSE(field.is_current());
    REQUIRE(field.aim(Cell{5, 2}) == Outcome::found);
    CHECK_FALSE(field.reaches(Cell{0, 0}));
    field.path(Cell{0, 0}, way);
    CHECK(way.empty());
    CHECK(copy.reaches(Cell{0, 0})); // a copy is one of its own
    CHECK(field.aim(Cell{1, 1}) == Outcome::blocked);
    CHECK_FALSE(field.reaches(Cell{0, 0}));

    REQUIRE(field.aim(Cell{0, 0}) == Outcome::found);
    CHECK(test::refusal([&] { field.aim(std::vector<Cell>{}); }) ==
          "FlowField: the number of goals is 0; there must be one at least");
    CHECK(test::refusal([&] { field.aim(Cell{6, 0}); }) == "FlowField: goal is (6, 0); the map has 6 x 4 tiles");
    CHECK(field.next(Cell{1, 0}) == Cell{0, 0}); // it keeps what it had

    Roads g(2);
    const auto edge = boost::add_edge(0, 1, 3, g).first;
    FlowField roads{g};
    roads.aim(1);
    put(boost::edge_weight, g, edge, -3);
    CHECK(test::refusal([&] { roads.aim(1); }) ==
          "FlowField: the weight of the edge from 0 to 1 is -3; a weight is a number and not negative");
    CHECK(roads.cost(0) == 3);
    const Grid<> wide(60000, 1);
    FlowField narrow{wide, CostIn<std::uint16_t>{}};
    CHECK(narrow.aim(Cell{0, 0}) == Outcome::too_far); // and it does not start again at zero
    CHECK(narrow.reaches(Cell{1, 0}));
    CHECK_FALSE(narrow.reaches(Cell{2, 0}));
}

TEST_CASE("MovingAI: a flow field holds the lengths of the scenarios, and the true cost of every tile",
          "[paths][data]") {
    const std::string folder = data_folder();
    if (folder.empty())
        SKIP("no data: there is no folder shared/data beside the project, and ANSATZ_TEST_DATA names none");
    for (const std::string name : {"arena", "brc202d", "AR0011SR", "16room_000", "random512-10-0", "maze512-8-0"}) {
        const std::string file = folder + "/movingai/" + name + ".map";
        const auto map = read_moving_ai_map(file).grid();
        const auto scenarios = read_moving_ai_scenarios(file + ".scen");
        FlowField field{map, Buckets{}};
        const auto aim = [&](const Scenario& s) {
            INFO(name << ", line " << s.line);
            REQUIRE(field.aim(s.goal) == Outcome::found);
            std::vector<Cell> way;
            field.path(s.start, way);
            REQUIRE(std::abs(cost_along(map, way) - s.length) <= s.tolerance);
        };
        aim(scenarios[scenarios.size() / 2]);
        aim(scenarios.back());
        const auto costs = true_costs<std::uint32_t>(map, scenarios.back().goal);
        bool equal = true;
        for (auto all = vertices(map); all.first != all.second; ++all.first)
            equal = equal && field.cost(*all.first) == costs[map.index(*all.first)];
        REQUIRE(equal);
    }
}
