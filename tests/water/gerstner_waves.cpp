// SPDX-License-Identifier: BSL-1.0
// Waves whose points go on circles: the height at a place is that of the point that is there, up to steep crests.

#include <ansatz/water/gerstner_waves.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
Waves sea(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> length(2, 40), angle(-3, 3);
    std::vector<Wave> waves;
    for (std::size_t n = 0; n < count; ++n) {
        const double wavelength = length(random);
        waves.push_back({wavelength * metre, wavelength / 30 * metre, angle(random), angle(random)});
    }
    return Waves(waves);
}
} // namespace

TEST_CASE("the height at a place is that of the point that is there now, to 1e-6 m up to a steepness of 0.9",
          "[water]") {
    for (const std::size_t count : {1U, 4U, 12U})
        for (const double steepness : {0.0, 0.3, 0.7, 0.9, 0.99}) {
            const GerstnerWaves waves(sea(count, unsigned(count)), steepness);
            std::mt19937 random(7);
            std::uniform_real_distribution<double> place(-100, 100);
            for (int n = 0; n < 300; ++n) {
                const auto x0 = place(random) * metre, z0 = place(random) * metre;
                const auto t = 0.1 * double(n) * second;
                const auto point = waves.position(x0, z0, t);
                const double off = abs(waves.height(x(point), z(point), t) - y(point)).value();
                CHECK(off <= (steepness <= 0.9 ? 1e-6 : 1e-5));
                if (steepness <= 0.9)
                    CHECK(norm(waves.rest(x(point), z(point), t) - vector_of(x0, z0)).value() <= 1e-6);
            }
        }
}

TEST_CASE("below a steepness of 1 the surface does not run through itself (hard case W11)", "[water]") {
    // One wave along x: places must follow each other as their rests do. And its crest is where it should be.
    const Waves one({{10.0 * metre, 0.5 * metre}});
    for (const double steepness : {0.9, 1.0}) {
        const GerstnerWaves waves(one, steepness);
        double before = -1e9;
        for (double x0 = -15; x0 < 15; x0 += 0.01) {
            const double now = x(waves.position(x0 * metre, 0.0 * metre, 0.0 * second)).value();
            CHECK(now >= before);
            before = now;
        }
        CHECK(waves.height(0.0 * metre, 0.0 * metre, 0.0 * second).value() == Approx(0.5));
        CHECK(waves.height(5.0 * metre, 0.0 * metre, 0.0 * second).value() == Approx(-0.5));
    }
}

TEST_CASE("crests are narrower than troughs, and at steepness 0 all is a sum of sines", "[water]") {
    const auto waves = sea(5, 5);
    const GerstnerWaves flat(waves, 0);
    for (double x = 0; x < 20; x += 1.1)
        CHECK(flat.height(x * metre, 2.0 * metre, 3.0 * second).value() ==
              Approx(waves.height(x * metre, 2.0 * metre, 3.0 * second).value()).margin(1e-14));
    const GerstnerWaves steep(Waves({{10.0 * metre, 0.5 * metre}}), 0.8);
    int above = 0, all = 0;
    for (double x = 0; x < 10; x += 0.01, ++all)
        above += steep.height(x * metre, 0.0 * metre, 0.0 * second) > 0.0 * metre ? 1 : 0;
    // Above zero is a half of the points at rest, moved together by 2 Q A, and Q A = 0.8 / k.
    CHECK(above / double(all) == Approx(0.5 - 2 * 0.8 / (2 * pi)).margin(2e-3));
}

TEST_CASE("its normal and its velocity are those of the surface", "[water]") {
    const GerstnerWaves waves(sea(6, 2), 0.7);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-50, 50);
    for (int n = 0; n < 100; ++n) {
        const double at_x = place(random), at_z = place(random), e = 1e-5, t = 1.3;
        auto h = [&](double dx, double dz, double dt) {
            return waves.height((at_x + dx) * metre, (at_z + dz) * metre, (t + dt) * second).value();
        };
        const double by_x = (h(e, 0, 0) - h(-e, 0, 0)) / (2 * e), by_z = (h(0, e, 0) - h(0, -e, 0)) / (2 * e),
                     by_t = (h(0, 0, e) - h(0, 0, -e)) / (2 * e);
        const Vector<double, 3> up = Vector<double, 3>(-by_x, 1, -by_z).normalized();
        CHECK((waves.normal(at_x * metre, at_z * metre, t * second) - up).norm() < 1e-6);
        // A point of the surface stays on it.
        const auto v = waves.velocity(at_x * metre, at_z * metre, t * second).value();
        CHECK(v[1] == Approx(by_t + v[0] * by_x + v[2] * by_z).margin(1e-6));
    }
}

TEST_CASE("steepness beyond 1 is refused", "[water]") {
    const auto waves = sea(2, 1);
    for (const double steepness : {-0.1, 1.1, not_a_number})
        CHECK(refusal([&] { GerstnerWaves(waves, steepness); }).find("GerstnerWaves: steepness is ") == 0);
    CHECK(refusal([&] { GerstnerWaves(waves, 1.5); }) ==
          "GerstnerWaves: steepness is 1.5; it is from 0 (sines) to 1 (crests with an edge)");
    CHECK(GerstnerWaves(Waves({}), 0.5).height(1.0 * metre, 1.0 * metre, 1.0 * second) == 0.0 * metre);
}
