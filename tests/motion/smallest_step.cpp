// SPDX-License-Identifier: BSL-1.0
// Steps that are too short (hard case I21): whatever the step, a world takes it and keeps what it knows, or refuses it
// and is as it was; and the sentence of a refusal names a step that is taken.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/motion/smallest_step.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

using namespace ansatz;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Takes steps, or answers with the refusal of the first of them.
template <class W> std::optional<std::string> refused(W& world, double dt, int steps = 3) {
    const auto before = world.hash();
    try {
        for (int i = 0; i < steps; ++i) world.step(dt * second);
    } catch (const std::invalid_argument& e) {
        CHECK(world.hash() == before);
        return e.what();
    }
    return std::nullopt;
}
double along_x(const auto& world, Handle body) { return double(world.velocity(body).value()[0]); }
/// The number that a sentence ends with, in s.
double named_by(const std::string& sentence) {
    const auto at = sentence.rfind("at least ");
    return at == std::string::npos ? 0 : std::stod(sentence.substr(at + 9));
}
const double steps[] = {1.0 / 60, 1e-3,  1e-4,  1e-6,   1e-8,   1e-10,  1e-12,  1e-14,  1e-18,  1e-25,  1e-30, 1e-33,
                        1e-37,    1e-40, 1e-44, 1e-100, 1e-200, 1e-290, 1e-300, 1e-307, 1e-310, 1e-320, 5e-324};

} // namespace

TEMPLATE_TEST_CASE("a history keeps the velocity, or the step is refused with one that keeps it", "[world][step][I21]",
                   double, float) {
    const bool wide = sizeof(TestType) == 8;
    const double epsilon = double(std::numeric_limits<TestType>::epsilon());
    for (const bool platform : {false, true})
        for (const bool second_step : {false, true})
            for (const double x : {0.0, 0.3, 10.0, 5000.0})
                for (const double v : {2e-3, 1.0, 300.0})
                    for (const double dt : steps) {
                        World world{Space<TestType, 2>{}, Verlet{}};
                        auto add = [&](auto... more) {
                            return world.add(position(metres(x, -x)), velocity(metres_per_second(v, v / 2)), more...);
                        };
                        const auto body = platform ? add(moving) : add();
                        if (second_step) world.step(1.0 / 60 * second);
                        const double before = along_x(world, body); // a longer step has its own rounding
                        const auto sentence = refused(world, dt);
                        CAPTURE(platform, second_step, x, v, dt, sentence.value_or("taken"));
                        if (!sentence) {
                            REQUIRE(world.status().ok());
                            // What is lost in each of three steps; steps longer than those that are tested have
                            // their own rounding.
                            const double rounding = 100 * dt * dt < epsilon ? 0 : epsilon * x / dt;
                            REQUIRE(std::abs(along_x(world, body) - before) <= 3e-3 * v + 3 * rounding + 1e-5 * v);
                        } else if (const double enough = named_by(*sentence); enough > 0) {
                            REQUIRE(enough > dt);
                            REQUIRE_FALSE(refused(world, enough * 1.001, 1));
                            REQUIRE(std::abs(along_x(world, body) - before) <= 2e-3 * v);
                        } else // no number of the scalar at all
                            REQUIRE((!wide && dt < 1e-45));
                        if (dt > 1e-4 || (wide && dt > 2e-9)) REQUIRE_FALSE(sentence);
                    }
}

namespace {
template <class W> void takes_no_harm(const W& empty) {
    constexpr double epsilon = double(std::numeric_limits<typename W::Scalar>::epsilon());
    for (const double dt : steps) {
        auto world = empty;
        world.add(Plane::ground(), fixed);
        Handle last{};
        auto ball = [&](const auto& x) {
            return world.add(Sphere{0.5 * metre}, x, velocity(metres_per_second(1, 0)), mass(1.0 * kilogram));
        };
        for (int i = 0; i < 3; ++i) last = ball(position(metres(0.01 * i, 0.5 + 0.98 * i)));
        const auto flying = ball(position(metres(100, 100)));
        const auto sentence = refused(world, dt);
        CAPTURE(dt, sentence.value_or("taken"));
        if (sentence) {
            REQUIRE(dt < 1.4e-4);
            continue;
        }
        REQUIRE(world.status().ok());
        // Steps that are not tested have their own rounding.
        const bool history_of_old = W::composition::history && 100 * dt * dt >= 16 * epsilon; // in four substeps
        REQUIRE(std::abs(along_x(world, flying) - 1) <= 4e-3 + (history_of_old ? 300 * epsilon / dt : 0));
        REQUIRE(std::abs(along_x(world, last)) < 10);
    }
}
} // namespace

TEST_CASE("no step is so short that a pile becomes infinite or loses its velocity", "[world][step][I21]") {
    takes_no_harm(World{Space<double, 2>{}, SemiImplicitEuler{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Plane>{},
                        SoftSubsteps<Friction>{}});
    takes_no_harm(
        World{Space<float, 2>{}, Verlet{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}});
    takes_no_harm(World{Space<float, 2>{}, ImplicitEuler{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Plane>{},
                        Impulse{}, Projection{}});
}

TEST_CASE("an integrator that keeps the velocity takes a step in which nothing moves", "[world][step][I21]") {
    World world{Space<float, 3>{}, SemiImplicitEuler{}};
    const auto body = world.add(position(metres(1000, 0, 0)), velocity(metres_per_second(1, 0, 0)));
    world.step(1e-30 * second);
    CHECK(world.position(body) == scalar_cast<float>(metres(1000, 0, 0)));
    world.step(1.0 * second);
    CHECK(world.position(body) == scalar_cast<float>(metres(1001, 0, 0)));
    CHECK_THAT(test::refusal([&] { world.step(1e-40 * second); }), ContainsSubstring("World::step: dt is 1e-40 s; "));
    CHECK_THAT(test::refusal([&] { world.step(1e-40 * second); }), ContainsSubstring("at least"));
}
