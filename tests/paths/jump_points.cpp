// SPDX-License-Identifier: BSL-1.0
// Jump points: the costs of EveryEdge, on every map and by every corner rule, and fewer nodes.
// Runs long with the sanitizers.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/heuristics/grid_metrics.hpp>
#include <ansatz/paths/heuristics/landmarks.hpp>
#include <ansatz/paths/heuristics/zero.hpp>
#include <ansatz/paths/moving_ai.hpp>
#include <ansatz/paths/successors.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

using namespace paths_tests;

namespace {

/// Each step is one that the map allows.
template <class Map> bool walks(const Map& map, std::span<const Cell> path) {
    for (std::size_t i = 1; i < path.size(); ++i)
        if (!map.passable(path[i - 1], path[i])) return false;
    return true;
}

/// How many tiles there are whose f is no more than a cost.
template <class Map> std::size_t not_worse(const Map& map, Cell from, Cell to, std::uint32_t cost) {
    const auto g = true_costs<std::uint32_t>(map, from, Toward::from_it);
    const auto h = Octile{}.bind<std::uint32_t>(map, to);
    std::size_t count = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
        const Cell c{std::uint16_t(i % map.width()), std::uint16_t(i / map.width())};
        count += g[i] <= cost && g[i] + h(c) <= cost;
    }
    return count;
}

/// The same query by every edge and by jump points.
template <class Every, class Jumping, class Map>
void require_the_same(Every& every, Jumping& jumping, const Map& map, Cell from, Cell to) {
    const auto outcome = every.find(from, to);
    INFO(name_of(from) << " to " << name_of(to) << " on " << map.size_in_words());
    REQUIRE(jumping.find(from, to) == outcome);
    if (outcome != Outcome::found) return;
    REQUIRE(jumping.cost() == every.cost());
    REQUIRE(jumping.path().front() == from);
    REQUIRE(jumping.path().back() == to);
    REQUIRE(walks(map, jumping.path()));
    REQUIRE(map.tiles(jumping.path()) == Approx(map.tiles(every.path())).epsilon(1e-12));
    // Near the goal a node is opened for each tile, and which of those with the f of the best path come first is
    // another order: there it is held against all of them.
    if (ansatz::paths::detail::Surroundings::around(map, from, to).least < 0)
        REQUIRE(jumping.expanded() <= every.expanded());
    else REQUIRE(jumping.expanded() <= not_worse(map, from, to, every.cost()));
}

} // namespace

TEMPLATE_TEST_CASE("Jump points cost what every edge does, on random maps", "[paths]", BothFree, OneFree, NoneFree) {
    std::mt19937 random(61);
    using Map = Grid<Eight<TestType>>;
    for (int n = 0; n < 1500; ++n) {
        const std::size_t width = 1 + random() % 24, height = 1 + random() % 24;
        const auto map = random_map<Map>(random, width, height, 0.05 * double(random() % 10));
        AStar every{map, ZeroHeuristic{}};
        AStar jumping{map, Octile{}, JumpPoints{}};
        for (int k = 0; k < 4; ++k)
            require_the_same(every, jumping, map, random_cell(random, width, height),
                             random_cell(random, width, height));
    }
}

TEST_CASE("Jump points in other numbers, with another queue, and other heuristics", "[paths]") {
    std::mt19937 random(62);
    for (int n = 0; n < 200; ++n) {
        const auto map = random_map(random, 40, 30, 0.25);
        AStar every{map, Octile{}};
        AStar buckets{map, JumpPoints{}, Buckets{}};
        AStar blind{map, ZeroHeuristic{}, JumpPoints{}};
        AStar in_double{map, JumpPoints{}, CostIn<double>{}};
        AStar in_64{map, JumpPoints{}, CostIn<std::uint64_t>{}};
        const Cell from = random_cell(random, 40, 30), to = random_cell(random, 40, 30);
        const auto outcome = every.find(from, to);
        REQUIRE(buckets.find(from, to) == outcome);
        REQUIRE(blind.find(from, to) == outcome);
        REQUIRE(in_double.find(from, to) == outcome);
        REQUIRE(in_64.find(from, to) == outcome);
        if (outcome != Outcome::found) continue;
        const double tiles = map.tiles(every.path());
        REQUIRE(buckets.cost() == every.cost());
        REQUIRE(blind.cost() == every.cost());
        REQUIRE(in_64.cost() == every.cost());
        REQUIRE(in_double.cost() == Approx(tiles).epsilon(1e-12));
        REQUIRE(map.tiles(in_double.path()) == Approx(tiles).epsilon(1e-12));
    }
}

TEST_CASE("In an empty room the corner is one jump away", "[paths]") {
    Grid map(1000, 1000);
    AStar jumping{map, JumpPoints{}};
    REQUIRE(jumping.find({0, 0}, {999, 999}) == Outcome::found);
    CHECK(jumping.expanded() == 1);
    CHECK(jumping.path().size() == 1000);
    // One turn: along the diagonal to the row of the goal, then along the row.
    REQUIRE(jumping.find({0, 0}, {999, 500}) == Outcome::found);
    CHECK(jumping.expanded() == 2);
    CHECK(jumping.path()[500] == Cell{500, 500});
    CHECK(map.tiles(jumping.path()) == Approx(499 + 500 * std::sqrt(2.0)).epsilon(1e-14));
}

TEST_CASE("At the end of a wall a way turns only where the corner rule makes it", "[paths]") {
    const auto both = grid_from<Grid<Eight<BothFree>>>({".....", "##...", "....."});
    AStar round{both, JumpPoints{}};
    REQUIRE(round.find({0, 0}, {0, 2}) == Outcome::found);
    CHECK(both.tiles(round.path()) == Approx(2 + 2 + 2)); // no corner is cut
    const auto none = grid_from<Grid<Eight<NoneFree>>>({".....", "##...", "....."});
    AStar close{none, JumpPoints{}};
    REQUIRE(close.find({0, 0}, {0, 2}) == Outcome::found);
    CHECK(none.tiles(close.path()) == Approx(2 + 2 * std::sqrt(2.0)));
}

TEST_CASE("A search by jump points can be left, given up, and repeated after a change", "[paths]") {
    std::mt19937 random(63);
    auto map = random_map(random, 120, 90, 0.2);
    map.set_passable({0, 0}, true);
    map.set_passable({119, 89}, true);
    AStar every{map};
    AStar jumping{map, JumpPoints{}}, sliced{map, JumpPoints{}};
    REQUIRE(jumping.find({0, 0}, {119, 89}) == every.find({0, 0}, {119, 89}));
    sliced.begin({0, 0}, {119, 89});
    while (sliced.advance(3) == Outcome::running) {
    }
    CHECK(sliced.outcome() == jumping.outcome());
    CHECK(std::vector(sliced.path().begin(), sliced.path().end()) ==
          std::vector(jumping.path().begin(), jumping.path().end()));

    REQUIRE(jumping.find({0, 0}, {119, 89}, 5) == Outcome::gave_up);
    CHECK(jumping.expanded() == 5);
    CHECK(walks(map, jumping.path()));
    for (int n = 0; n < 50; ++n) {
        map.set_passable(random_cell(random, 120, 90), n % 2 == 0);
        require_the_same(every, jumping, map, random_cell(random, 120, 90), random_cell(random, 120, 90));
    }
}

TEST_CASE("Jump points refuse a map with blocked edges, and take it when they are free again", "[paths]") {
    Grid map(8, 6);
    AStar jumping{map, JumpPoints{}};
    map.set_wall({3, 3}, {4, 3}, true);
    CHECK(map.blocked_edges() == 2);
    CHECK(ansatz::test::refusal([&] {
              jumping.find({0, 0}, {7, 5});
          }) ==
          "AStar: the number of blocked edges is 2; JumpPoints see blocked tiles only, so that it must be 0; leave "
          "JumpPoints out");
    map.set_wall({3, 3}, {4, 3}, false);
    CHECK(jumping.find({0, 0}, {7, 5}) == Outcome::found);
}

TEMPLATE_TEST_CASE("A near goal on a large map: the costs of every edge, also where the way leaves its surroundings",
                   "[paths]", BothFree, OneFree, NoneFree) {
    std::mt19937 random(64);
    using Map = Grid<Eight<TestType>>;
    for (int n = 0; n < 40; ++n) {
        const std::size_t width = n % 2 == 0 ? 200 : 40, height = n % 2 == 0 ? 150 : 300;
        auto map = random_map<Map>(random, width, height, n % 4 < 2 ? 0.002 : 0.1);
        for (int wall = 0; wall < 12; ++wall) { // long ones, round which the way is far
            const Cell from = random_cell(random, width, height);
            for (std::size_t k = 0; k < 60; ++k) {
                const std::size_t x = from.x + (wall % 2 == 0 ? k : 0), y = from.y + (wall % 2 == 0 ? 0 : k);
                if (x < width && y < height) map.set_passable(Cell{std::uint16_t(x), std::uint16_t(y)}, false);
            }
        }
        AStar every{map};
        AStar jumping{map, JumpPoints{}};
        AStar by_buckets{map, JumpPoints{}, Buckets{}};
        for (int k = 0; k < 30; ++k) {
            const Cell from = random_cell(random, width, height);
            const auto near = [&](std::uint16_t at, std::size_t side) {
                const int reach = k % 3 == 0 ? 3 : 20;
                return std::uint16_t(
                    std::clamp(int(at) + int(random() % unsigned(2 * reach + 1)) - reach, 0, int(side) - 1));
            };
            const std::uint16_t x = near(from.x, width), y = near(from.y, height);
            const auto outcome = every.find(from, Cell{x, y});
            REQUIRE(jumping.find(from, Cell{x, y}) == outcome);
            REQUIRE(by_buckets.find(from, Cell{x, y}) == outcome);
            if (outcome != Outcome::found) continue;
            REQUIRE(jumping.cost() == every.cost());
            REQUIRE(by_buckets.cost() == every.cost());
            REQUIRE(walks(map, jumping.path()));
            REQUIRE(map.tiles(jumping.path()) == Approx(map.tiles(every.path())).epsilon(1e-12));
        }
    }
}

TEST_CASE("Surroundings are squares around the goal, each twice as wide as the one before", "[paths]") {
    using ansatz::paths::detail::Surroundings;
    const Grid<> large(1000, 10), small(24, 24);
    const Cell goal{500, 5};
    CHECK(Surroundings::around(small, {3, 3}, {12, 5}).steps({3, 3}, 0) == Surroundings::without_end);
    CHECK(Surroundings::around(large, {100, 5}, goal).steps({100, 5}, 0) == Surroundings::without_end); // it is far
    const auto near = Surroundings::around(large, {489, 5}, goal); // 11 tiles: the smallest reaches to 16
    CHECK(near.holds({489, 5}));
    CHECK(near.holds({485, 0}));
    CHECK_FALSE(near.holds({484, 5}));
    CHECK(Surroundings::around(large, {516, 5}, goal).holds({516, 5})); // whoever begins is in it, by all powers of 2
    for (unsigned d = 0; d < 8; ++d)
        for (int x = 300; x < 700; ++x) {
            const int dx = ansatz::paths::detail::direction_x[d];
            const Cell at{std::uint16_t(x), 5};
            const auto steps = near.steps(at, d);
            if (dx == 0) {
                CHECK(steps == 16); // from the goal's row
                continue;
            }
            const int outwards = dx * (x - 500);
            int border = 16; // said anew: the first square that is farther out
            while (border <= outwards) border *= 2;
            const auto across = std::size_t(border - outwards);
            CHECK(steps == (d < 4 ? across : std::min<std::size_t>(across, 16)));
        }
}

TEST_CASE("A near goal costs the same nodes on any larger map, and any of several by jumps what it does by edges",
          "[paths]") {
    std::size_t nodes = 0;
    for (const std::size_t side : {200, 1000, 3000}) {
        const Grid map(side, side);
        AStar jumping{map, JumpPoints{}};
        const auto middle = std::uint16_t(side / 2);
        REQUIRE(jumping.find({middle, middle}, {std::uint16_t(middle + 12), std::uint16_t(middle - 7)}) ==
                Outcome::found);
        if (nodes == 0) nodes = jumping.expanded();
        CHECK(jumping.expanded() == nodes);
        CHECK(jumping.expanded() <= 12);
    }
    std::mt19937 random(65);
    for (int n = 0; n < 20; ++n) {
        const auto map = random_map(random, 90, 90, 0.2);
        const std::vector<Cell> goals{random_cell(random, 90, 90), random_cell(random, 90, 90),
                                      random_cell(random, 90, 90)};
        const Cell from = random_cell(random, 90, 90);
        AStar every{map, AnyGoal{}};
        AStar jumping{map, AnyGoal{}, JumpPoints{}};
        const auto outcome = every.find(from, goals);
        REQUIRE(jumping.find(from, goals) == outcome);
        if (outcome == Outcome::found) REQUIRE(jumping.cost() == every.cost());
    }
}
