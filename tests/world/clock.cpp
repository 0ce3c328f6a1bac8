// SPDX-License-Identifier: BSL-1.0
// The clock counts steps and never sums time (hard case I22).

#include <ansatz/world/clock.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <cmath>
#include <limits>

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a day of sixtieths is right to one unit in the last place, at every step", "[world][clock][I22]",
                   (Space<double, 3>), (Space<float, 2>)) {
    StepClock<TestType> clock;
    const auto dt = TestType::ClockTime::from_value(1.0 / 60);
    bool right = true, forward = true;
    double before = -1;
    for (std::uint64_t n = 1; n <= 24u * 3600 * 60; ++n) {
        clock.advance(dt);
        const double now = clock.now().value(),
                     exact = double(static_cast<long double>(n) / 60); // n / 60 s, rounded once
        right = right && std::abs(now - exact) <= std::nextafter(exact, 1e9) - exact;
        forward = forward && now > before;
        before = now;
    }
    CHECK(right);
    CHECK(forward);
    CHECK(clock.tick() == 24u * 3600 * 60);
    CHECK(clock.now().value() == Catch::Approx(86400.0).epsilon(2e-16));
}

TEST_CASE("a float that summed the same steps would be lost long before", "[world][clock][I22]") {
    // What the clock is there to prevent, as the row of the hard case measures it.
    float sum = 0;
    for (int n = 0; n < 24 * 3600 * 60; ++n) sum += 1.0f / 60;
    CHECK(std::abs(double(sum) - 86400) > 1000);
    // The clock of a world of floats counts in double, and moves on where a float stands still, after 6.07 days.
    StepClock<Space<float, 3>> clock;
    clock.advance(Quantity<unit::Time>(600'000.0 * second));
    const auto late = clock.now();
    clock.advance(Quantity<unit::Time>(1.0 / 60 * second));
    CHECK((clock.now() - late).value() == Catch::Approx(1.0 / 60).epsilon(1e-8));
    CHECK(600'000.0f + 1.0f / 60 == 600'000.0f);
}

TEST_CASE("steps of changing length are added where they change, and counted in between", "[world][clock][I22]") {
    StepClock<Space<>> clock;
    CHECK(clock.now() == 0.0 * second);
    CHECK(clock.last() == 0.0 * second);
    CHECK(clock.tick() == 0);
    for (int i = 0; i < 64; ++i) clock.advance(1.0 / 64 * second);
    for (int i = 0; i < 32; ++i) clock.advance(1.0 / 32 * second);
    CHECK(clock.now() == 2.0 * second); // binary fractions: exactly
    CHECK(clock.tick() == 96);
    CHECK(clock.last() == 1.0 / 32 * second);
    for (int i = 0; i < 1000; ++i) clock.advance((i % 2 == 0 ? 1.0 / 60 : 1.0 / 120) * second);
    // The worst case: each step changes the length, so each adds a rounding of a number below 16.
    CHECK(std::abs(clock.now().value() - (2 + 500.0 / 40)) <= 1000 * 8 * std::numeric_limits<double>::epsilon());
}

TEST_CASE("equal clocks are equal, and each part of them counts", "[world][clock]") {
    StepClock<Space<>> a, b;
    CHECK(a == b);
    a.advance(1.0 * second);
    CHECK_FALSE(a == b);
    b.advance(1.0 * second);
    CHECK(a == b);
    a.advance(1.0 * second);
    b.advance(2.0 * second);
    CHECK_FALSE(a == b);
}

TEMPLATE_TEST_CASE("a world's time is its ticks times dt, in float worlds too", "[world][clock][I22]",
                   (Space<double, 2>), (Space<float, 2>)) {
    World world{TestType{}, SemiImplicitEuler{}};
    for (int n = 1; n <= 3600; ++n) {
        world.step(1.0 / 60 * second);
        REQUIRE(world.time().value() == Catch::Approx(n / 60.0).epsilon(2.3e-16));
        REQUIRE(world.tick() == std::uint64_t(n));
    }
    const auto context = world.context();
    CHECK(context.time() == world.time());
    CHECK(double(context.dt().value()) == Catch::Approx(1.0 / 60).epsilon(1e-7));
}
