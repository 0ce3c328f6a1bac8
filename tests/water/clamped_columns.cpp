// SPDX-License-Identifier: BSL-1.0
// Columns between two limits: never beyond, volume kept or counted, and no drift afterwards.

#include <ansatz/collision.hpp>
#include <ansatz/water.hpp>
#include <ansatz/water/clamped_columns.hpp>
#include <ansatz/world.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
template <class Scalar> Surface<ClampedColumns, Scalar> rough(Excess excess) {
    Surface<ClampedColumns, Scalar> water({{3.0 * mps}, {.low = 1.8 * metre, .high = 2.1 * metre, .excess = excess}},
                                          unequal(9, 7), 2.0 * metre);
    set_heights(water, [](double x, double z) { return 2 + 0.9 * std::exp(-(x - 4) * (x - 4) - (z - 3) * (z - 3)); });
    return water;
}
} // namespace

TEMPLATE_TEST_CASE("spread, what is cut off stays in the basin (hard case W3)", "[water]", float, double) {
    auto water = rough<TestType>(Excess::spread);
    const double before = water.volume().value(), bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
    for (int n = 0; n < 3000; ++n) {
        water.step(0.05 * second);
        for (const TestType h : water.heights()) {
            REQUIRE(h >= TestType(1.8));
            REQUIRE(h <= TestType(2.1));
        }
    }
    CHECK(std::abs(water.volume().value() / before - 1) <= bound);
    CHECK(std::abs(double(water.state().cut_off)) <= 1e-6);
}

TEST_CASE("counted, what is cut off is told to the last drop", "[water]") {
    auto water = rough<double>(Excess::counted);
    const double before = water.volume().value();
    for (int n = 0; n < 3000; ++n) water.step(0.05 * second);
    CHECK(std::abs(water.state().cut_off) > 0.01);
    CHECK(water.volume().value() + water.state().cut_off == Approx(before).epsilon(1e-12));
}

TEST_CASE("a column that reaches a limit stops there, and the others take over its rate", "[water]") {
    const ColumnGrid grid(3, 1, 1.0 * metre, 1.0 * metre);
    std::vector<double> height{2.5, 1.0, 1.0}, rate{3.0, 0.5, -0.5};
    const Clamp clamp{.low = 0.0 * metre, .high = 2.0 * metre};
    CHECK(clamp_columns(clamp, grid, std::span(height), std::span(rate)) == 0.0 * cubic_metre);
    CHECK(height == std::vector<double>{2.0, 1.25, 1.25});
    CHECK(rate == std::vector<double>{0.0, 2.0, 1.0});
    // One that comes back by itself is not stopped.
    height = {2.5, 1.0, 1.0};
    rate = {-1.0, 0.0, 0.0};
    clamp_columns(clamp, grid, std::span(height), std::span(rate));
    CHECK(rate == std::vector<double>{-1.0, 0.0, 0.0});
    // A column with less room than its share leaves the rest to the others.
    height = {3.0, 1.75, 0.0};
    CHECK(clamp_columns(clamp, grid, std::span(height), std::span(rate)) == 0.0 * cubic_metre);
    CHECK(height == std::vector<double>{2.0, 2.0, 0.75});
    // Where no column has room, that is reported.
    height = {3.0, 2.0, 2.0};
    CHECK(clamp_columns(clamp, grid, std::span(height), std::span(rate)) == 1.0 * cubic_metre);
    CHECK(height == std::vector<double>{2.0, 2.0, 2.0});
    // Below, it is filled from the others.
    height = {-0.5, 0.25, 1.0};
    CHECK(clamp_columns(clamp, grid, std::span(height), std::span(rate)) == 0.0 * cubic_metre);
    CHECK(height == std::vector<double>{0.0, 0.0, 0.75});
}

TEST_CASE("within its limits a clamp changes no bit", "[water]") {
    const ColumnGrid grid = unequal(6, 5);
    const WaterColumns columns{2.0 * mps, 0.1 / second};
    Surface plain(columns, grid, 2.0 * metre);
    Surface clamped(ClampedColumns{columns, {0.5 * metre, 3.5 * metre}}, grid, 2.0 * metre);
    for (auto* water : {&plain}) set_heights(*water, [](double x, double) { return 2 + 0.3 * std::sin(x); });
    set_heights(clamped, [](double x, double) { return 2 + 0.3 * std::sin(x); });
    for (int n = 0; n < 500; ++n) {
        plain.step(0.1 * second);
        clamped.step(0.1 * second);
    }
    CHECK(clamped.state().height == plain.state().height);
    CHECK(clamped.state().rate == plain.state().rate);
}

TEST_CASE("a range without room is refused", "[water]") {
    const ColumnGrid grid(3, 3, 1.0 * metre);
    CHECK(refusal([&] {
              Surface(ClampedColumns{{mps}, {2.0 * metre, 2.0 * metre}}, grid, 2.0 * metre);
          }) == "ClampedColumns: high is 2 m; it must be above low, which is 2 m");
    CHECK(refusal([&] {
              Surface(ClampedColumns{{mps}, {-1.0 * metre, 2.0 * metre}}, grid, 2.0 * metre);
          }) == "ClampedColumns: low is -1 m; it must be finite and not negative");
}

TEST_CASE("water that is to be spread begins within its range; what is counted may begin anywhere", "[water]") {
    const auto begin = [](double level, Excess excess) {
        return Surface(ClampedColumns{{mps}, {0.5 * metre, 1.0 * metre, excess}}, ColumnGrid(3, 3, 1.0 * metre),
                       level * metre);
    };
    CHECK(refusal([&] { begin(2, Excess::spread); }) ==
          "ClampedColumns: the level is 2 m; it must be from low, 0.5 m, to high, 1 m: no column would have room for "
          "the rest");
    CHECK(refusal([&] { begin(0.25, Excess::spread); }).find("the level is 0.25 m") != std::string::npos);
    for (const double level : {0.5, 1.0}) CHECK(begin(level, Excess::spread).volume() == 9 * level * cubic_metre);
    auto water = begin(2, Excess::counted);
    water.step(0.01 * second);
    CHECK(water.state().cut_off == Approx(9));
}

TEST_CASE("a body that is dipped into a full pool and taken out leaves the pool as full as it was", "[water]") {
    // Full to the brim, nearly so, and far from the floor but near to a low ceiling.
    for (const auto& [level, high] : {std::pair(0.95, 1.0), std::pair(1.0, 1.0), std::pair(0.5, 0.55)}) {
        World world{SemiImplicitEuler{}, Gravity{}, Pools<ClampedColumns>{}, Buoyancy{}};
        const ClampedColumns policy{{0.5 * metre_per_second}, {0.0 * metre, high * metre}};
        const auto pool = world.add(Pool{Surface{policy, ColumnGrid(5, 5, 1.0 * metre), level * metre}});
        const auto ball = world.add(position(metres(2.5, level, 2.5)), fixed);
        const double full = 25 * level, close = 1e-12;
        const auto water = [&] { return world.get(pool).surface.volume().value(); };
        const auto owed = [&] { return double(world.get(pool).surface.state().cut_off); };
        INFO("level " << level << " m, up to " << high << " m");
        for (int time = 0; time < 3; ++time) {
            const auto floats = world.add(Floating{ball, Sphere{1.0 * metre}});
            for (int i = 0; i < 50; ++i) {
                world.step(0.02 * second);
                REQUIRE(std::abs(water() + owed() - full) <= close * full);
            }
            CHECK(owed() > 0.5); // the ball holds 2.1 m^3 below the level, and there is no room for them
            world.remove(floats);
            for (int i = 0; i < 50; ++i) world.step(0.02 * second);
            CHECK(std::abs(owed()) <= close);
            CHECK(std::abs(water() - full) <= close * full);
        }
    }
}
