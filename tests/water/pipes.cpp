// SPDX-License-Identifier: BSL-1.0
// Pipes: still over any bed, no column below zero, no drop lost, waves at sqrt(g h), and the flow is the water's.

#include <ansatz/water/pipes.hpp>

#include "tests/measured.hpp"
#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
/// The hump of SWASHES: 20 cm high, 4 m wide, in 25 m.
std::vector<double> hump(const ColumnGrid& grid) {
    std::vector<double> bed;
    for (std::size_t j = 0; j < grid.columns_z(); ++j)
        for (std::size_t i = 0; i < grid.columns_x(); ++i) {
            const double x = grid.centre_x(i).value() - 10;
            bed.push_back(std::abs(x) < 2 ? 0.2 - 0.05 * x * x : 0.0);
        }
    return bed;
}
template <class Scalar> std::vector<Scalar> rugged(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(-1, 1);
    std::vector<Scalar> bed;
    for (std::size_t n = 0; n < count; ++n) bed.push_back(Scalar(height(random)));
    return bed;
}
} // namespace

TEMPLATE_TEST_CASE("pipes: still water over a level bed keeps its bits for 1e5 steps (hard case W1)", "[water]", float,
                   double) {
    Surface<Pipes, TestType> water({.damping = 0.1 / second}, unequal(4, 3), 1.7 * metre);
    const auto before = water.state();
    const auto dt = water.longest_step();
    for (int n = 0; n < 100000; ++n) water.step(dt);
    CHECK(water.state() == before);
}

TEST_CASE("pipes: a lake at rest stays at rest, over a hump that is covered and one that emerges (hard case W2)",
          "[water]") {
    const ColumnGrid grid(100, 1, 0.25 * metre, 1.0 * metre);
    for (const double level : {0.5, 0.1}) {
        const auto bed = hump(grid);
        Surface water(Pipes{}, grid, std::span<const double>(bed), level * metre);
        const auto dt = 0.9 * water.longest_step();
        double most = 0;
        for (double t = 0; t < 10; t += dt.value()) {
            water.step(dt);
            for (std::size_t i = 0; i < 100; ++i) most = std::max(most, std::abs(water.velocity(i, 0).value()[0]));
        }
        CHECK(most <= 1e-12);
    }
}

TEMPLATE_TEST_CASE("pipes: over any bed no height is negative and no water is lost (hard cases W3, W8)", "[water]",
                   float, double) {
    const double bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
    for (const unsigned seed : {1U, 2U, 3U}) {
        const auto grid = unequal(9, 7);
        const auto bed = rugged<TestType>(grid.size(), seed);
        Surface<Pipes, TestType> water({}, grid, std::span<const TestType>(bed), 0.0 * metre);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> height(-1, 2);
        set_heights(water, [&](double, double) { return std::max(0.0, height(random)); }); // many columns are dry
        const double before = water.volume().value();
        for (int n = 0; n < 10000; ++n) {
            water.step(std::min(0.1 * second, water.longest_step()));
            for (const TestType h : water.heights()) REQUIRE(h >= TestType(0));
        }
        CHECK(std::abs(water.volume().value() / before - 1) <= bound);
    }
    // A dam over nearly dry ground, on which the linear columns reach -0.25 m.
    Surface<Pipes, TestType> dam({}, ColumnGrid(100, 1, 0.1 * metre, 1.0 * metre), 0.0 * metre);
    set_heights(dam, [](double x, double) { return x < 5 ? 1.0 : 0.01; });
    for (int n = 0; n < 2000; ++n) {
        dam.step(0.9 * dam.longest_step());
        for (const TestType h : dam.heights()) REQUIRE(h >= TestType(0));
    }
    CHECK(std::abs(dam.volume().value() / 5.05 - 1) <= bound);
}

TEST_CASE("a seiche has the period of shallow water, to second order (hard case W5)", "[water]") {
    std::vector<double> errors;
    for (const std::size_t count : {16U, 32U, 64U}) {
        const double dx = 10.0 / double(count), dt = 0.5 * dx / std::sqrt(9.81);
        Surface water(Pipes{}, ColumnGrid(count, 1, dx * metre, 1.0 * metre), 1.0 * metre);
        set_heights(water, [](double x, double) { return 1 + 1e-6 * std::cos(pi * x / 10); }); // low, so linear
        double first = 0, last = 0, before = 1e-6;
        int crossings = 0;
        for (int n = 1; crossings < 9; ++n) {
            water.step(dt * second);
            const double now = water.height(0, 0).value() - 1;
            if ((now < 0) != (before < 0)) {
                last = (n - now / (now - before)) * dt;
                if (++crossings == 1) first = last;
            }
            before = now;
        }
        errors.push_back(std::abs((last - first) / 4 / 6.385509 - 1));
    }
    //! [measured]
    CHECK(test::measured("W5", "Pipes: error of the period, 64 columns", errors[2], test::at_most(1e-4)));
    CHECK(test::measured("W5", "Pipes: order of convergence", order(errors), test::at_least(1.95)));
    //! [measured]
}

TEST_CASE("low waves over level water are those of the columns", "[water]") {
    const auto grid = unequal(9, 7);
    const auto wave = [](double x, double z) { return 2 + 1e-6 * std::sin(x) * std::cos(0.7 * z); };
    Surface pipes(Pipes{.damping = 0.2 / second}, grid, 2.0 * metre);
    Surface columns(WaterColumns{std::sqrt(2 * 9.81) * mps, 0.2 / second}, grid, 2.0 * metre);
    set_heights(pipes, wave);
    set_heights(columns, wave);
    for (int n = 0; n < 200; ++n) {
        pipes.step(0.03 * second);
        columns.step(0.03 * second);
    }
    for (std::size_t n = 0; n < grid.size(); ++n)
        CHECK(pipes.heights()[n] == Approx(columns.heights()[n]).margin(1e-10));
}

TEST_CASE("the flow is the water's: it moves the middle of the volume", "[water]") {
    const auto grid = unequal(8, 6);
    const auto bed = rugged<double>(grid.size(), 5);
    Surface water(Pipes{}, grid, std::span<const double>(bed), 1.5 * metre);
    set_heights(water, [](double x, double z) { return 0.5 + 0.2 * std::sin(x + z); });
    for (int n = 0; n < 30; ++n) water.step(0.03 * second);
    auto moment = [&] {
        double sum = 0;
        for (std::size_t j = 0; j < 6; ++j)
            for (std::size_t i = 0; i < 8; ++i)
                sum += (grid.footprint(i, j) * water.height(i, j) * grid.centre_x(i)).value();
        return sum;
    };
    const double before = moment();
    water.step(0.03 * second);
    double carried = 0; // of all faces: flow times the way from centre to centre
    for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t i = 0; i + 1 < 8; ++i)
            carried += water.state().flow_x[grid.index(i, j)] * (grid.centre_x(i + 1) - grid.centre_x(i)).value();
    CHECK(moment() - before == Approx(0.03 * carried).epsilon(1e-9));
    const double here = water.height(2, 3).value(), west = water.height(1, 3).value(),
                 east = water.height(3, 3).value();
    CHECK(water.velocity(2, 3).value()[0] == Approx(0.5 *
                                                    (water.state().flow_x[grid.index(1, 3)] / std::max(west, here) +
                                                     water.state().flow_x[grid.index(2, 3)] / std::max(here, east)) /
                                                    grid.width_z(3).value()));
    CHECK(Surface(Pipes{}, grid, 0.0 * metre).velocity(2, 3) == metres_per_second(0, 0));
}

TEST_CASE("the first step is the law itself: into a dry column, and over a sill that stands below the higher level",
          "[water]") {
    const ColumnGrid grid(3, 1, 2.0 * metre, 3.0 * metre);
    const std::vector<double> bed{0.0, 0.25, 5.0}; // the last one is out of reach
    Surface water(Pipes{}, grid, std::span<const double>(bed), 0.0 * metre);
    water.set_height(0, 0, 1.0 * metre);
    water.step(0.01 * second);
    const double flow = 9.81 * 0.01 * 3 * (1 - 0.25) * (1 - 0.25) / 2; // g dt w d (eta - eta') / s
    CHECK(water.state().flow_x[0] == Approx(flow).epsilon(1e-14));
    CHECK(water.state().flow_x[1] == 0);
    CHECK(water.height(1, 0).value() == Approx(0.01 * flow / 6).epsilon(1e-14));
}

TEST_CASE("mirrored and turned, the water does the same", "[water]") {
    const std::size_t n = 7;
    const ColumnGrid grid(n, n, 1.0 * metre);
    const auto bed = rugged<double>(n * n, 8);
    std::vector<double> turned(n * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) turned[i * n + (n - 1 - j)] = bed[j * n + i];
    Surface water(Pipes{}, grid, std::span<const double>(bed), 0.3 * metre);
    Surface other(Pipes{}, grid, std::span<const double>(turned), 0.3 * metre);
    water.set_height(1, 2, 3.0 * metre);
    other.set_height(n - 1 - 2, 1, 3.0 * metre);
    for (int step = 0; step < 200; ++step) {
        const auto dt = std::min({0.1 * second, water.longest_step(), other.longest_step()});
        water.step(dt);
        other.step(dt);
    }
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
            CHECK(other.heights()[i * n + (n - 1 - j)] == Approx(water.heights()[j * n + i]).margin(1e-9));
}

TEST_CASE("pipes refuse a step beyond the limit of their deepest column, and a bed that is none", "[water]") {
    const ColumnGrid grid(4, 4, 1.0 * metre);
    Surface water(Pipes{}, grid, 1.0 * metre);
    CHECK(water.longest_step().value() == Approx(1 / std::sqrt(2 * 9.81)).epsilon(1e-14));
    water.set_height(2, 2, 4.0 * metre);
    CHECK(water.longest_step().value() == Approx(1 / std::sqrt(4 * 2 * 9.81)).epsilon(1e-14));
    const auto before = water.state();
    CHECK(refusal([&] { water.step(0.2 * second); }).find("Surface::step: dt is 0.2 s; the longest step that Pipes") ==
          0);
    CHECK(water.state() == before);
    CHECK(Surface(Pipes{}, grid, 0.0 * metre).longest_step().value() == std::numeric_limits<double>::infinity());
    std::vector<double> bed(16, 0.0);
    bed[6] = not_a_number;
    CHECK(refusal([&] { Surface(Pipes{}, grid, std::span<const double>(bed), 1.0 * metre); }) ==
          "Surface: the bed at column (2, 1) is nan m; it must be finite");
    bed.pop_back();
    CHECK(refusal([&] { Surface(Pipes{}, grid, std::span<const double>(bed), 1.0 * metre); }) ==
          "Surface: the number of heights of the bed is 15; there is one for each of the 16 columns");
    CHECK(refusal([&] { Surface(Pipes{.gravity = 0.0 * metre_per_second_squared}, grid, 1.0 * metre); }) ==
          "Pipes: gravity is 0 m/s^2; it must be finite and greater than zero");
}
