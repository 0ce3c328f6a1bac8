// SPDX-License-Identifier: BSL-1.0
// What a heuristic is judged by, and estimates that are more than a cost's number holds.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/true_costs.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace paths_tests;

TEST_CASE("a heuristic is judged in the number in which the search counts", "[paths]") {
    std::mt19937 random(41);
    const auto map = random_map(random, 20, 20, 0.1);
    const Cell goal{10, 10};
    const auto tiles = [](Cell c, Cell g) { // columns and rows, diagonals at their price
        const int dx = std::abs(int(c.x) - g.x), dy = std::abs(int(c.y) - g.y);
        return std::pair(std::min(dx, dy), std::max(dx, dy) - std::min(dx, dy));
    };
    // On a grid 33461 and 47321 a tile is the right measure; it is 33461 times too much for costs that are counted in
    // tiles.
    const By whole{
        [&](Cell c, Cell g) { return 47321u * unsigned(tiles(c, g).first) + 33461u * unsigned(tiles(c, g).second); }};
    CHECK_FALSE(check_heuristic(map, whole, goal));
    CHECK(check_heuristic(map, whole, goal, CostIn<double>{}));
    CHECK(check_heuristic<double>(map, whole, goal));
    CHECK_FALSE(check_heuristic(map, Octile{}, goal));
    const By twice{[&](Cell c, Cell g) {
        return 2 * (47321u * unsigned(tiles(c, g).first) + 33461u * unsigned(tiles(c, g).second));
    }};
    const auto wrong = check_heuristic(map, twice, goal);
    REQUIRE(wrong);
    CHECK_THAT(wrong->sentence, ContainsSubstring("tiles, the true cost to the goal is ")); // in words of the graph
    // What the check says is what the search does: an estimate that it passes finds the best path, one a node too high
    // is told.
    for (int k = 0; k < 200; ++k) {
        const Roads g = random_roads(random, 12, 36, 9);
        const auto truth = true_costs<int>(g, 11);
        std::vector<double> h(12);
        bool over = false;
        for (std::size_t v = 0; v < 12;
             ++v) { // a fraction is cut off by a search in whole numbers: 2.9 is no more than 2
            h[v] = truth[v] == std::numeric_limits<int>::max()
                       ? 5
                       : truth[v] + 0.9 - double(random() % 4) + (random() % 40 == 0 ? 1 : 0);
            over = over || (truth[v] != std::numeric_limits<int>::max() && int(std::max(0.0, h[v])) > truth[v]);
        }
        const By guess{[&](std::size_t v) { return h[v]; }};
        REQUIRE(check_heuristic(g, guess, std::size_t(11)).has_value() == over);
        AStar search{g, guess};
        if (search.find(0, 11) == Outcome::found && !over) REQUIRE(search.cost() == truth[0]);
    }
}

TEST_CASE("a heuristic is judged by the weights that the search has", "[paths]") {
    std::mt19937 random(42);
    int over = 0;
    for (int k = 0; k < 100; ++k) {
        const Roads g = random_roads(random, 12, 36, 9);
        // The search goes by halves of the weights of the graph.
        const WeightsOf halves{boost::make_function_property_map<Roads::edge_descriptor>(
            [&g](const Roads::edge_descriptor& e) { return get(boost::edge_weight, g, e) / 2.0; })};
        const std::size_t goal = 11;
        const auto truth = true_costs<double>(g, goal, Toward::to_it, halves);
        const auto whole = true_costs<double>(g, goal);
        for (std::size_t v = 0; v < 12; ++v) REQUIRE(2 * truth[v] == whole[v]);
        const By exact{[&](std::size_t v) { return std::min(truth[v], 1e9); }};
        const By twice{[&](std::size_t v) { return std::min(whole[v], 1e9); }};
        REQUIRE_FALSE(check_heuristic(g, exact, goal, halves));
        const bool any = std::any_of(truth.begin(), truth.end(), [](double d) { return d > 0 && d < 1e9; });
        REQUIRE(check_heuristic(g, twice, goal, halves).has_value() == any);
        HeuristicReport right, high;
        AStar search{g, Checked{exact, right, halves}, halves};
        AStar astray{g, Checked{twice, high, halves}, halves};
        search.find(0, goal), astray.find(0, goal);
        REQUIRE(right.overestimates == 0);
        over += high.overestimates > 0;
        const Landmarks<double> marks(g, 3, halves);
        REQUIRE_FALSE(check_heuristic(g, marks, goal, halves));
        AStar by_marks{g, marks, halves};
        if (by_marks.find(0, goal) == Outcome::found) REQUIRE(by_marks.cost() == Approx(truth[0]));
    }
    CHECK(over > 20);
}

TEST_CASE("an estimate may be more than a cost's number holds; the path counts, not the estimate", "[paths]") {
    // A corridor, long in a number of a few bits: the path costs nearly as much as fits, the estimate w times that.
    const auto check = [](auto number, double w, bool by_boost) {
        using Cost = decltype(number);
        const std::size_t n = 40;
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                              boost::property<boost::edge_weight_t, Cost>>
            g(2 * n);
        const Cost step = Cost(std::numeric_limits<Cost>::max() / Cost(n + 2));
        for (std::size_t v = 0; v + 1 < n; ++v) {
            add_edge(v, v + 1, step, g);         // the way
            add_edge(n + v, n + v + 1, step, g); // and one beside it that leads nowhere
            add_edge(v, n + v, Cost(0), g);
        }
        const By left{
            [&](std::size_t v) { return v < n ? Cost(step * Cost(n - 1 - v)) : Cost(step * Cost(2 * n - v - 1)); }};
        const auto searched = [&](auto&& search) {
            INFO("w = " << w << ", " << (by_boost ? "Boost" : "ours") << ", a cost of " << sizeof(Cost) << " bytes");
            REQUIRE(search.find(0, n - 1) == Outcome::found);
            CHECK(search.cost() == Cost(step * Cost(n - 1)));
            // As in a number without end: h is w times as much, and f = g + h.
            const auto* start = search.node(0);
            CHECK(double(start->h) == Approx(w * double(step) * double(n - 1)).epsilon(1e-6));
            CHECK(double(start->f()) == double(start->h));
            const auto* next = search.node(1);
            CHECK(double(next->f()) == Approx(double(step) + w * double(step) * double(n - 2)).epsilon(1e-6));
            CHECK(search.expanded() <= 2 * n);
        };
        if (by_boost) searched(AStar{g, Weighted{left, w}, BoostAStar{}});
        else {
            searched(AStar{g, Weighted{left, w}, NoReopening{}});
            searched(AStar{g, Weighted{left, w}, Buckets{double(step) / 8}});
            searched(AStar{g, Maximum{ZeroHeuristic{}, Weighted{left, w}}});
            HeuristicReport report;
            searched(AStar{g, Checked{Weighted{left, w}, report}});
            CHECK((report.overestimates > 0) == (w > 1));
            CHECK(check_heuristic(g, Weighted{left, w}, n - 1).has_value() == (w > 1));
        }
    };
    for (const double w : {1.0, 1.5, 3.0, 100.0})
        for (const bool by_boost : {false, true}) {
            check(std::uint32_t(0), w, by_boost);
            check(std::int32_t(0), w, by_boost);
            check(std::uint16_t(0), w, by_boost);
        }
    // The same on tiles: within w of the best on the longest map there is, by every queue and engine.
    const Grid<> corridor(65535, 2);
    const Cell start{0, 0}, goal{65534, 1};
    for (const double w : {1.5, 2.5, 5.0}) {
        AStar heap{corridor, Weighted{Octile{}, w}, NoReopening{}};
        AStar by_boost{corridor, Weighted{Octile{}, w}, BoostAStar{}};
        REQUIRE(heap.find(start, goal) == Outcome::found);
        CHECK(heap.expanded() == 65534); // straight on, as a search in a wider number
        INFO(by_boost.why());
        REQUIRE(by_boost.find(start, goal) == Outcome::found);
        CHECK(corridor.tiles(by_boost.path()) <= w * (65533 + std::sqrt(2.0)) + 1e-6);
    }
}

TEST_CASE("where a cost is more than its number holds nobody claims that there is a path", "[paths]") {
    Grid<Eight<>, Terrain> map(40, 1);
    for (std::uint16_t x = 0; x < 40; ++x) map.set_weight(Cell{x, 0}, 60000);
    map.set_passable(Cell{38, 0}, false); // and there is none
    AStar search{map};
    REQUIRE(search.find(Cell{0, 0}, Cell{39, 0}) == Outcome::too_far);
    CHECK(search.why() ==
          "no path from (0, 0) to (39, 0) was found whose cost its number holds, and there were ways that cost more; "
          "take CostIn<std::uint64_t> or CostIn<double>");
    AStar wide{map, CostIn<std::uint64_t>{}};
    CHECK(wide.find(Cell{0, 0}, Cell{39, 0}) == Outcome::no_path);
    // Boost's loop knows no such end; its outcome is the same.
    map.set_passable(Cell{38, 0}, true);
    AStar by_boost{map, BoostAStar{}};
    CHECK(by_boost.find(Cell{0, 0}, Cell{39, 0}) == Outcome::too_far);
    CHECK(by_boost.find(Cell{0, 0}, Cell{1, 0}) == Outcome::found);
}

TEST_CASE("Buckets open a node again far less often than a heap where an estimate is not consistent", "[paths][P1]") {
    // After A. Martelli (1977): vertex j leads to every i < j, and each way through one more vertex is cheaper by one.
    // The estimates make vertex 1 the first to be expanded, then 2, then 1 again, then 3, and so on: a search by f
    // counts in binary.
    const int n = 14;
    Roads g(n + 1);
    for (int j = 2; j <= n; ++j)
        for (int i = 1; i < j; ++i) boost::add_edge(j, i, (1 << (j - 2)) - (1 << (i - 1)) + (j - i), g);
    boost::add_edge(1, 0, (1 << (n - 1)) + 2 * n, g);
    const By jumps{[](std::size_t v) { return v == 0 || v == n ? 0 : (1 << (v - 1)) + 2 * int(v) - 3; }};
    REQUIRE_FALSE(check_heuristic(g, jumps, std::size_t(0)));
    AStar heap{g, jumps};
    AStar buckets{g, jumps, Buckets{}};
    REQUIRE(heap.find(n, 0) == Outcome::found);
    REQUIRE(buckets.find(n, 0) == Outcome::found);
    CHECK(heap.expanded() == std::size_t(1) << (n - 1));
    CHECK(buckets.expanded() <= 1 + n * (n - 1) / 2);
    CHECK(buckets.cost() == heap.cost());
    CHECK(true_costs<int>(g, 0)[n] == heap.cost());
}

TEMPLATE_TEST_CASE("Buckets with an estimate that jumps: the costs of a heap, and no more nodes", "[paths]",
                   std::uint32_t, double) {
    std::mt19937 random(44);
    std::size_t by_heap = 0, by_buckets = 0;
    for (int k = 0; k < 60; ++k) {
        Grid<Eight<>, Terrain> map(40, 40);
        for (std::size_t i = 0; i < map.size(); ++i) {
            const Cell c{std::uint16_t(i % 40), std::uint16_t(i / 40)};
            map.set_passable(c, random() % 5 != 0);
            if (k % 3 == 2 && random() % 2 == 0) map.set_weight(c, double(1 + random() % 30)); // beyond the ring, too
        }
        const std::uint32_t seed = std::uint32_t(random());
        const By jumps{[seed](Cell v, Cell goal) {
            const auto quarters = ((v.x * 2654435761u) ^ (v.y * 2246822519u) ^ seed) >> 30; // 0 to 3
            const auto h = Octile::of<std::uint32_t>(ansatz::paths::detail::Apart(v, goal), 33461, 47321);
            return TestType(h) / Tile<std::uint32_t>::straight * Tile<TestType>::straight / 4 * TestType(1 + quarters);
        }};
        AStar truth{map, ZeroHeuristic{}, CostIn<TestType>{}};
        AStar heap{map, jumps, CostIn<TestType>{}};
        AStar buckets{map, jumps, CostIn<TestType>{}, Buckets{}};
        const Cell from = random_cell(random, 40, 40), to = random_cell(random, 40, 40);
        const auto outcome = truth.find(from, to);
        REQUIRE(heap.find(from, to) == outcome);
        REQUIRE(buckets.find(from, to) == outcome);
        if (outcome != Outcome::found) continue;
        REQUIRE(double(heap.cost()) == Approx(double(truth.cost())).epsilon(1e-12));
        REQUIRE(double(buckets.cost()) == Approx(double(truth.cost())).epsilon(1e-12));
        REQUIRE(cost_along(map, buckets.path()) == Approx(cost_along(map, heap.path())).epsilon(1e-9));
        by_heap += heap.expanded(), by_buckets += buckets.expanded();
    }
    CHECK(by_buckets < by_heap);
}
