// SPDX-License-Identifier: BSL-1.0
// The ring of columns around a body: its shares sum to one wherever the body is, and change without a step.

#include <ansatz/water/ring.hpp>

#include "tests/water/support.hpp"

#include <map>

using namespace water_tests;

namespace {

constexpr auto wet = [](std::size_t) { return 1.0; };
Footprint disc(double x, double z, double r) { return {x, z, r, r, true, pi * r * r}; }
Footprint crate(double x, double z, double a, double b) { return {x, z, a, b, false, 4 * a * b}; }

template <class Wet> std::map<std::size_t, double> shares(const ColumnGrid& grid, const Footprint& foot, const Wet& w) {
    std::map<std::size_t, double> all;
    WaterRing(grid, foot, w).each([&](std::size_t n, double share) { all[n] += share; });
    return all;
}
template <class Map> double sum(const Map& all) {
    double total = 0;
    for (const auto& [n, share] : all) total += share;
    return total;
}
double feedback(const ColumnGrid& grid, const std::map<std::size_t, double>& all) {
    double total = 0;
    for (const auto& [n, share] : all)
        total += share * share / grid.footprint(n % grid.columns_x(), n / grid.columns_x()).value();
    return total;
}

} // namespace

TEST_CASE("shares sum to one for any body in any grid, and the feedback is theirs", "[water]") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 300; ++k) {
        const auto grid = k % 3 == 0   ? ColumnGrid(31, 27, 0.2 * metre)
                          : k % 3 == 1 ? unequal(11, 9)
                                       : ColumnGrid(40, 1, 0.2 * metre, 1.0 * metre);
        const double x = grid.end_x().value() * unit(random), z = grid.end_z().value() * unit(random);
        const double a = 1.5 * unit(random), b = 1.5 * unit(random);
        const auto foot = k % 2 ? disc(x, z, a) : crate(x, z, a, b);
        const auto all = shares(grid, foot, wet);
        CAPTURE(k, x, z, a, b);
        CHECK(sum(all) == Approx(1).epsilon(1e-12));
        CHECK(WaterRing(grid, foot, wet).feedback() == Approx(feedback(grid, all)).epsilon(1e-12));
        // Where what a body presses up raised its level by more than 1 / section, it would climb on its own water.
        if (grid.area().value() > 2 * foot.section) CHECK(feedback(grid, all) * foot.section < 0.8); // measured 0.70
    }
}
TEST_CASE("no column under a body has a share where there is a ring around it", "[water]") {
    const ColumnGrid grid(60, 60, 0.1 * metre);
    for (const auto& foot : {disc(3.03, 2.96, 0.5), crate(3.03, 2.96, 0.7, 0.3), disc(3.0, 3.0, 0.02)})
        for (const auto& [n, share] : shares(grid, foot, wet)) {
            const double x = grid.centre_x(n % 60).value(), z = grid.centre_z(n / 60).value();
            CHECK(foot.distance(x, z, false) > 0);
            CHECK(share > 0);
        }
}
TEST_CASE("the ring is three columns wide around small bodies and as wide as large ones", "[water]") {
    const ColumnGrid grid(100, 100, 0.1 * metre);
    auto widest = [&](const Footprint& foot) {
        double far = 0;
        for (const auto& [n, share] : shares(grid, foot, wet))
            far = std::max(far, foot.distance(grid.centre_x(n % 100).value(), grid.centre_z(n / 100).value(), false));
        return far;
    };
    CHECK(widest(disc(5.05, 5.05, 0.01)) == Approx(0.4).margin(0.1));
    CHECK(widest(disc(5.05, 5.05, 2)) == Approx(2.1).margin(0.1));
    CHECK(widest(crate(5.05, 5.05, 0.2, 0.2)) == Approx(0.4).margin(0.1));
}
TEST_CASE("a body that drifts crosses no step", "[water]") {
    const ColumnGrid grid(60, 60, 0.1 * metre);
    auto level = [&](double x) { // of a surface that is no plane
        double sum = 0;
        WaterRing(grid, disc(x, 3, 0.4), wet).each([&](std::size_t n, double share) {
            sum += share * std::sin(3 * grid.centre_x(n % 60).value());
        });
        return sum;
    };
    for (double x = 1; x < 5; x += 1e-3) REQUIRE(std::abs(level(x + 1e-3) - level(x)) < 4e-3);
    // So too towards a wall, along which the ring is cut and the rest of the pool takes part.
    for (double x = 0; x < 1; x += 1e-3) REQUIRE(std::abs(level(x + 1e-3) - level(x)) < 8e-3);
}
TEST_CASE("a pool that is smaller than the ring is its own ring, and dry columns do not count", "[water]") {
    const ColumnGrid small(3, 3, 0.5 * metre);
    const auto all = shares(small, disc(0.75, 0.75, 0.7), wet);
    CHECK(all.size() == 9);
    CHECK(sum(all) == Approx(1).epsilon(1e-14));
    const ColumnGrid grid(60, 60, 0.1 * metre);
    const auto half = [](std::size_t n) { return n % 60 < 30 ? 1.0 : 0.0; };
    for (const auto& [n, share] : shares(grid, disc(3, 3, 0.5), half)) CHECK(n % 60 < 30);
    CHECK(sum(shares(grid, disc(3, 3, 0.5), half)) == Approx(1).epsilon(1e-13));
    CHECK(WaterRing(grid, disc(3, 3, 0.5), half).room() == Approx(1).margin(0.02));
    CHECK(WaterRing(grid, disc(3, 3, 0.5), wet).room() == 1);
    const auto little = [](std::size_t n) { return n % 60 < 23 ? 1.0 : 0.0; }; // no column within 0.2 m
    const double room = WaterRing(grid, disc(3, 3, 0.5), little).room();
    CHECK(room > 0);
    CHECK(room < 0.5);
    for (const auto& [n, share] : shares(grid, disc(3, 3, 0.5), little)) CHECK(n % 60 < 23);
    const auto dry = [](std::size_t n) { return n % 60 < 5 ? 1.0 : 0.0; }; // water, but none around it
    const WaterRing nothing(grid, disc(3, 3, 0.5), dry);
    CHECK_FALSE(nothing.wet());
    CHECK(nothing.room() == 0);
    CHECK(nothing.feedback() == 0);
}
TEST_CASE("a ring is its own mirror image", "[water]") {
    const ColumnGrid grid(41, 41, 0.1 * metre);
    const auto all = shares(grid, crate(2.05, 2.05, 0.3, 0.2), wet);
    for (const auto& [n, share] : all) {
        const auto mirror = (40 - n % 41) + 41 * (40 - n / 41);
        if (share < 1e-12) continue; // where the edge ends, but for rounding
        REQUIRE(all.count(mirror) == 1);
        CHECK(all.at(mirror) == Approx(share).epsilon(1e-10));
    }
}
