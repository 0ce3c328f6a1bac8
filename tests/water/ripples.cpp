// SPDX-License-Identifier: BSL-1.0
// Rings: round, at the speeds of groups and crests, gone after a while, and never more than there is room for.

#include <ansatz/water/ripples.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
double height(const Ripples& rings, double x, double z, double t) {
    return rings.height(x * metre, z * metre, t * second).value();
}
Ripple drop(double x, double z, double begun) { return {.x = x * metre, .z = z * metre, .begun = begun * second}; }
} // namespace

TEST_CASE("a ring is round, and there is nothing before it begins", "[water]") {
    Ripples rings(4);
    rings.begin(drop(1, 2, 3));
    for (const double t : {3.5, 5.0, 8.0})
        for (double angle = 0; angle < 6; angle += 0.7)
            CHECK(height(rings, 1 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), t) ==
                  Approx(height(rings, 3, 2, t)).margin(1e-14));
    CHECK(height(rings, 1, 2, 2.999) == 0);
    CHECK(height(rings, 1, 2, 3) > 0);
}

TEST_CASE("the group runs at the speed of groups, and a crest at its own", "[water]") {
    for (const double depth : {0.05, water::bottomless}) {
        Ripples rings(1, depth * metre);
        auto long_lived = drop(0, 0, 0);
        long_lived.damping = 1e-6 * hertz;
        long_lived.width = 2.0 * metre;
        rings.begin(long_lived);
        const double group = water::group_speed(0.5 * metre, depth * metre).value(),
                     crest = water::phase_speed(0.5 * metre, depth * metre).value();
        auto middle = [&](double t) { // of the energy, without what spreads it
            double above = 0, all = 0;
            for (double r = 0; r < 60; r += 0.01) {
                const double y = height(rings, r, 0, t), weight = y * y * (1 + r / 0.5);
                above += r * weight;
                all += weight;
            }
            return above / all;
        };
        CHECK((middle(40) - middle(20)) / 20 == Approx(group).epsilon(1e-3));
        // The crest that is at r now is at r + c dt a moment later: there is still no slope but what the group gives
        // it.
        const double t = 20, dt = 0.1;
        const auto place = [&](double near, double time) {
            double best = near;
            for (double r = near - 0.1; r < near + 0.1; r += 1e-4)
                if (height(rings, r, 0, time) > height(rings, best, 0, time)) best = r;
            return best;
        };
        const double here = group * t, from = here - std::fmod(here - crest * t, 0.5);
        CHECK((place(from + crest * dt, t + dt) - place(from, t)) / dt == Approx(crest).epsilon(0.02));
    }
}

TEST_CASE("under the moon's gravity rings run slower by its root", "[water]") {
    Ripples here(1), moon(1, water::bottomless * metre, 9.81 / 4 * metre_per_second_squared);
    auto one = drop(0, 0, 0);
    one.damping = 1e-9 * hertz;
    here.begin(one);
    moon.begin(one);
    const auto copy = moon;
    for (double x = 0; x < 4; x += 0.1) {
        CHECK(height(moon, x, 0, 3) == Approx(height(here, x, 0, 1.5)).margin(1e-9));
        CHECK(height(copy, x, 0, 3) == height(moon, x, 0, 3));
    }
}
TEST_CASE("slopes are those of the heights, in the middle too, and rings add", "[water]") {
    Ripples rings(3), first(1), other(1);
    const auto a = drop(0, 0, 0), b = drop(1.5, -1, 0.7);
    rings.begin(a);
    rings.begin(b);
    first.begin(a);
    other.begin(b);
    for (double x = -2; x <= 2; x += 0.5)
        for (double z = -2; z <= 2; z += 0.5) {
            const double e = 1e-5, t = 2.2;
            CHECK(height(rings, x, z, t) == Approx(height(first, x, z, t) + height(other, x, z, t)).margin(1e-16));
            const auto slope = rings.slope(x * metre, z * metre, t * second);
            CHECK(slope[0] == Approx((height(rings, x + e, z, t) - height(rings, x - e, z, t)) / (2 * e)).margin(1e-8));
            CHECK(slope[1] == Approx((height(rings, x, z + e, t) - height(rings, x, z - e, t)) / (2 * e)).margin(1e-8));
        }
}

TEST_CASE("rings fade and are forgotten; the oldest gives way", "[water]") {
    Ripples rings(3);
    for (int n = 0; n < 3; ++n) rings.begin(drop(10.0 * n, 0, n));
    CHECK(rings.size() == 3);
    rings.begin(drop(-10, 0, 3));
    CHECK(rings.size() == 3);
    CHECK(std::abs(height(rings, 0, 0, 3.01)) < 1e-3); // that of second 0 is gone, the new one is there
    CHECK(height(rings, -10, 0, 3) > 0.02);
    const auto copy = rings;
    rings.forget_faded(15.2 * second); // exp(-0.5 tau) is a thousandth after 13.8 s: those of seconds 1
    CHECK(rings.size() == 2);
    rings.forget_faded(1000.0 * second);
    CHECK(rings.size() == 0);
    CHECK(copy.size() == 3);
    CHECK(height(rings, 0, 0, 1000) == 0);
}

TEST_CASE("however far away, late or narrow, a ring has a height that is a number", "[water]") {
    for (const double width : {1e-310, 1e-9, 0.75, 1e9})
        for (const double length : {1e-9, 0.5, 1e9}) {
            Ripples rings(2);
            Ripple ring = drop(0, 0, 0);
            ring.wavelength = length * metre;
            ring.width = width * metre;
            rings.begin(ring);
            for (const double x : {0.0, 3.0, 1e155, 1e300})
                for (const double t : {0.0, 2.0, 1e155, 1e300}) {
                    CHECK(std::isfinite(rings.height(x * metre, x * metre, t * second).value()));
                    CHECK(rings.slope(x * metre, 0.0 * metre, t * second).allFinite());
                }
        }
}
TEST_CASE("a ring refuses what it cannot have", "[water]") {
    Ripples rings(2);
    auto bad = drop(0, 0, 0);
    bad.wavelength = 0.0 * metre;
    CHECK(refusal([&] { rings.begin(bad); }) ==
          "Ripples::begin: wavelength is 0 m; it must be finite and greater than zero");
    bad = drop(0, not_a_number, 0);
    CHECK(refusal([&] { rings.begin(bad); }) == "Ripples::begin: z is nan m; it must be finite");
    bad = drop(0, 0, 0);
    bad.damping = 0.0 * hertz;
    CHECK(refusal([&] { rings.begin(bad); }) ==
          "Ripples::begin: damping is 0 1/s; it must be finite and greater than zero");
    CHECK(rings.size() == 0);
    CHECK(refusal([] { Ripples(0); }) == "Ripples: most is 0; at least 1 ring is kept");
    CHECK(refusal([] { Ripples(SIZE_MAX); }).find("Ripples: most is 18446744073709551615; there is room for ") == 0);
    CHECK(refusal([] { Ripples(1, 2.0 * metre, 0.0 * metre_per_second_squared); }) ==
          "Ripples: gravity is 0 m/s^2; it must be finite and greater than zero");
    CHECK(refusal([] { Ripples(1, -1.0 * metre); }) ==
          "Ripples: depth is -1 m; it must be greater than zero, or infinite");
}
