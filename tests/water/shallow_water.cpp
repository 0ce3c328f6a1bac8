// SPDX-License-Identifier: BSL-1.0
// Saint-Venant's equations against their closed forms (SWASHES): lakes at rest, dam breaks over dry and wet ground, a
// lake that rocks in a parabola; volume, heights that are never negative, symmetry.

#include <ansatz/water/shallow_water.hpp>

#include "tests/water/shallow_cases.hpp"

using namespace water_tests;

TEMPLATE_TEST_CASE("shallow water: still water over a level bed keeps its bits for 1e5 steps (hard case W1)", "[water]",
                   float, double) {
    Surface<ShallowWater, TestType> water({}, unequal(3, 3), 1.7 * metre);
    const auto before = water.state();
    const auto dt = water.longest_step();
    for (int n = 0; n < 100000; ++n) water.step(dt);
    CHECK(water.state() == before);
}

TEST_CASE(
    "shallow water: a lake at rest stays at rest, over a hump that is covered and one that emerges (hard case W2)",
    "[water]") {
    const auto grid = channel(100, 25);
    const auto bed = hump(grid);
    for (const double level : {0.5, 0.1}) {
        Surface water(ShallowWater{}, grid, std::span<const double>(bed), level * metre);
        run(water, 10);
        double most = 0;
        for (std::size_t i = 0; i < 100; ++i) most = std::max(most, std::abs(water.velocity(i, 0).value()[0]));
        CHECK(most <= 1e-12);
    }
}

TEMPLATE_TEST_CASE("shallow water: over any bed no height is negative and no water is lost (hard cases W3, W8)",
                   "[water]", float, double) {
    const double bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
    for (const unsigned seed : {1U, 2U}) {
        const auto grid = unequal(6, 5);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> high(-1, 2);
        std::vector<TestType> bed;
        for (std::size_t n = 0; n < grid.size(); ++n) bed.push_back(TestType(high(random)));
        Surface<ShallowWater, TestType> water({}, grid, std::span<const TestType>(bed), 0.0 * metre);
        set_heights(water, [&](double, double) { return std::max(0.0, high(random)); });
        const double before = water.volume().value();
        for (int n = 0; n < 10000; ++n) {
            water.step(std::min(0.1 * second, water.longest_step()));
            for (const TestType h : water.heights()) REQUIRE(h >= TestType(0));
        }
        CHECK(std::abs(water.volume().value() / before - 1) <= bound);
    }
}

TEST_CASE("a dam over dry ground breaks as Ritter says (hard case W6)", "[water]") {
    const Dam ritter(0);
    std::vector<double> errors;
    for (const std::size_t count : {100U, 200U, 400U}) {
        const auto water = ritter.broken(ShallowWater{}, count);
        errors.push_back(off(water, ritter));
        CHECK(water.volume().value() == Approx(0.025).epsilon(1e-12));
    }
    INFO("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    CHECK(errors[0] <= 2.0e-2);
    CHECK(errors[1] <= 1.3e-2);
    CHECK(errors[2] <= 8.5e-3);
    CHECK(order(errors) >= 0.55);
}

TEST_CASE("a dam over wet ground breaks as Stoker says, and its shock is where it should be (hard case W7)",
          "[water]") {
    const Dam stoker(0.001);
    CHECK(stoker.middle == Approx(0.002539).margin(1e-6)); // the row's own figures
    CHECK(stoker.shock == Approx(0.209963).margin(1e-5));
    std::vector<double> errors;
    for (const std::size_t count : {100U, 200U, 400U}) {
        const auto water = stoker.broken(ShallowWater{}, count);
        errors.push_back(off(water, stoker));
        std::size_t front = count - 1;
        while (water.height(front, 0).value() < 0.5 * (stoker.middle + stoker.low)) --front;
        const double face = water.grid().centre_x(front).value() + 5.0 / double(count);
        CHECK(std::abs(face - (5 + 6 * stoker.shock)) <= 2 * 10.0 / double(count));
    }
    INFO("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    CHECK(errors[0] <= 2.0e-2);
    CHECK(order(errors) >= 0.7);
}

TEST_CASE("a lake rocks in a parabola as Thacker says (hard case W9)", "[water]") {
    const Lake lake;
    std::vector<double> errors;
    for (const std::size_t count : {100U, 200U, 400U}) {
        auto water = lake.at_rest(ShallowWater{}, count);
        const double before = water.volume().value();
        run(water, lake.period);
        CHECK(water.volume().value() == Approx(before).epsilon(1e-12));
        errors.push_back(off(water, [&](double x) { return lake(x, lake.period); }));
    }
    INFO("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    CHECK(order(errors) >= 0.9);
}

TEST_CASE("along z the water does as along x, and in a mirror as well", "[water]") {
    const std::size_t n = 7;
    const ColumnGrid grid(n, n, 1.0 * metre);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> high(-1, 1);
    std::vector<double> bed(n * n), turned(n * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) turned[i * n + (n - 1 - j)] = bed[j * n + i] = high(random);
    Surface water(ShallowWater{}, grid, std::span<const double>(bed), 0.3 * metre);
    Surface other(ShallowWater{}, grid, std::span<const double>(turned), 0.3 * metre);
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

TEST_CASE("what passes a face is Harten, Lax and van Leer's flux, as their paper writes it", "[water]") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> height(0.01, 2), speed(-6, 6);
    for (int n = 0; n < 1000; ++n) {
        const double h1 = height(random), h2 = height(random), u1 = speed(random), u2 = speed(random),
                     w1 = speed(random), w2 = speed(random), c1 = std::sqrt(g * h1), c2 = std::sqrt(g * h2);
        const double slow = std::min(u1 - c1, u2 - c2), fast = std::max(u1 + c1, u2 + c2);
        auto flux = [&](double q1, double q2, double f1, double f2) {
            if (slow >= 0) return f1;
            return fast <= 0 ? f2 : (fast * f1 - slow * f2 + slow * fast * (q2 - q1)) / (fast - slow);
        };
        const double p1 = g / 2 * h1 * h1, p2 = g / 2 * h2 * h2, mass = flux(h1, h2, h1 * u1, h2 * u2),
                     momentum = flux(h1 * u1, h2 * u2, h1 * u1 * u1 + p1, h2 * u2 * u2 + p2);
        const auto found = detail::hll<double>({h1, 0.5, u1, w1, c1}, {h2, 0.5, u2, w2, c2}, g);
        CHECK(found.mass == Approx(mass).margin(1e-12));
        CHECK(found.push_low == Approx(momentum - p1).margin(1e-11));
        CHECK(found.push_high == Approx(momentum - p2).margin(1e-11));
        CHECK(found.along == Approx(mass * (mass > 0 ? w1 : w2)).margin(1e-11));
    }
}

TEST_CASE("in a pit whose banks are higher than its water, the water comes to rest", "[water]") {
    const auto grid = channel(5, 5);
    const std::vector<double> bed{0.0, 2.0, 0.0, 2.0, 0.0};
    Surface water(ShallowWater{}, grid, std::span<const double>(bed), 0.0 * metre);
    water.set_height(0, 0, 3.5 * metre); // some of it falls into the pit
    auto fastest = [&] { return std::abs(water.velocity(2, 0).value()[0]); };
    double most = 0;
    for (int n = 0; n < 200; ++n) {
        water.step(water.longest_step());
        most = std::max(most, fastest());
    }
    CHECK(most > 1);
    run(water, 60);
    CHECK(water.height(2, 0).value() > 0.1);
    CHECK(water.height(2, 0).value() < 1.9);
    CHECK(fastest() < 1e-3 * most);
}

TEST_CASE("momentum is what walls give: at the far end of a channel they have given nothing yet", "[water]") {
    // A dam break between still waters: the total momentum grows by g/2 (H^2 - h^2) a second, the pressure of both
    // ends.
    Surface water(ShallowWater{}, channel(60, 6), 0.0 * metre);
    set_heights(water, [](double x, double) { return x < 3 ? 1.0 : 0.4; });
    double t = 0;
    for (int n = 0; n < 20; ++n) {
        const auto dt = water.longest_step();
        water.step(dt);
        t += dt.value();
        double momentum = 0;
        for (const double hu : water.state().momentum_x) momentum += 0.1 * hu;
        CHECK(momentum == Approx(g / 2 * (1 - 0.16) * t).epsilon(1e-12));
    }
}

TEST_CASE("a step beyond half of the limit is refused before anything moves", "[water]") {
    Surface water(ShallowWater{}, ColumnGrid(4, 4, 1.0 * metre, 2.0 * metre), 1.0 * metre);
    CHECK(water.longest_step().value() == Approx(0.495 / (1.5 * std::sqrt(g))).epsilon(1e-14));
    const auto before = water.state();
    CHECK(refusal([&] {
              water.step(0.2 * second);
          }).find("Surface::step: dt is 0.2 s; the longest step that ShallowWater takes with these columns is ") == 0);
    CHECK(water.state() == before);
    CHECK(refusal([&] {
              Surface(ShallowWater{-1.0 * metre_per_second_squared}, ColumnGrid(3, 3, 1.0 * metre), 1.0 * metre);
          }) == "ShallowWater: gravity is -1 m/s^2; it must be finite and greater than zero");
}
