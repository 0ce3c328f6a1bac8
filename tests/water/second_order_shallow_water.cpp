// SPDX-License-Identifier: BSL-1.0
// Saint-Venant's equations to second order: what the first order keeps it keeps (lakes at rest, volume, heights that
// are not negative, symmetry), and it comes nearer to the closed forms, with the order of its name where they are
// smooth.

#include <ansatz/water/second_order_shallow_water.hpp>

#include "tests/measured.hpp"
#include "tests/water/shallow_cases.hpp"

using namespace water_tests;

namespace {
using Second = SecondOrderShallowWater;

/// Heights that vary by a metre, or beds.
template <class Scalar> std::vector<Scalar> rough(const ColumnGrid& grid, unsigned seed, double low, double high) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(low, high);
    std::vector<Scalar> all;
    for (std::size_t n = 0; n < grid.size(); ++n) all.push_back(Scalar(any(random)));
    return all;
}
template <class Surface_> double fastest(const Surface_& water) {
    double most = 0;
    for (std::size_t j = 0; j < water.grid().columns_z(); ++j)
        for (std::size_t i = 0; i < water.grid().columns_x(); ++i)
            most = std::max(most, double(water.velocity(i, j).value().cwiseAbs().maxCoeff()));
    return most;
}
} // namespace

TEMPLATE_TEST_CASE("second order: still water over a level bed keeps its bits for 1e5 steps (hard case W1)", "[water]",
                   float, double) {
    Surface<Second, TestType> water({}, unequal(3, 3), 1.7 * metre);
    const auto before = water.state();
    const auto dt = water.longest_step();
    for (int n = 0; n < 100000; ++n) water.step(dt);
    CHECK(water.state() == before);
}

TEST_CASE("second order: a lake at rest stays as it is, over a hump that is covered and one that emerges (hard case "
          "W2)",
          "[water]") {
    const auto grid = channel(100, 25);
    const auto bed = hump(grid);
    for (const double level : {0.5, 0.1}) {
        Surface water(Second{}, grid, std::span<const double>(bed), level * metre);
        const auto before = water.state().height;
        run(water, 10);
        CHECK(test::measured("W2", level > 0.2 ? "second order, hump covered" : "second order, hump that emerges",
                             fastest(water), test::at_most(1e-12), "m/s"));
        for (std::size_t i = 0; i < 100; ++i) CHECK(std::abs(water.heights()[i] - before[i]) <= 1e-13);
    }
}

TEST_CASE("second order: a lake of islands stays at rest in two dimensions, over unequal columns (hard case W2)",
          "[water]") {
    for (const unsigned seed : {3U, 4U, 5U}) {
        const auto grid = unequal(9, 8);
        const auto bed = rough<double>(grid, seed, -1, 1.5);
        Surface water(Second{}, grid, std::span<const double>(bed), 0.6 * metre);
        const auto before = water.state().height;
        run(water, 20);
        CHECK(fastest(water) <= 1e-12);
        for (std::size_t n = 0; n < grid.size(); ++n) CHECK(std::abs(water.heights()[n] - before[n]) <= 1e-13);
    }
}

TEMPLATE_TEST_CASE("second order: over any bed no height is negative and no water is lost (hard cases W3, W8)",
                   "[water]", float, double) {
    const double bound = std::is_same_v<TestType, float> ? 1e-6 : 1e-12;
    for (const unsigned seed : {1U, 2U}) {
        const auto grid = unequal(6, 5);
        const auto bed = rough<TestType>(grid, seed, -1, 2);
        Surface<Second, TestType> water({}, grid, std::span<const TestType>(bed), 0.0 * metre);
        auto heights = rough<TestType>(grid, seed + 10, -1, 2);
        for (auto& h : heights) h = std::max(TestType(0), h);
        water.set_heights(heights);
        const double before = water.volume().value();
        for (int n = 0; n < 10000; ++n) {
            water.step(std::min(0.1 * second, water.longest_step()));
            for (const TestType h : water.heights()) REQUIRE(h >= TestType(0));
        }
        CHECK(test::measured("W3", std::is_same_v<TestType, float> ? "second order in float" : "second order",
                             std::abs(water.volume().value() / before - 1), test::at_most(bound), "of the volume"));
    }
}

TEST_CASE("second order: where the first stage makes the water faster no height becomes negative (hard case W8)",
          "[water]") {
    // A film lies still on a slope. Its waves are slow, so that the step is long, and within its first stage the film
    // comes to run much faster: as long a second one would take more from it than there is.
    for (const std::size_t wet : {1U, 2U, 3U, 6U})
        for (const double film : {0.001, 0.01, 0.1})
            for (const double slope : {0.05, 0.3, 1.0}) {
                std::vector<double> bed, heights(8, 0.0);
                for (int i = 8; i > 0; --i) bed.push_back(slope * i);
                std::fill_n(heights.begin(), wet, film);
                Surface water(Second{}, channel(8, 8), std::span<const double>(bed), 0.0 * metre);
                water.set_heights(heights);
                for (int n = 0; n < 20; ++n) {
                    water.step(water.longest_step());
                    for (const double h : water.heights()) REQUIRE(h >= 0);
                }
                CHECK(water.volume().value() == Approx(double(wet) * film).epsilon(1e-12));
            }
}

TEST_CASE("second order: dams break nearer to Ritter and Stoker than to first order (hard cases W6, W7)", "[water]") {
    for (const double low : {0.0, 0.001}) {
        const Dam dam(low);
        const auto* const row = low > 0 ? "W7" : "W6";
        std::vector<double> errors;
        for (const std::size_t count : {100U, 200U, 400U}) {
            const auto water = dam.broken(Second{}, count);
            errors.push_back(off(water, dam));
            const double first = off(dam.broken(ShallowWater{}, count), dam);
            CHECK(test::measured(row, "error to second order over that to first, " + std::to_string(count) + " columns",
                                 errors.back() / first, test::at_most(0.5)));
            CHECK(water.volume().value() == Approx(0.025 + 5 * low).epsilon(1e-12));
        }
        INFO("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
        CHECK(errors[0] <= 2.0e-2);
        CHECK(order(errors) >= 0.7);
    }
}

TEST_CASE("second order: a lake rocks in a parabola as Thacker says, nearer than to first order (hard case W9)",
          "[water]") {
    const Lake lake;
    std::vector<double> errors;
    for (const std::size_t count : {100U, 200U, 400U}) {
        auto water = lake.at_rest(Second{}, count), first = water;
        auto other = lake.at_rest(ShallowWater{}, count);
        run(water, lake.period);
        run(other, lake.period);
        CHECK(water.volume().value() == Approx(first.volume().value()).epsilon(1e-12));
        auto then = [&](double x) { return lake(x, lake.period); };
        errors.push_back(off(water, then));
        CHECK(errors.back() < 0.5 * off(other, then));
    }
    INFO("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    CHECK(order(errors) >= 0.9);
}

TEST_CASE("second order: a wave without a shock converges to second order", "[water]") {
    const SimpleWave wave;
    std::vector<double> first, second_;
    for (const std::size_t count : {200U, 400U, 800U}) {
        first.push_back(wave.error(ShallowWater{}, count));
        second_.push_back(wave.error(Second{}, count));
    }
    INFO("errors " << second_[0] << ' ' << second_[1] << ' ' << second_[2] << ", to first order " << first[2]);
    CHECK(order(second_) >= 1.9);
    CHECK(order(first) <= 1.05);  // the case tells them apart
    CHECK(second_[0] < first[2]); // with a quarter of the columns
}

TEST_CASE("second order: along z the water does as along x to the bit, and in a mirror nearly so", "[water]") {
    const std::size_t n = 7;
    const ColumnGrid grid(widths(n, 0.3), widths(n, 0.3));
    auto bed = rough<double>(grid, 8, -1, 1);
    std::vector<double> turned(n * n), mirrored(n * n);
    auto swapped = [&](std::size_t k) { return k % n * n + k / n; };
    auto in_mirror = [&](std::size_t k) { return k / n * n + (n - 1 - k % n); };
    for (std::size_t k = 0; k < n * n; ++k) turned[swapped(k)] = mirrored[in_mirror(k)] = bed[k];
    auto back = widths(n, 0.3);
    std::reverse(back.begin(), back.end());
    Surface water(Second{}, grid, std::span<const double>(bed), 0.3 * metre);
    Surface other(Second{}, grid, std::span<const double>(turned), 0.3 * metre);
    Surface third(Second{}, ColumnGrid(back, widths(n, 0.3)), std::span<const double>(mirrored), 0.3 * metre);
    water.set_height(1, 2, 3.0 * metre);
    other.set_height(2, 1, 3.0 * metre);
    third.set_height(n - 1 - 1, 2, 3.0 * metre);
    for (int step = 0; step < 200; ++step) {
        const auto dt = std::min({0.05 * second, water.longest_step(), third.longest_step()});
        water.step(dt);
        other.step(dt);
        third.step(dt);
    }
    for (std::size_t k = 0; k < n * n; ++k) {
        CHECK(other.heights()[swapped(k)] == water.heights()[k]);
        CHECK(third.heights()[in_mirror(k)] == Approx(water.heights()[k]).margin(1e-9));
    }
}

TEST_CASE("second order: momentum is what the ends give, also where the second stage is shortened", "[water]") {
    // Between still waters the total momentum grows by g/2 (H^2 - h^2) a second, whatever stages a step is made of.
    for (const double low : {0.4, 0.0}) {
        Surface water(Second{}, channel(60, 6), 0.0 * metre);
        set_heights(water, [&](double x, double) { return x < 3 ? 1.0 : low; });
        double t = 0;
        for (int n = 0; n < 20; ++n) {
            const auto dt = water.longest_step();
            water.step(dt);
            t += dt.value();
            double momentum = 0;
            for (const double hu : water.state().momentum_x) momentum += 0.1 * hu;
            CHECK(momentum == Approx(g / 2 * (1 - low * low) * t).epsilon(1e-9));
        }
    }
}

TEST_CASE("second order: on a slope water slides as fast as without friction, where to first order it lags",
          "[water]") {
    // 10 cm on a slope of a tenth, in columns of 50 cm: to first order a face is as deep as the water above the higher
    // bed.
    const auto grid = channel(80, 40);
    std::vector<double> bed;
    for (std::size_t i = 0; i < 80; ++i) bed.push_back(4 - 0.1 * grid.centre_x(i).value());
    auto after = [&](const auto& policy) {
        Surface water(policy, grid, std::span<const double>(bed), 0.0 * metre);
        set_heights(water, [](double, double) { return 0.1; });
        run(water, 2);
        return water.velocity(40, 0).value()[0];
    };
    CHECK(after(Second{}) == Approx(g * 0.1 * 2).epsilon(1e-9));
    CHECK(after(ShallowWater{}) == Approx(g * 0.1 * 2 * (1 - 0.05 / (2 * 0.1))).epsilon(1e-9));
}

TEST_CASE("second order: what is a line stays a line, also where columns are unequal", "[water]") {
    // Half of what changes within a column, of a line 3 + 0.2 x through unequal columns: 0.1 of its width.
    const auto grid = unequal(9, 3);
    const detail::LinesAlong<double> lines(grid.x(), 2);
    for (std::size_t i = 1; i + 1 < 9; ++i) {
        auto at = [&](std::size_t k) { return 3 + 0.2 * grid.centre_x(k).value(); };
        const double half = lines[i].half(at(i - 1), at(i), at(i + 1));
        CHECK(half == Approx(0.1 * grid.width_x(i).value()).epsilon(1e-12));
        // A face has no more and no less than both columns beside it, and a top is flat.
        CHECK(lines[i].half(1.0, 2.0, 1.0) == 0);
        CHECK(lines[i].half(1.0, 2.0, 9.0) <= 1);
        CHECK(lines[i].half(9.0, 2.0, 1.0) >= -1);
        CHECK(lines[i].half(1.0, 2.0, 2.0) == 0);
    }
}

TEST_CASE("second order: a state goes on from the first order, and back", "[water]") {
    const auto grid = unequal(5, 4);
    Surface first(ShallowWater{}, grid, 1.0 * metre);
    first.set_height(1, 1, 2.0 * metre);
    for (int n = 0; n < 10; ++n) first.step(0.02 * second);
    Surface water(Second{}, grid, 1.0 * metre, first.state());
    CHECK(water.state() == first.state());
    for (int n = 0; n < 10; ++n) water.step(0.02 * second);
    auto copy = water;
    for (int n = 0; n < 10; ++n) {
        water.step(0.02 * second);
        copy.step(0.02 * second);
    }
    CHECK(copy.state() == water.state());
    CHECK(Surface(ShallowWater{}, grid, 1.0 * metre, water.state()).volume().value() ==
          Approx(first.volume().value()).epsilon(1e-13));
}

TEST_CASE("second order: a step beyond half of the limit is refused before anything moves", "[water]") {
    Surface water(Second{}, ColumnGrid(4, 4, 1.0 * metre, 2.0 * metre), 1.0 * metre);
    CHECK(water.longest_step().value() == Approx(0.495 / (1.5 * std::sqrt(g))).epsilon(1e-14));
    const auto before = water.state();
    CHECK(
        refusal([&] { water.step(0.2 * second); })
            .find("Surface::step: dt is 0.2 s; the longest step that SecondOrderShallowWater takes with these columns "
                  "is ") == 0);
    CHECK(water.state() == before);
    // Two neighbours, one fast, the other deep: the line between them may have both.
    auto state = before;
    state.height[5] = 4;
    state.momentum_x[6] = 3;
    const Surface both(Second{}, water.grid(), 1.0 * metre, state);
    const double c = std::sqrt(g * 4);
    CHECK(both.longest_step().value() == Approx(0.495 / ((3 + c) + 0.5 * c)).epsilon(1e-14));
    CHECK(Surface(Second{}, ColumnGrid(70, 3, 1.0 * metre), 0.0 * metre).longest_step() ==
          std::numeric_limits<double>::infinity() * second); // all dry
}

TEST_CASE("second order: the longest step sees the last column of a row, and every pair of a wide one", "[water]") {
    // Rows are handled in blocks of 64.
    for (const std::size_t nx : {3U, 64U, 65U, 66U, 128U, 129U, 130U})
        for (const std::size_t i : {std::size_t(0), std::size_t(62), std::size_t(63), std::size_t(64), nx - 2}) {
            if (i + 1 >= nx) continue;
            const ColumnGrid grid(nx, 1, 1.0 * metre, 1.0 * metre);
            auto state = Surface(Second{}, grid, 1.0 * metre).state();
            state.height[i] = 4;
            state.momentum_x[i + 1] = -3;
            CHECK(Surface(Second{}, grid, 1.0 * metre, state).longest_step().value() ==
                  Approx(0.495 / (3 + std::sqrt(g * 4))).epsilon(1e-14));
        }
}

TEST_CASE("second order: a steepness that makes waves, or is no number, is refused", "[water]") {
    for (const double steepness : {0.99, 2.01, not_a_number})
        CHECK(refusal([&] {
                  Surface(Second{.steepness = steepness}, ColumnGrid(3, 3, 1.0 * metre), 1.0 * metre);
              }).find("SecondOrderShallowWater: steepness is ") == 0);
    CHECK(refusal([&] {
              Surface(Second{-1.0 * metre_per_second_squared}, ColumnGrid(3, 3, 1.0 * metre), 1.0 * metre);
          }) == "SecondOrderShallowWater: gravity is -1 m/s^2; it must be finite and greater than zero");
}

// LeVeque's radial dam (Finite Volume Methods for Hyperbolic Problems, 21.7): 2 m within half a metre, 1 m around it, g
// = 1. After half a second Clawpack says 1.13466 m where the dam was, as the program HYPRadialDamBreak of CppNoddy
// quotes it, which holds itself to it within 1e-3.
TEST_CASE("second order: a round dam breaks as in Clawpack, along x, along z and between them", "[water]") {
    constexpr std::size_t count = 300;
    constexpr double width = 1.5 / count; // a quarter of it, between walls that are its planes of symmetry
    Surface water(SecondOrderShallowWater{1.0 * metre_per_second_squared}, ColumnGrid(count, count, width * metre),
                  1.0 * metre);
    set_heights(water, [&](double x, double z) {
        double sum = 0; // of the points of a column
        for (const double a : {-0.4, -0.2, 0.0, 0.2, 0.4})
            for (const double b : {-0.4, -0.2, 0.0, 0.2, 0.4})
                sum += 1.5 - 0.5 * std::tanh(100 * (std::hypot(x + a * width, z + b * width) - 0.5));
        return sum / 25;
    });
    for (double t = 0; t < 0.5;) {
        const double dt = std::min(water.longest_step().value(), 0.5 - t);
        water.step(dt * second);
        t += dt;
    }
    const double between = 0.5 / std::sqrt(2.0);
    const auto level = [&](double x, double z) { return water.level(x * metre, z * metre).value(); };
    CHECK(level(0.5, 0) == Approx(1.13466).margin(1e-3));
    CHECK(level(0, 0.5) == Approx(1.13466).margin(1e-3));
    CHECK(level(between, between) == Approx(1.13466).margin(1e-3));
}

// What rounding has taken from a height is kept beside it in float; whatever sets the height knows nothing of that.
TEMPLATE_TEST_CASE("in float, columns that are set while water runs hold no less than nothing, and lose none",
                   "[water]", ShallowWater, SecondOrderShallowWater) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        Surface<TestType, float> water(TestType{}, unequal(9, 4), 0.0 * metre);
        std::mt19937 random(seed);
        double held = 0; // m^3, as a plain sum says
        for (int n = 0; n < 2000; ++n) {
            if (n % 20 == 0) {
                const auto i = random() % 9, j = random() % 4;
                const float height = random() % 3 > 0 ? 0.0f : 1.3f;
                held += double(height - water.height(i, j).value()) * water.grid().footprint(i, j).value();
                water.set_height(i, j, decltype(water.height(i, j))::from_value(height));
            }
            if (n % 100 == 95) { // and all at once
                water.set_heights(std::vector<float>(36, 0.0f));
                held = 0;
            }
            const auto dt = water.longest_step();
            water.step(std::isinf(dt.value()) ? 0.1 * second : std::min(dt, 0.1 * second));
            for (const float h : water.heights()) REQUIRE(h >= 0); // nor is one NaN
            REQUIRE(water.volume().value() == Approx(held).margin(2e-5));
        }
    }
}
