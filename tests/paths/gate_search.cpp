// SPDX-License-Identifier: BSL-1.0
// Paths by way of gates: there is one where A* has one, on every kind of grid; how much longer they are, and how much
// less was expanded, on the maps of games; and changes of the map.
// Runs long with the sanitizers.

#include <ansatz/paths/gate_search.hpp>

#include <ansatz/paths/moving_ai.hpp>

#include "tests/paths/support.hpp"

#include <algorithm>
#include <cstdlib>

using namespace paths_tests;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("there is a path by way of gates where there is one on the tiles, and no other", "[hierarchy]",
                   Grid<>, Grid<Four>, (Grid<Eight<OneFree>>), (Grid<Eight<NoneFree>, Terrain>)) {
    std::mt19937 random(157);
    int found = 0, none = 0, by_gates = 0;
    double longer = 0;
    for (int i = 0; i < 60; ++i) {
        const std::size_t w = 20 + random() % 60, h = 20 + random() % 60;
        auto map = random_map<TestType>(random, w, h, 0.2 + 0.05 * double(i % 5));
        if (i % 3 == 0)
            for (int k = 0; k < 200; ++k) { // drops that nobody climbs
                const Cell at = random_cell(random, w, h), to{std::uint16_t(at.x + 1), at.y};
                if (map.contains(to)) map.set_passable(at, to, false);
            }
        if constexpr (!std::is_same_v<typename TestType::ground, Even>)
            for (int k = 0; k < 500; ++k) map.set_weight(random_cell(random, w, h), 1 + double(random() % 5));
        GateSearch search{map, 4 + random() % 6};
        AStar tiles{map};
        for (int k = 0; k < 30; ++k) {
            const Cell start = random_cell(random, w, h), goal = random_cell(random, w, h);
            search.improves = k % 2 == 0;
            const auto outcome = search.find(start, goal);
            const auto right = tiles.find(start, goal);
            INFO("map " << i << ", query " << k << ", " << name_of(start) << " to " << name_of(goal));
            REQUIRE(outcome == right);
            if (right != Outcome::found) {
                CHECK(search.path().empty());
                ++none;
                continue;
            }
            REQUIRE(search.path().front() == start);
            REQUIRE(search.path().back() == goal);
            const double cost = cost_along(map, search.path());
            const double best = cost_along(map, tiles.path());
            REQUIRE(cost < std::numeric_limits<double>::infinity());
            CHECK(cost >= best * (1 - 1e-9));
            CHECK(search.cost() == cost);
            by_gates += cost > best * (1 + 1e-9);
            if (best > 0) longer = std::max(longer, cost / best);
            ++found;
        }
    }
    CHECK(found > 500);
    CHECK(none > 100);
    CHECK(by_gates > 50);
}

namespace {
/// How much longer paths are at worst, and of the longest tenth how much less is expanded than by A*.
void on_the_map(const std::string& name, double most, double least_saved) {
    const std::string folder = data_folder();
    if (folder.empty())
        SKIP("no data: there is no folder shared/data beside the project, and ANSATZ_TEST_DATA names none");
    const auto map = read_moving_ai_map(folder + "/movingai/" + name + ".map");
    auto scenarios = read_moving_ai_scenarios(folder + "/movingai/" + name + ".map.scen");
    std::sort(scenarios.begin(), scenarios.end(), [](const auto& a, const auto& b) { return a.length < b.length; });
    const auto grid = map.grid();
    GateSearch search{grid};
    AStar tiles{grid};
    const bool all = std::getenv("ANSATZ_ALL_SCENARIOS") != nullptr;
    const std::size_t step = all ? 1 : std::max<std::size_t>(1, scenarios.size() / 120);
    double worst = 0, sum = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < scenarios.size(); k += step) {
        const auto& s = scenarios[k];
        INFO(map.name << ", line " << s.line);
        REQUIRE(search.find(s.start, s.goal) == Outcome::found);
        REQUIRE(search.path().front() == s.start);
        REQUIRE(search.path().back() == s.goal);
        const double length = cost_along(grid, search.path());
        REQUIRE(length >= s.length - s.tolerance);
        if (!(s.length > 0)) continue;
        worst = std::max(worst, length / s.length - 1), sum += length / s.length - 1, ++count;
    }
    CHECK(worst <= most);
    double by_gates = 0, by_tiles = 0;
    const std::size_t tenth = scenarios.size() - scenarios.size() / 10;
    for (std::size_t k = tenth; k < scenarios.size(); k += std::max<std::size_t>(1, scenarios.size() / 100)) {
        search.find(scenarios[k].start, scenarios[k].goal);
        tiles.find(scenarios[k].start, scenarios[k].goal);
        by_gates += double(search.expanded()), by_tiles += double(tiles.expanded());
    }
    CHECK(by_tiles >= least_saved * by_gates);
    if (all)
        WARN(name << ": " << count << " paths, worst " << 100 * worst << " %, mean " << 100 * sum / double(count)
                  << " %, expanded " << by_tiles / by_gates << " times less");
}
} // namespace

// The bound is 5 per cent; and of the longest tenth an eighth is expanded, refinement counted. A small map has no long
// paths, and is searched on its tiles.
TEST_CASE("paths by way of gates on MovingAI's maps: games", "[hierarchy][data]") {
    on_the_map("AR0011SR", 0.05, 8);
    on_the_map("brc202d", 0.05, 8);
    on_the_map("arena", 0.05, 0.5);
}
TEST_CASE("paths by way of gates on MovingAI's maps: rooms, a maze, stones", "[hierarchy][data]") {
    on_the_map("16room_000", 0.05, 8);
    on_the_map("maze512-8-0", 0.05, 8);
    on_the_map("random512-10-0", 0.05, 8);
}

TEST_CASE("a search after a change is that of a hierarchy that is built anew", "[hierarchy]") {
    std::mt19937 random(163);
    auto map = random_map(random, 90, 70, 0.25);
    GateSearch search{map, 8};
    std::size_t remade = 0, most = 0;
    int found = 0;
    for (int i = 0; i < 150; ++i) {
        map.set_passable(random_cell(random, 90, 70), random() % 2 == 0);
        const Cell start = random_cell(random, 90, 70), goal = random_cell(random, 90, 70);
        const auto outcome = search.find(start, goal);
        remade += search.remade(), most = std::max(most, search.remade());
        GateSearch anew{map, 8};
        REQUIRE(anew.find(start, goal) == outcome);
        REQUIRE(std::equal(search.path().begin(), search.path().end(), anew.path().begin(), anew.path().end()));
        CHECK(search.expanded() == anew.expanded());
        found += outcome == Outcome::found;
    }
    CHECK(found > 50);
    CHECK(remade > 30);
    CHECK(most <= 9); // of 108: the square of the tile, and those around it
    while (search.find(random_cell(random, 90, 70), random_cell(random, 90, 70)) != Outcome::found) {
    }
    const std::vector<Cell> before(search.path().begin(), search.path().end());
    CHECK_THAT(refusal([&] {
                   search.find({0, 0}, {90, 3});
               }),
               ContainsSubstring("GateSearch::find: goal is (90, 3); the map has 90 x 70 tiles"));
    CHECK_THAT(refusal([&] { search.find({90, 0}, {0, 3}); }), ContainsSubstring("GateSearch::find: start is (90, 0)"));
    CHECK(search.outcome() == Outcome::found);
    CHECK(std::equal(search.path().begin(), search.path().end(), before.begin(), before.end()));
}

TEST_CASE("where gates lie on ground of 60000 tiles' weight, there is a path by way of them where A* has one",
          "[hierarchy]") {
    std::mt19937 random(31);
    int found = 0, heavy = 0, beyond = 0;
    for (int i = 0; i < 6000; ++i) {
        Grid<Eight<>, Terrain> map(12, std::size_t(1 + random() % 6));
        for (std::uint16_t x = 0; x < map.width(); ++x)
            for (std::uint16_t y = 0; y < map.height(); ++y) {
                if (random() % 3 == 0) map.set_weight(Cell{x, y}, 60000);
                if (random() % 4 == 0) map.set_passable(Cell{x, y}, false);
            }
        const auto row = [&] { return std::uint16_t(random() % map.height()); };
        const Cell start{0, row()}, goal{11, row()};
        AStar best{map};
        GateSearch gates{map, 4};
        const auto outcome = best.find(start, goal);
        INFO("map " << i);
        if (outcome == Outcome::too_far) { // 71,000 tiles and more: gates may add them up, the ways between them not
            AStar wide{map, CostIn<std::uint64_t>{}};
            const bool there = wide.find(start, goal) == Outcome::found;
            REQUIRE((gates.find(start, goal) != Outcome::no_path) == there);
            beyond += there;
            continue;
        }
        REQUIRE(gates.find(start, goal) == outcome);
        if (outcome != Outcome::found) continue;
        REQUIRE(gates.cost() >= map.cost(best.path()) * (1 - 1e-12));
        ++found;
        heavy += map.cost(best.path()) > 20000;
    }
    CHECK(found > 500);
    CHECK(heavy > 200);
    CHECK(beyond > 20);
}

TEST_CASE("a way within a square that costs more than its number holds is too far, and one behind a wall is none",
          "[hierarchy]") {
    for (const bool wall : {false, true}) {
        Grid<Eight<>, Terrain> map(80, 3);
        for (std::uint16_t x = 0; x < 80; ++x)
            for (std::uint16_t y = 0; y < 3; ++y) map.set_weight(Cell{x, y}, x < 20 ? 60000 : 1);
        if (wall)
            for (std::uint16_t y = 0; y < 3; ++y) map.set_passable(Cell{70, y}, false);
        GateSearch gates{map, 16};
        const auto there = wall ? Outcome::no_path : Outcome::too_far;
        CHECK(gates.find({0, 0}, {79, 2}) == there);
        CHECK(gates.find({79, 2}, {0, 0}) == there);
        CHECK(gates.path().empty());
        CHECK(gates.find({21, 0}, {69, 2}) == Outcome::found); // what is elsewhere does not matter
        for (std::uint16_t x = 0; x < 20; ++x)
            for (std::uint16_t y = 0; y < 3; ++y) map.set_weight(Cell{x, y}, 1);
        CHECK(gates.find({0, 0}, {79, 2}) == (wall ? Outcome::no_path : Outcome::found));
    }
}
