// SPDX-License-Identifier: BSL-1.0
// Sums of sines: dispersion, heights, normals, the water below, and whole maps at once.

#include <ansatz/water/dispersion.hpp>
#include <ansatz/water/water_columns.hpp>
#include <ansatz/water/waves.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
std::vector<Wave> sea(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> length(2, 40), angle(-3, 3);
    std::vector<Wave> waves;
    for (std::size_t n = 0; n < count; ++n) {
        const double wavelength = length(random);
        waves.push_back({wavelength * metre, wavelength / 100 * metre, angle(random), angle(random)});
    }
    return waves;
}
} // namespace

TEST_CASE("waves run as their length says (hard case W10)", "[water]") {
    CHECK(water::period(10.0 * metre).value() == Approx(2.53079).margin(1e-5));
    CHECK(water::phase_speed(10.0 * metre).value() == Approx(3.95134).margin(1e-5));
    CHECK(water::group_speed(10.0 * metre) == 0.5 * water::phase_speed(10.0 * metre));
    // Long against the depth: sqrt(g d), crests and groups alike.
    CHECK(water::phase_speed(1e4 * metre, 2.0 * metre).value() == Approx(std::sqrt(9.81 * 2)).epsilon(1e-6));
    CHECK(water::group_speed(1e4 * metre, 2.0 * metre).value() == Approx(std::sqrt(9.81 * 2)).epsilon(1e-5));
    // A group runs at d omega / d k.
    for (const double length : {1.0, 5.0, 30.0, 500.0})
        for (const double depth : {0.5, 4.0, 1000.0}) {
            const double k = 2 * pi / length, h = 1e-5 * k;
            auto omega = [&](double n) { return water::angular_frequency(2 * pi / n * metre, depth * metre).value(); };
            CHECK(water::group_speed(length * metre, depth * metre).value() ==
                  Approx((omega(k + h) - omega(k - h)) / (2 * h)).epsilon(1e-6));
        }
    // Measured on the surface itself: crossings of zero along x, and in time.
    const Waves one({{10.0 * metre, 0.3 * metre}});
    auto crossings = [](auto&& f, double until) {
        std::vector<double> at;
        for (double s = 0; s < until; s += 0.001)
            if (f(s) < 0 && f(s + 0.001) >= 0) at.push_back(s + 0.001 * f(s) / (f(s) - f(s + 0.001)));
        return (at.back() - at.front()) / double(at.size() - 1);
    };
    CHECK(crossings([&](double x) { return one.height(x * metre, 0.0 * metre, 0.0 * second).value(); }, 65) ==
          Approx(10).epsilon(1e-6));
    CHECK(crossings([&](double t) { return one.height(0.0 * metre, 0.0 * metre, t * second).value(); }, 15) ==
          Approx(2.53079).epsilon(1e-5));
}

TEST_CASE("the sum of two waves is their sum, and each runs where it is told", "[water]") {
    const Wave east{8.0 * metre, 0.2 * metre, 0.0, 0.4}, north{5.0 * metre, 0.1 * metre, pi / 2, 1.0};
    const Waves both({east, north}), first({east}), second_({north});
    for (const double x : {0.0, 1.3, -7.0})
        for (const double z : {0.5, 4.0}) {
            const auto at_x = x * metre, at_z = z * metre;
            const auto t = 1.7 * second;
            CHECK(both.height(at_x, at_z, t).value() ==
                  Approx((first.height(at_x, at_z, t) + second_.height(at_x, at_z, t)).value()).margin(1e-15));
            // A second later the same crest is c further on, in its direction.
            const auto c = water::phase_speed(8.0 * metre), c2 = water::phase_speed(5.0 * metre);
            CHECK(first.height(at_x + c * (1.0 * second), at_z, t + 1.0 * second).value() ==
                  Approx(first.height(at_x, at_z, t).value()).margin(1e-13));
            CHECK(second_.height(at_x, at_z + c2 * (1.0 * second), t + 1.0 * second).value() ==
                  Approx(second_.height(at_x, at_z, t).value()).margin(1e-13));
        }
    CHECK(Waves({}).height(1.0 * metre, 2.0 * metre, 3.0 * second) == 0.0 * metre);
}

TEST_CASE("normals are those of the surface (hard case W11)", "[water]") {
    const Waves waves(sea(8, 3));
    for (double x = -5; x < 5; x += 0.7)
        for (double z = -5; z < 5; z += 0.9) {
            const auto t = 2.5 * second;
            const auto zero_z = z * metre;
            const double e = 1e-5;
            auto y = [&](double dx, double dz) {
                return waves.height((x + dx) * metre, zero_z + dz * metre, t).value();
            };
            const Vector<double, 3> n(-(y(e, 0) - y(-e, 0)) / (2 * e), 1, -(y(0, e) - y(0, -e)) / (2 * e));
            CHECK((waves.normal(x * metre, z * metre, t) - n.normalized()).norm() < 1e-8);
        }
}

TEST_CASE("below the surface water is neither made nor turned, rises with the surface and rests on the ground",
          "[water]") {
    for (const double depth : {1.5, 20.0, water::bottomless}) {
        const Waves waves(sea(5, 9), depth * metre);
        auto v = [&](double x, double y, double z, double t) {
            return waves.velocity(x * metre, y * metre, z * metre, t * second).value();
        };
        const double e = 1e-5, x = 1.2, y = -0.7, z = 0.4, t = 3.1;
        const Vector<double, 3> by_x = (v(x + e, y, z, t) - v(x - e, y, z, t)) / (2 * e),
                                by_y = (v(x, y + e, z, t) - v(x, y - e, z, t)) / (2 * e),
                                by_z = (v(x, y, z + e, t) - v(x, y, z - e, t)) / (2 * e);
        CHECK(std::abs(by_x[0] + by_y[1] + by_z[2]) < 1e-8);
        CHECK(std::abs(by_x[1] - by_y[0]) < 1e-8);
        CHECK(std::abs(by_y[2] - by_z[1]) < 1e-8);
        CHECK(std::abs(by_z[0] - by_x[2]) < 1e-8);
        const double rise = (waves.height(x * metre, z * metre, (t + e) * second) -
                             waves.height(x * metre, z * metre, (t - e) * second))
                                .value() /
                            (2 * e);
        CHECK(v(x, 0, z, t)[1] == Approx(rise).epsilon(1e-7));
        // Newton's law at the surface: along x the water is pushed by g times the slope.
        const double push = -9.81 *
                            (waves.height((x + e) * metre, z * metre, t * second) -
                             waves.height((x - e) * metre, z * metre, t * second))
                                .value() /
                            (2 * e);
        CHECK((v(x, 0, z, t + e)[0] - v(x, 0, z, t - e)[0]) / (2 * e) == Approx(push).epsilon(1e-7));
        if (depth < 1e300) CHECK(std::abs(v(x, -depth, z, t)[1]) < 1e-15);
        else CHECK(v(x, -100, z, t).norm() < 1e-4);
    }
}

TEMPLATE_TEST_CASE("a whole map at once has the heights of each of its points", "[water]", float, double) {
    const auto waves = sea(16, 21);
    const Waves sum(waves, 8.0 * metre);
    double amplitudes = 0, largest = 0; // m; 1/m
    for (const Wave& w : waves) amplitudes += w.amplitude.value();
    for (const auto& term : sum.terms()) largest = std::max(largest, term.k);
    const double bound = std::is_same_v<TestType, float> ? 1.3e-6 : 1e-13;
    for (const std::size_t nx : {200001U, 512U, 61U, 7U}) { // also what is no multiple of what is done abreast
        std::vector<TestType> heights(nx * 5, TestType(7));
        sum.fill(std::span<TestType>(heights), nx, 5, 100.0 * metre, -50.0 * metre, 0.25 * metre, 0.5 * metre,
                 1234.5 * second);
        double most = 0;
        for (std::size_t j = 0; j < 5; ++j)
            for (std::size_t i = 0; i < nx; ++i) {
                const auto x = (100 + 0.25 * double(i)) * metre, z = (-50 + 0.5 * double(j)) * metre;
                most =
                    std::max(most, std::abs(double(heights[j * nx + i]) - sum.height(x, z, 1234.5 * second).value()));
            }
        // At the end of the long row a phase has so many radians that it is itself known to some roundings of it.
        const double rounding =
            nx > 512 ? 2 * std::numeric_limits<double>::epsilon() * largest * (100 + 0.25 * double(nx)) : 0.0;
        CHECK(most <= (bound + rounding) * amplitudes);
    }
    const auto map = sum.height_map<TestType>(9, 4, 0.5 * metre, 1.0 * metre, 2.0 * second);
    CHECK(double(map(8, 3).value()) ==
          Approx(sum.height(4.0 * metre, 3.0 * metre, 2.0 * second).value()).margin(bound * amplitudes));
}

TEST_CASE("two surfaces add: waves on top of columns leave the columns what they hold (hard case W3)", "[water]") {
    // 8 m by 5 m: whole wavelengths fit, so that what runs over the columns adds no water.
    const ColumnGrid grid(16, 10, 0.5 * metre);
    Surface water(WaterColumns{3.0 * mps}, grid, 2.0 * metre);
    set_heights(water, [](double x, double z) { return 2 + 0.1 * std::sin(x) * std::cos(z); });
    auto twin = water;
    const double before = water.volume().value();
    const Waves waves({{4.0 * metre, 0.2 * metre, 0.0, 0.4}, {2.5 * metre, 0.1 * metre, pi / 2, 1.0}});
    std::vector<double> on_top(grid.size());
    for (int n = 1; n <= 100; ++n) {
        const auto t = 0.02 * n * second;
        water.step(0.02 * second);
        twin.step(0.02 * second);
        waves.fill(std::span<double>(on_top), 16, 10, grid.centre_x(0), grid.centre_z(0), 0.5 * metre, 0.5 * metre, t);
        for (std::size_t k = 0; k < grid.size(); ++k) {
            const auto x = grid.centre_x(k % 16), z = grid.centre_z(k / 16);
            on_top[k] += water.heights()[k];
            CHECK(on_top[k] == Approx((water.level(x, z) + waves.height(x, z, t)).value()).epsilon(1e-12));
        }
        CHECK(grid.volume(std::span<const double>(on_top)).value() == Approx(before).epsilon(1e-12));
    }
    CHECK(water.state() == twin.state());
}

TEST_CASE("a wave refuses what it cannot have, and says which one it is", "[water]") {
    const Wave good{2.0 * metre, 0.1 * metre};
    CHECK(refusal([&] {
              Waves({good, {0.0 * metre, 0.1 * metre}});
          }) == "Waves: wave 1: wavelength is 0 m; it must be finite and greater than zero");
    CHECK(refusal([&] {
              Waves({{2.0 * metre, -0.1 * metre}});
          }) == "Waves: wave 0: amplitude is -0.1 m; it must be finite and not negative");
    CHECK(refusal([&] {
              Waves({{2.0 * metre, 0.1 * metre, not_a_number}});
          }) == "Waves: wave 0: direction is nan; it must be finite, in radians");
    CHECK(refusal([&] { Waves({good}, 0.0 * metre); }) ==
          "water: depth is 0 m; it must be greater than zero, or infinite");
    CHECK(refusal([&] { Waves({good}, 1.0 * metre, 0.0 * metre_per_second_squared); }) ==
          "water: gravity is 0 m/s^2; it must be finite and greater than zero");
    CHECK(refusal([] { Waves({}, 1.0 * metre, -9.81 * metre_per_second_squared); }) ==
          "Waves: gravity is -9.81 m/s^2; it must be finite and greater than zero");
    const auto too_short = refusal([&] { Waves({{1e-310 * metre, 0.1 * metre}}); });
    CHECK(too_short.find("wavelength is ") != std::string::npos);
    CHECK(too_short.find("2 pi over it must be a finite number") != std::string::npos);
    std::vector<float> five(5);
    CHECK(refusal([&] {
              Waves({good}).fill(std::span<float>(five), 3, 2, 0.0 * metre, 0.0 * metre, 1.0 * metre, 1.0 * metre,
                                 0.0 * second);
          }) == "Waves::fill: the number of heights is 5; there is one for each of the 6 points");
}
