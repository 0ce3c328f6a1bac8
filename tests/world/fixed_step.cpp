// SPDX-License-Identifier: BSL-1.0
// FixedStep: whole steps out of uneven frames, nothing lost, and no spiral (hard case I24).

#include <ansatz/world/fixed_step.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <cmath>
#include <limits>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {
struct Counter {
    std::uint64_t steps = 0;
    Quantity<unit::Time> dt{};
    void step(const Quantity<unit::Time>& h) {
        ++steps;
        dt = h;
    }
};
} // namespace

TEST_CASE("a frame of a quarter of a second is exactly fifteen steps of a sixtieth", "[world][fixed_step][I24]") {
    Counter counter;
    FixedStep clock(1.0 / 60 * second);
    CHECK(clock.advance(counter, 0.25 * second) == 15);
    CHECK(counter.steps == 15);
    CHECK(counter.dt == 1.0 / 60 * second);
    CHECK(clock.alpha() == 0);
    CHECK(clock.dropped() == 0.0 * second);
}

TEST_CASE("a spike of a whole number of steps is that number, however the division rounds",
          "[world][fixed_step][I24]") {
    Counter counter;
    bool all = true;
    for (const int rate : {10, 24, 25, 30, 50, 60, 75, 90, 100, 120, 144, 240})
        for (int n = 1; n <= 100; ++n) {
            FixedStep clock(1.0 / rate * second, 100.0 / rate * second); // and the clamp is a hundred steps
            all = all && clock.advance(counter, double(n) / rate * second) == std::uint64_t(n) && clock.alpha() == 0;
        }
    CHECK(all);
    CHECK(0.3 / 0.1 < 3); // as it does here, for one
    FixedStep clock(0.1 * second, 0.3 * second);
    CHECK(clock.advance(counter, 0.3 * second) == 3);
}

TEST_CASE("a frame of ten seconds is clamped, what was dropped is told, and the next frame owes nothing",
          "[world][fixed_step][I24]") {
    Counter counter;
    FixedStep clock(1.0 / 60 * second);
    CHECK(clock.advance(counter, 10.0 * second) == 15);
    CHECK(clock.dropped().value() == Catch::Approx(9.75).epsilon(1e-14));
    CHECK(clock.advance(counter, 0.0 * second) == 0); // no spiral
    CHECK(clock.advance(counter, 1.0 / 60 * second) == 1);
    FixedStep patient(1.0 / 60 * second, 1.0 * second);
    CHECK(patient.advance(counter, 10.0 * second) == 60);
    // A program whose every frame takes longer than its steps are worth: it slows down, and does not fall behind.
    FixedStep late(1.0 / 60 * second);
    for (int i = 0; i < 100; ++i) CHECK(late.advance(counter, 0.5 * second) == 15);
    CHECK(late.dropped().value() == Catch::Approx(100 * 0.25).epsilon(1e-13));
}

TEST_CASE("even frames of a step's length are a step each, for a day", "[world][fixed_step][I24]") {
    Counter counter;
    FixedStep clock(1.0 / 60 * second);
    bool each = true;
    for (int i = 0; i < 24 * 3600 * 60; ++i) each = each && clock.advance(counter, 1.0 / 60 * second) == 1;
    CHECK(each);
    CHECK(clock.dropped() == 0.0 * second);
}

TEST_CASE("steps, what is left of one, and what was dropped add up to the time of the frames",
          "[world][fixed_step][I24]") {
    Dice dice(7);
    for (const double dt : {1.0 / 60, 1.0 / 144, 0.01, 0.1}) {
        Counter counter;
        FixedStep clock(dt * second, std::max(0.25, dt) * second);
        double sum = 0, lost = 0; // Kahan's sum, so that the oracle is better than what it judges
        std::uint64_t returned = 0;
        bool between = true;
        for (int i = 0; i < 10'000; ++i) {
            const double frame = i % 1000 == 999 ? dice.number(0, 3) : dice.number(0, 0.04);
            returned += clock.advance(counter, frame * second);
            const double part = frame - lost, total = sum + part;
            lost = (total - sum) - part;
            sum = total;
            between = between && clock.alpha() >= 0 && clock.alpha() < 1;
        }
        INFO("dt = " << dt << " s");
        CHECK(between);
        CHECK(returned == counter.steps);
        // One rounding of a number below 2^9 steps a frame, and the 1e-12 of a step that make a spike whole.
        CHECK(std::abs((double(counter.steps) + clock.alpha()) * dt + clock.dropped().value() - sum) <
              10'000 * (3 * 256 * 0x1p-52 + 1e-12) * dt);
    }
}

TEST_CASE("alpha is where the frame lies between two states", "[world][fixed_step]") {
    Counter counter;
    FixedStep clock(0.25 * second, 1.0 * second);
    std::vector<double> alphas;
    for (int i = 0; i < 4; ++i) {
        clock.advance(counter, 0.3125 * second); // a step and a quarter
        alphas.push_back(clock.alpha());
    }
    CHECK(alphas == std::vector<double>{0.25, 0.5, 0.75, 0});
    CHECK(counter.steps == 5);
}

TEST_CASE("a step, a clamp or a frame that cannot be is refused, and nothing moves", "[world][fixed_step][I24]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    auto text = [](auto&& f) { return sentence<std::invalid_argument>(f); };
    for (const double dt : {nan, inf, -inf, -1.0, 0.0})
        CHECK(text([&] { FixedStep clock(dt * second); }).find("FixedStep: dt is " + describe(dt * second) + "; ") ==
              0);
    for (const double longest : {nan, inf, -1.0, 0.0, 0.01})
        CHECK(text([&] {
                  FixedStep clock(0.02 * second, longest * second);
              }).find("FixedStep: longest is " + describe(longest * second)) == 0);
    World world{SemiImplicitEuler{}, Gravity{}};
    const auto body = world.add();
    FixedStep clock(1.0 / 64 * second);
    clock.advance(world, 0.0234375 * second); // a step and a half
    const auto before = world.hash();
    for (const double frame : {nan, inf, -inf, -1e-300}) {
        const auto refusal = text([&] { clock.advance(world, frame * second); });
        CHECK(refusal.find("FixedStep::advance: frame_time is " + describe(frame * second) + "; ") == 0);
        CHECK(world.hash() == before);
        CHECK(clock.alpha() == 0.5);
    }
    CHECK(world.position(body).value()[1] < 0);
}

TEST_CASE("frames and clamps of astronomical length are taken like any other", "[world][fixed_step]") {
    Counter counter;
    FixedStep clock(1e-3 * second, 0.01 * second);
    CHECK(clock.advance(counter, 1e308 * second) == 10); // more steps than a double can count
    CHECK(clock.alpha() == 0);
    CHECK(clock.advance(counter, 0.0015 * second) == 1);
    CHECK(clock.alpha() == Catch::Approx(0.5));
    FixedStep unclamped(1e-3 * second, 1e300 * second);
    CHECK(unclamped.advance(counter, 2.0 * second) == 2000);
}

TEST_CASE("a world driven by frames is the world stepped by hand", "[world][fixed_step]") {
    World driven{SemiImplicitEuler{}, Gravity{}};
    driven.add(velocity(metres_per_second(1, 2, 3)));
    auto stepped = driven;
    FixedStep clock(1.0 / 60 * second);
    std::uint64_t steps = 0;
    for (int i = 0; i < 50; ++i) steps += clock.advance(driven, (0.005 + 0.001 * (i % 13)) * second);
    for (std::uint64_t i = 0; i < steps; ++i) stepped.step(1.0 / 60 * second);
    CHECK(driven.hash() == stepped.hash());
    CHECK(driven.tick() == steps);
}

TEST_CASE("a push before each step is the same on every screen, and every step's events can be read",
          "[world][fixed_step]") {
    auto height_after_two_seconds = [](int pictures) {
        World world{SemiImplicitEuler{}, Gravity{}, AppliedForces{}};
        const auto rocket = world.add(mass(1.0 * kilogram));
        FixedStep clock(1.0 / 60 * second);
        int calls = 0;
        std::uint64_t steps = 0;
        for (int frame = 0; frame < 2 * pictures; ++frame)
            steps += clock.advance(world, 1.0 / pictures * second, [&](auto& w) {
                w.apply_force(rocket, newtons(0, 15, 0));
                ++calls;
            });
        CHECK(calls == 120);
        CHECK(steps == 120);
        return y(world.position(rocket));
    };
    const auto at60 = height_after_two_seconds(60);
    for (const int pictures : {24, 30, 75, 120, 144}) CHECK(height_after_two_seconds(pictures) == at60);

    World sleepy{SemiImplicitEuler{}, Rest{}};
    sleepy.add();
    FixedStep clock(1.0 / 60 * second, 1.0 * second);
    std::size_t slept = 0;
    clock.advance(sleepy, 40.0 / 60 * second, [&](const auto& w) { slept += w.events().size(); });
    CHECK(slept == 1);
}

TEST_CASE("a world that refuses the step leaves the clock as it was", "[world][fixed_step]") {
    World<Space<float, 2>, SemiImplicitEuler> world{Space<float, 2>{}, SemiImplicitEuler{}};
    FixedStep clock(1e-60 * second, 1e-59 * second); // no float
    clock.advance(world, 0.5e-60 * second);
    CHECK_THROWS_AS(clock.advance(world, 1.25e-60 * second), std::invalid_argument);
    CHECK(clock.alpha() == 0.5);
}

TEST_CASE("a clock whose frames would never end is refused", "[world][fixed_step][I21]") {
    struct Counts {
        std::uint64_t steps = 0;
        void step(const Quantity<unit::Time>&) {
            if (++steps > 1000) throw std::runtime_error("it does not end");
        }
    };
    for (const double dt : {5e-324, 1e-320, 1e-300, 1e-100, 1e-15, 2e-10}) {
        const auto sentence = test::refusal([&] { FixedStep clock(dt * second); });
        CHECK(sentence.find("FixedStep: dt is " + describe(dt * second)) == 0);
        CHECK(sentence.find("2.5e-10 s") != std::string::npos); // the shortest, within a clamp of a quarter of a second
        // With a clamp of its own it is a clock like another.
        FixedStep clock(dt * second, 3 * dt * second);
        Counts world;
        CHECK(clock.advance(world, 1.0 * second) == 3);
        CHECK(world.steps == 3);
        CHECK(clock.advance(world, 0.0 * second) == 0);
        CHECK(is_finite(clock.dropped()));
    }
    CHECK_NOTHROW(FixedStep(2.51e-10 * second));
    // A clamp that never acts leaves it to the frame.
    FixedStep clock(1.0 / 60 * second, 1e300 * second);
    Counts world;
    CHECK(clock.advance(world, 1.0 / 120 * second) == 0);
    CHECK(test::refusal([&] {
              clock.advance(world, 1e300 * second);
          }).find("FixedStep::advance: frame_time is 1e+300 s; ") == 0);
    CHECK(clock.alpha() == 0.5);
    CHECK(world.steps == 0);
}
