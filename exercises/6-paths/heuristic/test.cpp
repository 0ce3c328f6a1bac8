// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the heuristic of a grid (notes 6.3).

#include "tools/exercises/expect.hpp"

#include <cstdint>
#include <limits>
#include <queue>

using namespace ansatz::workbook;

namespace {

constexpr int side = 21, middle = side / 2;
using Map = std::vector<bool>; // row by row: whether there is a wall

/// True costs from every tile to the one in the middle, found step by step and without any formula: each tile's cost is
/// lowered as long as a step to a neighbour lowers it.
std::vector<double> true_costs(const Map& wall, int neighbours) {
    std::vector<double> cost(std::size_t(side * side), std::numeric_limits<double>::infinity());
    cost[std::size_t(middle * side + middle)] = 0;
    for (bool lowered = true; lowered;) {
        lowered = false;
        for (int at = 0; at < side * side; ++at) {
            if (wall[std::size_t(at)]) continue;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int x = at % side + dx, y = at / side + dy;
                    if ((dx == 0 && dy == 0) || (neighbours == 4 && dx != 0 && dy != 0)) continue;
                    if (x < 0 || y < 0 || x >= side || y >= side || wall[std::size_t(y * side + x)]) continue;
                    const double step = dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0;
                    const double by = cost[std::size_t(y * side + x)] + step;
                    if (by < cost[std::size_t(at)] - 1e-12) cost[std::size_t(at)] = by, lowered = true;
                }
        }
    }
    return cost;
}
std::string said(int dx, int dy) { return "dx = " + std::to_string(dx) + ", dy = " + std::to_string(dy); }

/// Every place right of the goal and below it.
template <class Check> void right_and_below(Check&& check) {
    for (int dy = 0; dy <= middle; ++dy)
        for (int dx = 0; dx <= middle; ++dx) check(dx, dy);
}
template <class Yours> void expect_exact(int neighbours, Yours&& yours, const std::string& why) {
    const auto cost = true_costs(Map(std::size_t(side * side)), neighbours);
    right_and_below([&](int dx, int dy) {
        expect_near("without walls, " + said(dx, dy), yours(dx, dy),
                    cost[std::size_t((middle + dy) * side + middle + dx)], 1e-9, why);
    });
}
template <class Yours> void expect_every_side(Yours&& yours) {
    right_and_below([&](int dx, int dy) {
        for (const auto& [x, y] : {std::pair{-dx, dy}, {dx, -dy}, {-dx, -dy}})
            expect_agree("to the one side and to the other", "yours, " + said(dx, dy), yours(dx, dy),
                         "yours, " + said(x, y), yours(x, y), 1e-9,
                         "A way to the left is as long as the same way to the right.");
    });
}

} // namespace

TEST_CASE("four neighbours: exact where there are no walls", "[task-1][exact-four]") {
    expect_exact(4, exercise::four_neighbours,
                 "Without diagonal steps every column and every row is a step of its own.");
}

TEST_CASE("four neighbours: the same to every side", "[task-1][sides-four]") {
    expect_every_side(exercise::four_neighbours);
}

TEST_CASE("eight neighbours: exact where there are no walls", "[task-2][exact-eight]") {
    expect_exact(8, exercise::eight_neighbours,
                 "Go diagonally until you are in the goal's row or column, and straight on from there.");
}

TEST_CASE("eight neighbours: the same to every side", "[task-2][sides-eight]") {
    expect_every_side(exercise::eight_neighbours);
}

TEST_CASE("eight neighbours: never more than the true cost, whatever the walls", "[task-2][never-more]") {
    std::uint32_t random = 1;
    for (int map = 0; map < 10; ++map) {
        Map wall(std::size_t(side * side));
        for (std::size_t i = 0; i < wall.size(); ++i) {
            random = random * 1664525u + 1013904223u;
            wall[i] = i != std::size_t(middle * side + middle) && random >> 24 < 64;
        }
        const auto cost = true_costs(wall, 8);
        right_and_below([&](int dx, int dy) {
            const double truth = cost[std::size_t((middle + dy) * side + middle + dx)];
            const double yours = exercise::eight_neighbours(dx, dy);
            std::ostringstream text;
            text << "among walls, " << said(dx, dy) << "\n    yours      " << yours << "\n    true cost  " << truth
                 << "\nAn overestimate may lead A* to a worse path. A diagonal step does for two, and costs less than "
                    "two.";
            expect(yours <= truth + 1e-9, text.str());
        });
    }
}

TEST_CASE("eight neighbours: no less than the straight distance", "[task-2][not-less]") {
    right_and_below([](int dx, int dy) {
        const double yours = exercise::eight_neighbours(dx, dy), straight = std::hypot(dx, dy);
        std::ostringstream text;
        text << said(dx, dy) << "\n    yours              " << yours << "\n    straight distance  " << straight
             << "\nNobody is faster than along the straight line: an estimate below it expands more of the map than "
                "it needs.";
        expect(yours >= straight - 1e-9, text.str());
    });
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (int dy = -3; dy <= 5; ++dy)
        for (int dx = -5; dx <= 7; ++dx)
            numbers.push_back(task == 1 ? exercise::four_neighbours(dx, dy) : exercise::eight_neighbours(dx, dy));
    return numbers;
}
