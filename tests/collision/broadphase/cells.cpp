// SPDX-License-Identifier: BSL-1.0
// The cells of a grid: rounding down, and how wide they must be for a box.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/broadphase/cells.hpp>

#include <array>
#include <cmath>
#include <limits>

using namespace collision_tests;

TEST_CASE("a coordinate is rounded down to its cell, below zero, too", "[collision][broadphase]") {
    ansatz::test::Dice dice(1);
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0.5, -0.5, -1e-300, 1099511627776.0, -1099511627776.5})
        CHECK(double(detail::floor_of(x)) == std::floor(x));
    for (int i = 0; i < 10000; ++i) {
        const double x = dice.number(-1, 1) * std::pow(10.0, dice.number(-5, 12));
        REQUIRE(double(detail::floor_of(x)) == std::floor(x));
    }
}

TEST_CASE("a box reaches into the next cell at most, wherever it is", "[collision][broadphase]") {
    ansatz::test::Dice dice(2);
    const auto needed = [](const auto& low, const auto& high) {
        return detail::cell_needed(
            2, [&](int k) { return low[std::size_t(k)]; }, [&](int k) { return high[std::size_t(k)]; });
    };
    for (int i = 0; i < 10000; ++i) {
        std::array<double, 2> low{}, high{};
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = dice.number(-1, 1) * std::pow(10.0, dice.number(-5, 14));
            high[k] = low[k] + std::pow(10.0, dice.number(-5, 5));
        }
        const double cell = needed(low, high);
        for (std::size_t k = 0; k < 2; ++k)
            REQUIRE(detail::floor_of(high[k] / cell) - detail::floor_of(low[k] / cell) <= 1);
        const std::array<double, 2> bad{low[0], i % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity()};
        REQUIRE(std::isnan(needed(low, bad)));
    }
}
