// SPDX-License-Identifier: BSL-1.0
// The notes' columns: still water, volume, the Courant limit by the closed form of the scheme, the shadow energy,
// seiches, walls, damping.

#include <ansatz/water/water_columns.hpp>

#include "tests/measured.hpp"
#include "tests/water/support.hpp"

#include <array>

using namespace water_tests;

namespace {
const Wall every_wall[] = {Wall::reflects, Wall::holds, Wall::absorbs};

template <class Scalar> void stir(Surface<WaterColumns, Scalar>& water, unsigned seed, double most) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> wave(-most, most);
    set_heights(water, [&](double, double) { return 2 + wave(random); });
}
/// The discrete closed form of a mode of checkers: h_n = cos(n theta), with theta = 2 asin(omega dt / 2), or its
/// growth.
double mode_after(int steps, double courant, int axes, double along) {
    const double half = std::sqrt(double(axes) * along) * courant / 2; // omega dt / 2
    if (half <= 1) return std::cos(steps * 2 * std::asin(half));
    return (steps % 2 ? -1 : 1) * std::cosh(steps * 2 * std::acosh(half));
}
/// Steps columns of 1 m and 1 m/s that begin as that mode, at rest in the middle of a step, without the door's check.
/// \return the largest height in the run, or the first one beyond 1e6 with the number of its step
std::pair<double, int> checkers(std::size_t nx, std::size_t nz, double courant, Wall wall, double along, int steps,
                                bool compare) {
    const ColumnGrid grid(nx, nz, 1.0 * metre);
    const WaterColumns::In<double> loop(WaterColumns{.wave_speed = mps, .walls = Walls::all(wall)}, grid, 0.0 * metre);
    auto shape = [&](std::size_t i, std::size_t n) {
        if (n == 1) return 1.0;
        if (wall == Wall::holds) return i % 2 ? -1.0 : 1.0;
        return std::cos((double(n) - 1) * pi * (double(i) + 0.5) / double(n));
    };
    std::vector<double> height(nx * nz), rate(nx * nz);
    const int axes = nz > 1 ? 2 : 1;
    for (std::size_t j = 0; j < nz; ++j)
        for (std::size_t i = 0; i < nx; ++i) {
            height[j * nx + i] = shape(i, nx) * shape(j, nz);
            rate[j * nx + i] = 0.5 * courant * along * axes * height[j * nx + i];
        }
    const double first = height[0];
    double most = 0;
    for (int n = 1; n <= steps; ++n) {
        loop.advance(height, rate, courant * second);
        for (const double h : height) most = std::max(most, std::abs(h));
        if (compare && n <= 100) REQUIRE(height[0] == Approx(first * mode_after(n, courant, axes, along)).margin(1e-9));
        if (most > 1e6) return {most, n};
    }
    return {most, steps};
}
} // namespace

TEMPLATE_TEST_CASE("still water keeps its bits for 1e5 steps (hard case W1)", "[water]", float, double) {
    for (const Wall wall : every_wall) {
        Surface<WaterColumns, TestType> water{
            {.wave_speed = 3.0 * mps, .damping = 0.3 / second, .walls = Walls::all(wall)}, unequal(4, 3), 1.7 * metre};
        const auto before = water.state();
        for (int n = 0; n < 100000; ++n) water.step(0.05 * second);
        CHECK(water.state().height == before.height);
        CHECK(water.state().rate == before.rate);
    }
}

TEMPLATE_TEST_CASE("a closed basin keeps its volume for 1e4 steps, with unequal footprints too (hard case W3)",
                   "[water]", float, double) {
    const double bound = std::is_same_v<TestType, float> ? 1e-5 : 1e-12;
    for (const auto& grid : {ColumnGrid(9, 7, 1.0 * metre), unequal(9, 7)})
        for (const double damping : {0.0, 0.1}) {
            Surface<WaterColumns, TestType> water{{3.0 * mps, damping / second}, grid, 2.0 * metre};
            stir(water, 7, 0.5);
            const double before = water.volume().value();
            const auto dt = 0.9 * water.longest_step();
            for (int n = 0; n < 10000; ++n) water.step(dt);
            CHECK(std::abs(water.volume().value() / before - 1) <= bound);
        }
}

TEST_CASE("the limit is 1/sqrt(2) in two dimensions and 1 in a channel: bounded below, past 1e6 above (hard case W4)",
          "[water]") {
    const double closed = 2 + 2 * std::cos(pi / 64); // of the fastest mode between reflecting walls
    CHECK(test::measured("W4", "largest height at 0.7071", checkers(8, 8, 0.7071, Wall::holds, 4, 20000, true).first,
                         test::at_most(1 + 1e-9), "m"));
    CHECK(checkers(64, 64, 0.7071, Wall::reflects, closed, 300, true).first <= 1 + 1e-9);
    CHECK(checkers(8, 1, 1.0, Wall::holds, 4, 20000, true).first <= 1 + 1e-9);
    for (const auto& [high, steps] : {checkers(8, 8, 0.708, Wall::holds, 4, 20000, true),
                                      checkers(64, 64, 0.708, Wall::reflects, closed, 20000, true),
                                      checkers(8, 1, 1.01, Wall::holds, 4, 20000, true)}) {
        CHECK(high > 1e6);
        CHECK(steps < 1000);
    }
}

TEST_CASE("the longest step is the closed form of that limit, and no longer one is taken", "[water]") {
    const WaterColumns columns{.wave_speed = 4.0 * mps};
    CHECK(Surface(columns, ColumnGrid(5, 5, 0.5 * metre), 1.0 * metre).longest_step().value() ==
          Approx(0.5 / 4 / std::sqrt(2)).epsilon(1e-14));
    CHECK(Surface(columns, ColumnGrid(5, 1, 0.5 * metre), 1.0 * metre).longest_step().value() ==
          Approx(0.125).epsilon(1e-14));
    CHECK(Surface(columns, ColumnGrid(4, 6, 0.5 * metre, 2.0 * metre), 1.0 * metre).longest_step().value() ==
          Approx(1 / (4 * std::sqrt(4 + 0.25))).epsilon(1e-14));
    Surface water(columns, ColumnGrid(5, 5, 0.5 * metre), 1.0 * metre);
    stir(water, 3, 0.1);
    const auto before = water.state();
    CHECK(refusal([&] { water.step(0.1 * second); }) ==
          "Surface::step: dt is 0.1 s; the longest step that WaterColumns takes with these columns is " +
              describe(water.longest_step()) + " (Courant's limit)");
    CHECK(water.state() == before);
    water.step(water.longest_step());
    CHECK_FALSE(water.state() == before);
    // A grid with unequal columns is held to its finest ones, and is stable there.
    for (const Wall wall : every_wall) {
        Surface rough(WaterColumns{.wave_speed = 4.0 * mps, .walls = Walls::all(wall)}, unequal(9, 8), 2.0 * metre);
        stir(rough, 4, 0.5);
        const auto dt = 0.999 * rough.longest_step();
        double most = 0;
        for (int n = 0; n < 4000; ++n) {
            rough.step(dt);
            for (const double h : rough.heights()) most = std::max(most, std::abs(h - 2));
        }
        CHECK(most < 20);
    }
}

TEST_CASE("the energy of the scheme's own Hamiltonian stays, over unequal footprints", "[water]") {
    // Kick, then drift: v M v / 2 + h K h / 2 - dt h K v / 2 is exact, with K summed over faces and M the footprints.
    const auto grid = unequal(8, 6);
    const double c = 3, dt = 0.05;
    Surface water(WaterColumns{c * mps}, grid, 2.0 * metre);
    stir(water, 11, 0.3);
    auto energy = [&] {
        const auto& s = water.state();
        double sum = 0;
        auto faces = [&](std::size_t a, std::size_t b, double width, double distance) {
            const double k = c * c * width / distance, dh = s.height[b] - s.height[a];
            sum += 0.5 * k * dh * (dh - dt * (s.rate[b] - s.rate[a]));
        };
        for (std::size_t j = 0; j < 6; ++j)
            for (std::size_t i = 0; i < 8; ++i) {
                const std::size_t n = grid.index(i, j);
                sum += 0.5 * grid.footprint(i, j).value() * s.rate[n] * s.rate[n];
                if (i < 7) faces(n, n + 1, grid.width_z(j).value(), (grid.centre_x(i + 1) - grid.centre_x(i)).value());
                if (j < 5) faces(n, n + 8, grid.width_x(i).value(), (grid.centre_z(j + 1) - grid.centre_z(j)).value());
            }
        return sum;
    };
    const double before = energy();
    for (int n = 0; n < 5000; ++n) water.step(dt * second);
    CHECK(energy() == Approx(before).epsilon(1e-11));
}

TEST_CASE("a seiche has its period, to second order (hard case W5)", "[water]") {
    const double c = std::sqrt(9.81), period = 20 / c;
    std::vector<double> errors;
    for (const std::size_t count : {16U, 32U, 64U, 128U}) {
        const double dx = 10.0 / double(count);
        Surface water(WaterColumns{c * mps}, ColumnGrid(count, 1, dx * metre, 1.0 * metre), 1.0 * metre);
        set_heights(water, [](double x, double) { return 1 + 0.01 * std::cos(pi * x / 10); });
        const double dt = 0.5 * dx / c;
        double first = 0, last = 0, before = 0.01;
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
        errors.push_back(std::abs((last - first) / 4 / period - 1));
        // The scheme's own: sin(omega dt / 2) = C sin(k dx / 2).
        const double discrete = pi * dt / std::asin(0.5 * std::sin(pi / 20 * dx));
        CHECK((last - first) / 4 == Approx(discrete).epsilon(2e-6));
    }
    CHECK(errors[2] <= 1e-4);
    CHECK(order(errors) >= 1.95);
}

TEST_CASE(
    "a pulse comes back upright from a wall that reflects, upside down from one that holds, and leaves through one "
    "that absorbs (hard case W16)",
    "[water]") {
    const std::size_t count = 400;
    for (const Wall wall : every_wall) {
        Surface water(WaterColumns{.wave_speed = mps, .walls = {Wall::reflects, wall, Wall::reflects, Wall::reflects}},
                      ColumnGrid(count, 1, 0.1 * metre, 1.0 * metre), 1.0 * metre);
        // Going east: h(x - ct), begun by a step back in time, h(x + c dt).
        const double dt = 0.09;
        auto pulse = [](double x) { return 0.1 * std::exp(-(x - 20) * (x - 20) / 4); };
        std::vector<double> height(count), rate(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double x = 0.1 * (double(i) + 0.5);
            height[i] = 1 + pulse(x);
            rate[i] = (pulse(x) - pulse(x + dt)) / dt;
        }
        const double volume = 0.1 * std::sqrt(4 * pi), steepest = 0.1 * std::exp(-0.5) / std::sqrt(2);
        WaterColumns::In<double> loop(water.policy(), water.grid(), 1.0 * metre);
        for (double t = 0; t < 40 - dt / 2; t += dt) loop.advance(height, rate, dt * second); // there and back
        double low = 0, high = 0, sum = 0;
        for (const double h : height) {
            low = std::min(low, h - 1);
            high = std::max(high, h - 1);
            sum += 0.1 * (h - 1);
        }
        if (wall == Wall::reflects) {
            CHECK(high >= 0.098);
            CHECK(low >= -0.002);
            CHECK(sum == Approx(volume).epsilon(1e-9));
        } else if (wall == Wall::holds) {
            CHECK(low <= -0.098);
            CHECK(high <= 0.002);
        } else { // k dx / 4 of each wave comes back: a quarter of dx times the slope
            CHECK(high == Approx(0.1 / 4 * steepest).epsilon(0.05));
            CHECK(low == Approx(-0.1 / 4 * steepest).epsilon(0.05));
        }
    }
}

TEST_CASE("what walls absorb is water: the sum of A v and of c h along them stays", "[water]") {
    const auto grid = unequal(7, 5);
    const double c = 2, dt = 0.1;
    Surface water(WaterColumns{.wave_speed = c * mps, .walls = Walls::all(Wall::absorbs)}, grid, 2.0 * metre);
    stir(water, 5, 0.4);
    auto sum = [&] {
        double all = 0;
        for (std::size_t j = 0; j < 5; ++j)
            for (std::size_t i = 0; i < 7; ++i) {
                const double along_x = grid.width_x(i).value(), along_z = grid.width_z(j).value();
                const double wall = (i == 0 || i == 6 ? along_z : 0) + (j == 0 || j == 4 ? along_x : 0);
                const double v = water.rate(i, j).value(), h = water.height(i, j).value();
                all += along_x * along_z * v + c * wall * (h - dt / 2 * v); // the height in the middle of the step
            }
        return all;
    };
    const double before = sum();
    for (int n = 0; n < 3000; ++n) water.step(dt * second);
    CHECK(sum() == Approx(before).epsilon(1e-12));
}

TEST_CASE("columns of unequal footprint come to one level, which holds the same water (hard case W13)", "[water]") {
    Surface water(WaterColumns{3.0 * mps, 1.0 / second}, unequal(6, 5), 2.0 * metre);
    stir(water, 9, 1);
    const auto level = water.volume() / water.grid().area();
    for (int n = 0; n < 3000; ++n) water.step(0.06 * second);
    for (const double h : water.heights()) CHECK(h == Approx(level.value()).epsilon(1e-12));
}

TEST_CASE("damping takes the same in a second, whatever the step (hard case W15)", "[water]") {
    // All columns of a basin that rise alike do not pull at each other: the rate is exp(-gamma t) exactly.
    const ColumnGrid grid(4, 4, 10.0 * metre);
    for (const int steps : {5, 30, 60, 144}) {
        const WaterColumns::In<double> loop(WaterColumns{mps, 1.5 / second}, grid, 0.0 * metre);
        std::vector<double> height(16, 1.0), rate(16, 0.25);
        for (int n = 0; n < steps; ++n) loop.advance(height, rate, 1.0 / steps * second);
        for (const double v : rate) CHECK(v == Approx(0.25 * std::exp(-1.5)).epsilon(1e-13));
    }
}

TEST_CASE("columns do as a plain model of two passes does, and as their mirror image does", "[water]") {
    const auto grid = unequal(6, 5);
    const double c = 2, gamma = 0.2, dt = 0.1;
    for (const Wall wall : {Wall::reflects, Wall::holds}) {
        Surface water(WaterColumns{c * mps, gamma / second, Walls::all(wall)}, grid, 2.0 * metre);
        stir(water, 21, 0.5);
        std::vector<double> h(water.heights().begin(), water.heights().end()), v(h.size());
        auto width = [&](std::size_t i) { return grid.width_x(i).value(); };
        auto length = [&](std::size_t j) { return grid.width_z(j).value(); };
        for (int n = 0; n < 50; ++n) {
            for (std::size_t j = 0; j < 5; ++j)
                for (std::size_t i = 0; i < 6; ++i) {
                    double in = 0; // c^2 times slope times width of each face
                    const double me = h[grid.index(i, j)];
                    auto from = [&](bool there, std::size_t other, double face, double apart, double mine) {
                        if (there) in += face * (h[other] - me) / apart;
                        else if (wall == Wall::holds) in += face * (2 - me) / (0.5 * mine);
                    };
                    const std::size_t at = grid.index(i, j);
                    from(i > 0, at - 1, length(j), i > 0 ? 0.5 * (width(i) + width(i - 1)) : 1, width(i));
                    from(i < 5, at + 1, length(j), i < 5 ? 0.5 * (width(i) + width(i + 1)) : 1, width(i));
                    from(j > 0, at - 6, width(i), j > 0 ? 0.5 * (length(j) + length(j - 1)) : 1, length(j));
                    from(j < 4, at + 6, width(i), j < 4 ? 0.5 * (length(j) + length(j + 1)) : 1, length(j));
                    v[at] = (v[at] + dt * c * c * in / (width(i) * length(j))) * std::exp(-gamma * dt);
                }
            for (std::size_t k = 0; k < h.size(); ++k) h[k] += dt * v[k];
            water.step(dt * second);
        }
        for (std::size_t k = 0; k < h.size(); ++k) CHECK(water.heights()[k] == Approx(h[k]).epsilon(1e-12));
    }
}
