// SPDX-License-Identifier: BSL-1.0
// Where a disc has room on a map of tiles.

#include <ansatz/paths/walking/clearance.hpp>

#include "tests/paths/support.hpp"
#include "tests/paths/walking/clearance_of.hpp"

#include <random>

using namespace paths_tests;
using namespace ansatz::test;

TEST_CASE("where a disc has room is where the clearance is its radius", "[walking]") {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> at(0, 12);
    int fits = 0, not_fits = 0;
    for (int i = 0; i < 25; ++i) {
        const auto map = random_map(random, 12, 12, 0.15);
        for (int k = 0; k < 200; ++k) {
            const double x = at(random), y = at(random), r = std::uniform_real_distribution<double>(0.05, 2)(random);
            const bool room = disc_fits(map, metres(x, y), r * metre);
            CHECK(room == (clearance(map, x, y) >= r));
            ++(room ? fits : not_fits);
        }
        for (int k = 0; k < 60; ++k) { // and straight ways, against places on them
            const Cell a = random_cell(random, 12, 12), b = random_cell(random, 12, 12);
            const double r = std::uniform_real_distribution<double>(0.05, 1)(random);
            double least = 9;
            for (int q = 0; q <= 500; ++q)
                least = std::min(
                    least, clearance(map, a.x + 0.5 + q / 500.0 * (b.x - a.x), a.y + 0.5 + q / 500.0 * (b.y - a.y)));
            if (std::abs(least - r) > 0.02) CHECK(disc_passes(map, a, b, r * metre) == (least > r));
        }
    }
    CHECK(fits > 1000);
    CHECK(not_fits > 1000);
}

TEST_CASE("the map of a disc is that on which it touches nothing", "[walking]") {
    std::mt19937 random(37);
    for (const double radius : {0.3, 0.5, 0.8, 1.4}) {
        const auto map = random_map<Grid<Eight<OneFree>>>(random, 24, 24, 0.08);
        const auto own = map_for(map, radius * metre);
        for (std::uint16_t y = 0; y < 24; ++y)
            for (std::uint16_t x = 0; x < 24; ++x) {
                const Cell c{x, y};
                const bool room = clearance(map, x + 0.5, y + 0.5) >= radius;
                CHECK(own.passable(c) == (map.passable(c) && room));
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const Cell to{std::uint16_t(x + dx), std::uint16_t(y + dy)};
                        if (!own.passable(c, to)) continue;
                        CHECK(map.passable(c, to));
                        for (int q = 0; q <= 20; ++q)
                            CHECK(clearance(map, x + 0.5 + q / 20.0 * dx, y + 0.5 + q / 20.0 * dy) >= radius - 1e-9);
                    }
            }
    }
    const Grid<> map(3, 3);
    CHECK_THAT(refusal([&] { map_for(map, -1.0 * metre); }), ContainsSubstring("map_for: radius is -1 m"));
    Grid<> wall(5, 3);
    wall.set_passable(Cell{2, 0}, false);
    const std::vector<Cell> along{{0, 1}, {1, 1}, {2, 1}, {3, 1}};
    CHECK(way_points(wall, along, 0.5 * metre).size() == 1);
    CHECK_THAT(refusal([&] { way_points(wall, along, 0.6 * metre); }),
               ContainsSubstring("way_points: the step from (0, 1) to (1, 1) is one on which a disc of this radius"));
}
