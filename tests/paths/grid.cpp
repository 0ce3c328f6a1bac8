// SPDX-License-Identifier: BSL-1.0
// Grids: rules, flags, ground, in-place changes, heuristics, MovingAI's files (notes 6.1, 6.3).
// Runs long with the sanitizers.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/paths/grid/declaration.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/grid/ground.hpp>
#include <ansatz/paths/grid/neighbours.hpp>
#include <ansatz/paths/heuristics/checked.hpp>
#include <ansatz/paths/heuristics/euclid.hpp>
#include <ansatz/paths/heuristics/grid_metrics.hpp>
#include <ansatz/paths/heuristics/maximum.hpp>
#include <ansatz/paths/heuristics/unscaled.hpp>
#include <ansatz/paths/heuristics/weighted.hpp>
#include <ansatz/paths/true_costs.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

using namespace paths_tests;

namespace {

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Grid<>>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Grid<Four, Terrain>>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Grid<>, Cell, boost::vertex_index_t>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Grid<>, GridEdge, boost::edge_weight_t>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Waypoints<>>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Waypoints<ByTime, 2>>));

constexpr double root2 = 1.4142135623730950488;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random ground, walls and single shut edges.
Grid<Eight<>, Terrain> random_terrain(std::mt19937& random, std::size_t width, std::size_t height) {
    auto map = random_map<Grid<Eight<>, Terrain>>(random, width, height, 0.2);
    const double weights[] = {0, 0.25, 0.5, 1, 1, 2, 3.7};
    for (std::size_t k = 0; k < width * height; ++k) {
        const Cell c = random_cell(random, width, height);
        map.set_weight(c, weights[random() % std::size(weights)]);
        if (k % 4 != 0 || c.x + 1u >= width) continue;
        map.set_passable(c, Cell{std::uint16_t(c.x + 1), c.y}, false);
    }
    return map;
}

/// Every edge by the rule itself, without the grid's masks.
template <class Rule> bool by_rule(const Grid<Eight<Rule>>& map, Cell a, int dx, int dy) {
    auto free = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < int(map.width()) && y < int(map.height()) &&
               map.passable({std::uint16_t(x), std::uint16_t(y)});
    };
    if (!free(a.x, a.y) || !free(a.x + dx, a.y + dy)) return false;
    return dx == 0 || dy == 0 || Rule::passes(free(a.x + dx, a.y), free(a.x, a.y + dy));
}

template <class Rule> void check_rule(std::mt19937& random) {
    auto map = random_map<Grid<Eight<Rule>>>(random, 9, 7, 0.3);
    for (int change = 0; change < 200; ++change) {
        map.set_passable(random_cell(random, 9, 7), random() % 2 == 0);
        const Cell a = random_cell(random, 9, 7);
        std::size_t edges = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0) edges += by_rule(map, a, dx, dy);
        REQUIRE(out_degree(a, map) == edges);
        for (auto [e, end] = out_edges(a, map); e != end; ++e) {
            const Cell b = target(*e, map);
            REQUIRE(source(*e, map) == a);
            REQUIRE(by_rule(map, a, int(b.x) - a.x, int(b.y) - a.y));
            REQUIRE(map.passable(a, b));
            REQUIRE(get(get(boost::edge_weight, map), *e) == (a.x != b.x && a.y != b.y ? root2 : 1.0));
        }
    }
}

} // namespace

TEST_CASE("corner rules: the edges of a grid are those of its rule, through all changes", "[paths][grid]") {
    std::mt19937 random(2);
    check_rule<BothFree>(random);
    check_rule<OneFree>(random);
    check_rule<NoneFree>(random);
    const auto corner = grid_from<Grid<>>({".#", ".."});
    CHECK_FALSE(corner.passable(Cell{0, 0}, Cell{1, 1}));
    CHECK(grid_from<Grid<Eight<OneFree>>>({".#", ".."}).passable(Cell{0, 0}, Cell{1, 1}));
    CHECK_FALSE(grid_from<Grid<Eight<OneFree>>>({".#", "#."}).passable(Cell{0, 0}, Cell{1, 1}));
    CHECK(grid_from<Grid<Eight<NoneFree>>>({".#", "#."}).passable(Cell{0, 0}, Cell{1, 1}));
    CHECK(out_degree(Cell{1, 1}, Grid<Four>(3, 3)) == 4);
}

TEST_CASE("single edges are shut and opened, in one direction or both", "[paths][grid]") {
    Grid map(3, 1);
    AStar there{map};
    map.set_passable(Cell{0, 0}, Cell{1, 0}, false);
    CHECK(there.find(Cell{0, 0}, Cell{2, 0}) == Outcome::no_path);
    CHECK(there.find(Cell{2, 0}, Cell{0, 0}) == Outcome::found);
    map.set_passable(Cell{0, 0}, Cell{1, 0}, true);
    CHECK(there.find(Cell{0, 0}, Cell{2, 0}) == Outcome::found);
    map.set_wall(Cell{1, 0}, Cell{2, 0}, true);
    CHECK(there.find(Cell{2, 0}, Cell{0, 0}) == Outcome::no_path);
    map.set_passable(Cell{1, 0}, false);
    map.set_passable(Cell{1, 0}, true); // a tile that was rebuilt still has its wall
    CHECK_FALSE(map.passable(Cell{1, 0}, Cell{2, 0}));
    const auto version = map.version();
    map.set_wall(Cell{1, 0}, Cell{2, 0}, true); // nothing new
    CHECK(map.version() == version);
}

TEMPLATE_TEST_CASE("terrain, walls and shut edges: optimal as Dijkstra in every number and queue", "[paths][grid]",
                   std::uint32_t, std::uint64_t, float, double) {
    using Number = TestType;
    std::mt19937 random(4);
    int found = 0;
    for (int k = 0; k < 60; ++k) {
        const auto map = random_terrain(random, 24, 17);
        const Cell start = random_cell(random, 24, 17), goal = random_cell(random, 24, 17);
        const double best = true_costs<double>(map, goal)[map.index(start)];
        AStar heap{map, CostIn<Number>{}};
        AStar buckets{map, CostIn<Number>{}, Buckets{}};
        AStar both{map, CostIn<Number>{}, Maximum{Euclid{}, Chebyshev{}},
                   Buckets{0.37 * double(Tile<Number>::straight)}};
        auto same = [&](auto& search) {
            const auto outcome = search.find(start, goal);
            if (!map.passable(start) || !map.passable(goal)) return outcome == Outcome::blocked;
            if (best == infinity) return outcome == Outcome::no_path;
            ++found;
            // Whole numbers round a weight to 1/33461 of a tile.
            const double rounding = std::is_same_v<Number, double>  ? 1e-12
                                    : std::is_same_v<Number, float> ? 1e-5
                                                                    : 3e-5 * double(search.path().size());
            return outcome == Outcome::found &&
                   std::abs(cost_along(map, search.path()) - best) <= rounding * (1 + best);
        };
        INFO("map " << k << " from " << name_of(start) << " to " << name_of(goal) << ", the best costs " << best);
        REQUIRE(same(heap));
        REQUIRE(same(buckets));
        REQUIRE(same(both));
    }
    CHECK(found > 60);
}

TEST_CASE("every algorithm of Boost.Graph that needs no more runs on a grid, and astar_search is an engine",
          "[paths][grid]") {
    std::mt19937 random(6);
    const auto map = random_map(random, 20, 20, 0.25);
    std::vector<double> costs(map.size());
    const Cell start{0, 0};
    boost::dijkstra_shortest_paths(
        map, start,
        boost::distance_map(boost::make_iterator_property_map(costs.begin(), get(boost::vertex_index, map))));
    AStar ours{map, CostIn<double>{}};
    AStar boosts{map, CostIn<double>{}, BoostAStar{}};
    for (auto [v, end] = vertices(map); v != end; ++v) {
        if (!map.passable(*v) || !map.passable(start)) continue;
        const bool reached = costs[map.index(*v)] < 1e300;
        REQUIRE((ours.find(start, *v) == Outcome::found) == reached);
        REQUIRE((boosts.find(start, *v) == Outcome::found) == reached);
        if (!reached) continue;
        REQUIRE(ours.cost() == Approx(costs[map.index(*v)]));
        REQUIRE(boosts.cost() == Approx(costs[map.index(*v)]));
        REQUIRE(cost_along(map, boosts.path()) == Approx(boosts.cost()));
    }
}

TEST_CASE("heuristics: their values, which are never too much, and the node where one is", "[paths][grid]") {
    const Grid map(40, 30);
    auto h = [&](const auto& policy) { return policy.template bind<double>(map, Cell{10, 10})(Cell{14, 13}); };
    CHECK(h(ZeroHeuristic{}) == 0);
    CHECK(h(Manhattan{}) == 7);
    CHECK(h(Octile{}) == Approx(3 * root2 + 1));
    CHECK(h(Chebyshev{}) == 4);
    CHECK(h(Euclid{}) == Approx(5));
    CHECK(h(Weighted{Octile{}, 2}) == Approx(2 * (3 * root2 + 1)));
    CHECK(h(Maximum{Chebyshev{}, Euclid{}}) == Approx(5));
    CHECK(Octile{}.bind<std::uint32_t>(map, Cell{0, 0})(Cell{2, 5}) == 2 * 47321 + 3 * 33461);

    std::mt19937 random(9);
    for (int k = 0; k < 20; ++k) {
        const auto terrain = random_terrain(random, 15, 12);
        const Cell goal = random_cell(random, 15, 12);
        CHECK_FALSE(check_heuristic(terrain, Octile{}, goal));
        CHECK_FALSE(check_heuristic(terrain, Euclid{}, goal));
        CHECK_FALSE(check_heuristic<std::uint32_t>(terrain, Octile{}, goal));
        CHECK_FALSE(check_heuristic<std::uint32_t>(terrain, Maximum{Chebyshev{}, Euclid{}}, goal));
    }
    // A road of half the weight: counted as if every tile weighed 1, Octile is too much, and the path is not the best.
    const auto road = grid_from<Grid<Eight<>, Terrain>>({".....", ".....", "....."});
    auto halved = road;
    for (std::uint16_t x = 0; x < 5; ++x) halved.set_weight(Cell{x, 0}, 0.5);
    CHECK_FALSE(check_heuristic(halved, Octile{}, Cell{4, 0}));
    const auto wrong = check_heuristic<double>(halved, Unscaled{Octile{}}, Cell{4, 0});
    REQUIRE(wrong);
    CHECK(wrong->node == Cell{0, 1}); // beside the end of the road: a diagonal onto it, then three tiles of a half
    CHECK(wrong->estimate == Approx(3 + root2));
    CHECK(wrong->true_cost == Approx((3 + root2) / 2));
    CHECK_THAT(wrong->sentence, ContainsSubstring("the heuristic overestimates at node (0, 1): h is 4.41"));
    HeuristicReport report;
    AStar watched{map, Checked{Manhattan{}, report}};
    watched.find(Cell{0, 0}, Cell{5, 5});
    CHECK(report.overestimates > 0);
    CHECK_THAT(report.worst, ContainsSubstring("overestimates at node (0, 0)"));
    const auto least = halved.least_weight();
    CHECK(least == 0.5);
    for (std::uint16_t x = 0; x < 5; ++x) halved.set_weight(Cell{x, 0}, 2);
    CHECK(halved.least_weight() == 1); // it rises again when nothing light is left
}

TEST_CASE("hard case P3: a weighted search stays within its weight on grids", "[paths][grid][P4]") {
    std::mt19937 random(8);
    int queries = 0;
    for (int k = 0; k < 1000; ++k) {
        const auto map = random_map(random, 128, 128, 0.2);
        const Cell a = random_cell(random, 128, 128), b = random_cell(random, 128, 128);
        AStar exact{map};
        if (exact.find(a, b) != Outcome::found) continue;
        ++queries;
        for (const double w : {1.0, 1.2, 1.5, 2.0, 3.0, 5.0}) {
            AStar quick{map, Weighted{Octile{}, w}, NoReopening{}};
            REQUIRE(quick.find(a, b) == Outcome::found);
            REQUIRE(double(quick.cost()) <= w * double(exact.cost()));
        }
        AStar single{map, CostIn<float>{}}; // P4
        REQUIRE(single.find(a, b) == Outcome::found);
        REQUIRE(map.tiles(single.path()) <= map.tiles(exact.path()) * (1 + 1e-6));
    }
    CHECK(queries > 400);
}

TEST_CASE("quantities: lengths, places and travel times", "[paths][grid]") {
    auto map = grid_from<Grid<Eight<>, Terrain>>({"...", ".3."}, 2.0 * metre);
    const Cell path[] = {{0, 0}, {1, 1}, {2, 1}};
    CHECK(map.length(path).value() == Approx(2 * (1 + root2)));
    CHECK(map.cost(path) == Approx(3 * root2 + 1));
    CHECK(map.travel_time(path, 4.0 * metre_per_second).value() == Approx(2 * (3 * root2 + 1) / 4));
    CHECK(map.position(Cell{2, 1}) == metres(5, 3));
    CHECK(map.cell_at(metres(5.9, 2.0)) == Cell{2, 1});
    CHECK_THAT(test::refusal([&] { map.cell_at(metres(6, 0)); }),
               ContainsSubstring("Grid::cell_at: the place is (6, 0) m; the map has 3 x 2 tiles"));
    CHECK_THAT(test::refusal([&] { map.travel_time(path, 0.0 * metre_per_second); }),
               ContainsSubstring("speed is 0 m/s"));
    CHECK_THAT(test::refusal([] { Grid(3, 3, -1.0 * metre); }), ContainsSubstring("Grid: tile is -1 m"));

    Waypoints<ByTime> ways;
    for (const auto& at : {metres(0, 0, 0), metres(3, 4, 0), metres(10, 0, 0)}) ways.add(at);
    ways.connect_both(0, 1, 5.0 * metre_per_second);
    const auto winding = ways.connect(1, 2, 20.0 * metre, 10.0 * metre_per_second);
    ways.connect(0, 2, 2.0 * metre_per_second);
    AStar search{ways};
    REQUIRE(search.find(0, 2) == Outcome::found);
    CHECK(search.why() == "the path from 0 to 2 costs 3 s"); // 5 m at 5 m/s, then 20 m at 10 m/s
    const Grid even(4, 3);
    AStar on_tiles{even};
    REQUIRE(on_tiles.find({0, 0}, {2, 1}) == Outcome::found);
    CHECK(on_tiles.why() ==
          "the path from (0, 0) to (2, 1) costs 2.4142137 tiles"); // 1 + the root of 2, and not what it counts in
    CHECK(ways.travel_time(search.path()).value() == Approx(3));
    CHECK(ways.length(search.path()).value() == Approx(25));
    ways.set_road_passable(winding, false);
    CHECK(search.find(0, 2) == Outcome::found);
    CHECK(ways.travel_time(search.path()).value() == Approx(5));
    ways.set_road_passable(winding, true);
    ways.set_passable(1, false);
    Trace<std::size_t> trace;
    CHECK(search.find(0, 2, search.without_end, trace) == Outcome::found);
    CHECK(search.path().size() == 2);
    CHECK(search.find(0, 1) == Outcome::blocked);
    CHECK(search.why() == "there is no path from 0 to 1: the goal is blocked");
    CHECK_THAT(test::refusal([&] { ways.connect(0, 9, 1.0 * metre_per_second); }),
               ContainsSubstring("the place is 9; there are 3 places"));
    CHECK_THAT(test::refusal([&] { ways.connect(0, 1, 4.0 * metre, 1.0 * metre_per_second); }),
               ContainsSubstring("at least the straight distance, 5 m"));
    CHECK_THAT(test::refusal([&] { ways.set_speed(0, not_a_number * metre_per_second); }),
               ContainsSubstring("the speed is nan m/s"));
    CHECK_THAT(test::refusal([&] { ways.add(metres(0, infinity, 0)); }),
               ContainsSubstring("the place is (0, inf, 0) m"));
    CHECK(ways.size() == 3);
}

TEST_CASE("what a grid is given wrongly it refuses when it is set, and stays as it was", "[paths][grid]") {
    Grid<Eight<>, Terrain> map(4, 3);
    const auto version = map.version();
    for (const double bad : {-1.0, not_a_number, infinity, -infinity, 60001.0})
        CHECK_THAT(test::refusal([&] {
                       map.set_weight(Cell{2, 1}, bad);
                   }),
                   ContainsSubstring("Grid::set_weight: the weight of (2, 1) is " + describe(bad)));
    CHECK(map.weight(Cell{2, 1}) == 1);
    CHECK(map.least_weight() == 1);
    CHECK_THAT(test::refusal([&] {
                   map.set_weight(Cell{4, 0}, 1);
               }),
               ContainsSubstring("the tile is (4, 0); the map has 4 x 3 tiles"));
    CHECK_THAT(test::refusal([&] { map.set_passable(Cell{0, 3}, false); }), ContainsSubstring("the tile is (0, 3)"));
    CHECK_THAT(test::refusal([&] {
                   map.set_passable(Cell{0, 0}, Cell{2, 0}, false);
               }),
               ContainsSubstring("the edge is (0, 0) to (2, 0)"));
    CHECK_THAT(test::refusal([&] { map.set_passable(std::vector<std::uint8_t>(5)); }),
               ContainsSubstring("the map has 12 tiles"));
    CHECK(map.version() == version);
    CHECK_THAT(test::refusal([] { Grid(0, 5); }), ContainsSubstring("Grid: width is 0"));
    CHECK_THAT(test::refusal([] { Grid(5, 65536); }), ContainsSubstring("Grid: height is 65536"));
    CHECK_THAT(test::refusal([] { grid_from({"..", "..."}); }), ContainsSubstring("the length of row 1 is 3"));
    CHECK_THAT(test::refusal([] { grid_from({".x"}); }), ContainsSubstring("row 0, column 1 is 'x'"));
    AStar search{map};
    CHECK_THAT(test::refusal([&] {
                   search.find(Cell{0, 0}, Cell{4, 2});
               }),
               ContainsSubstring("AStar: goal is (4, 2); the map has 4 x 3 tiles"));
    CHECK_THAT(test::refusal([&] {
                   search.begin(Cell{0, 9}, Cell{1, 2});
               }),
               ContainsSubstring("AStar: start is (0, 9)"));
    map.set_passable(Cell{3, 2}, false);
    CHECK(search.find(Cell{0, 0}, Cell{3, 2}) == Outcome::blocked);
    CHECK(search.why() == "there is no path from (0, 0) to (3, 2): the goal is blocked");
    CHECK(search.find(Cell{3, 2}, Cell{0, 0}) == Outcome::blocked);
    CHECK(search.why() == "there is no path from (3, 2) to (0, 0): the start is blocked");
}

TEST_CASE("whole numbers of a search end in a sentence, not in nonsense", "[paths][grid]") {
    Grid<Eight<>, Terrain> map(40, 1);
    for (std::uint16_t x = 0; x < 40; ++x) map.set_weight(Cell{x, 0}, 60000);
    AStar search{map};
    CHECK(search.find(Cell{0, 0}, Cell{1, 0}) == Outcome::found);
    CHECK(search.find(Cell{0, 0}, Cell{39, 0}) == Outcome::too_far);
    CHECK_THAT(search.why(), ContainsSubstring("take CostIn<std::uint64_t>"));
    AStar wide{map, CostIn<std::uint64_t>{}, Buckets{}};
    CHECK(wide.find(Cell{0, 0}, Cell{39, 0}) == Outcome::found);
    CHECK(map.cost(wide.path()) == Approx(39 * 60000.0));
}
