// SPDX-License-Identifier: BSL-1.0
// Squares of a grid and their gates: after any change they are what they would be if all were made anew, and no more
// was made than the change concerns.

#include <ansatz/paths/clusters.hpp>

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics/zero.hpp>

#include <algorithm>

using namespace paths_tests;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("after any changes the squares are those of a hierarchy that is built anew", "[hierarchy]", Grid<>,
                   Grid<Four>, (Grid<Eight<NoneFree>, Terrain>)) {
    std::mt19937 random(149);
    std::size_t remade = 0, changes = 0;
    for (int i = 0; i < 25; ++i) {
        const std::size_t w = 5 + random() % 40, h = 5 + random() % 40, side = 4 + random() % 10;
        auto map = random_map<TestType>(random, w, h, 0.3);
        Clusters squares{map, side};
        CHECK(squares.update() == 0);
        for (int k = 0; k < 40; ++k) {
            for (auto n = 1 + random() % 3; n > 0; --n, ++changes) {
                const Cell at = random_cell(random, w, h), to = random_cell(random, w, h);
                if constexpr (!std::is_same_v<typename TestType::ground, Even>) {
                    if (random() % 3 == 0) {
                        map.set_weight(at, 1 + double(random() % 4));
                        continue;
                    }
                }
                const Cell beside{std::uint16_t(at.x + 1), at.y};
                if (random() % 4 == 0 && map.contains(beside)) map.set_passable(at, beside, random() % 2 == 0);
                else map.set_passable(to, random() % 2 == 0);
            }
            remade += squares.update();
            REQUIRE(squares.is_current());
            REQUIRE(squares == Clusters{map, side});
        }
    }
    CHECK(remade > 200);
    CHECK(changes > 1500);
}

TEST_CASE("a tile inside of a square concerns that square alone, and one at its border those that touch it",
          "[hierarchy]") {
    Grid<> map(160, 160);
    Clusters squares{map, 16};
    CHECK(squares.squares() == 100);
    map.set_passable(Cell{40, 40}, false);
    CHECK(squares.update() == 1);
    CHECK(squares.update() == 0);
    map.set_passable(Cell{31, 40}, false); // the last column of a square
    const auto two = squares.update();
    CHECK(two >= 1);
    CHECK(two <= 2);
    map.set_passable(Cell{31, 31}, false); // a corner of four
    const auto four = squares.update();
    CHECK(four >= 3);
    CHECK(four <= 4);
    CHECK(squares == Clusters{map, 16});
    map.set_passable(Cell{40, 40}, false); // as it is
    CHECK(squares.update() == 0);
}

TEST_CASE("the ways inside of a square are the cheapest ones there", "[hierarchy]") {
    std::mt19937 random(151);
    int compared = 0;
    for (int i = 0; i < 15; ++i) {
        const auto map = random_map(random, 30, 21, 0.3);
        const Clusters squares{map, 10};
        for (std::size_t s = 0; s < squares.squares(); ++s)
            for (const Cell gate : squares.gates_of(s)) {
                // The square as a map of its own; what lies outside is cut off.
                auto alone = map;
                for (std::uint16_t y = 0; y < 21; ++y)
                    for (std::uint16_t x = 0; x < 30; ++x)
                        if (squares.square_of({x, y}) != s && std::abs(x - gate.x) < 12 && std::abs(y - gate.y) < 12)
                            for (int d = 0; d < 8; ++d) { // blocked edges, since walls would change corners
                                const int u = x + ansatz::paths::detail::direction_x[d],
                                          v = y + ansatz::paths::detail::direction_y[d];
                                const Cell to{std::uint16_t(u), std::uint16_t(v)};
                                if (u >= 0 && v >= 0 && alone.contains(to) && squares.square_of(to) == s)
                                    alone.set_passable({x, y}, to, false);
                            }
                AStar search{alone, ZeroHeuristic{}};
                const Cell from = random_cell(random, 30, 21);
                if (squares.square_of(from) != s || !map.passable(from)) continue;
                const bool found = search.find(from, gate) == Outcome::found;
                CHECK(squares.cost_to(gate, from) == (found ? search.cost() : Clusters<Grid<>>::no_way));
                ++compared;
            }
    }
    CHECK(compared > 40);
    const Grid<> small(5, 5);
    CHECK_THAT(refusal([&] {
                   Clusters{small, 2};
               }),
               ContainsSubstring("Clusters: side is 2; it must be from 4 to 64 tiles"));
    CHECK(Clusters{small}.gates() == 0);
    CHECK(Clusters{small}.edges() == 0);
}
