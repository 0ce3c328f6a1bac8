// SPDX-License-Identifier: BSL-1.0
// Waking: what does it, and that it is no push.

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a body that wakes starts from velocity zero, as exactly as one that was never asleep",
                   "[world][I11]", VelocityVerlet, Verlet, RungeKutta4) {
    // Schemes that are exact under a constant acceleration: x = x0 + g t^2 / 2, from the first step after waking on.
    World world{TestType{}, Gravity{metres_per_second_squared(0, 0, 0)}, AppliedForces{}, Rest{}};
    const auto body = world.add(position(metres(0, 10, 0)), mass(2.0 * kilogram), resting);
    for (int i = 0; i < 5; ++i) world.step(1.0 / 64 * second);
    SECTION("by a policy") { world.set(Gravity{metres_per_second_squared(0, -1, 0)}); }
    SECTION("by hand, under a gravity that acted all the time") {
        World sleeper{TestType{}, Gravity{metres_per_second_squared(0, -1, 0)}, AppliedForces{}, Rest{}};
        REQUIRE(sleeper.add(position(metres(0, 10, 0)), mass(2.0 * kilogram), resting) == body);
        for (int i = 0; i < 5; ++i) sleeper.step(1.0 / 64 * second);
        world = sleeper;
        world.wake(body);
    }
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.velocity(body) == metres_per_second(0, 0, 0)); // waking is no push
    CHECK(world.position(body) == metres(0, 10, 0));
    for (int i = 1; i <= 64; ++i) {
        world.step(1.0 / 64 * second);
        const double t = i / 64.0;
        REQUIRE(world.position(body).value()[1] == Catch::Approx(10 - 0.5 * t * t).epsilon(1e-13));
        REQUIRE(world.velocity(body).value()[1] == Catch::Approx(-t).epsilon(1e-11));
    }
}

TEMPLATE_TEST_CASE("a body that a later force or a neighbour wakes within a step starts from velocity zero as well",
                   "[world][I11]", VelocityVerlet, Verlet) {
    World world{TestType{}, Later{0.5 * second}, Rest{}};
    const auto body = world.add(resting);
    for (int i = 0; i < 96; ++i) world.step(1.0 / 64 * second);
    // 1 m/s^2 from 0.5 s on; VelocityVerlet asks at both ends of a step and sees half of the last one before.
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.position(body).value()[0] == Catch::Approx(0.5).margin(0.5 / 64 + 1e-12));
    World pulled{TestType{}, Attraction{1.0 * (cubic_metre / (kilogram * second * second))}, Rest{}};
    const auto sleeper = pulled.add(mass(1e-6 * kilogram), resting);
    pulled.step(1.0 / 64 * second);
    pulled.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
    pulled.step(1.0 / 64 * second);
    // One step of an acceleration of 1 m/s^2 from rest; it varies by less than a thousandth of itself.
    CHECK(pulled.motion(sleeper) == Motion::awake);
    CHECK(pulled.position(sleeper).value()[0] == Catch::Approx(0.5 / 64 / 64).epsilon(1e-3));
}

TEST_CASE("set and get hold the parameters, and a change of a force or an effect wakes bodies that rest", "[world]") {
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Drag{0.25 / second}, Rest{},
                Keep<Heat>{}};
    const auto body = world.add(resting);
    auto sleeps_on = [&](auto policy) {
        world.set(policy);
        const bool still = world.motion(body) == Motion::resting;
        for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second); // and back to sleep, if nothing pulls
        return still;
    };
    CHECK_FALSE(sleeps_on(Drag{0.75 / second}));
    CHECK(world.get<Drag>().rate == 0.75 / second);
    CHECK(world.motion(body) == Motion::resting);
    CHECK_FALSE(sleeps_on(Rest{0.1 * metre_per_second, 0.25 * second}));
    CHECK(world.get<Rest>().time == 0.25 * second);
    CHECK(sleeps_on(Keep<Heat>{})); // an observer changes nothing
    CHECK(sleeps_on(SemiImplicitEuler{}));
    CHECK_FALSE(sleeps_on(Gravity{metres_per_second_squared(0, -1, 0)}));
    CHECK(world.get<Gravity>().acceleration == metres_per_second_squared(0, -1, 0));
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.position(body).value()[1] < 0);
}

TEST_CASE("every change of a body wakes it, and a query does not", "[world]") {
    World world{SemiImplicitEuler{}, AppliedForces{}, Rest{}, Keep<Heat>{}};
    const auto body = world.add(mass(2.0 * kilogram), resting), other = world.add(mass(2.0 * kilogram), resting);
    auto query = [&] {
        (void)world.position(body), (void)world.velocity(body), (void)world.acceleration(body),
            (void)world.read<Heat>(body), (void)world.row(body);
        (void)world.hash(), (void)world.status(), (void)world.events(), (void)world.mass(body);
    };
    query();
    CHECK(world.motion(body) == Motion::resting);
    SECTION("set_position") { world.set_position(body, metres(1, 0, 0)); }
    SECTION("set_velocity") { world.set_velocity(body, metres_per_second(1, 0, 0)); }
    SECTION("set_mass") { world.set_mass(body, 1.0 * kilogram); }
    SECTION("apply_impulse") { world.apply_impulse(body, newton_seconds(1, 0, 0)); }
    SECTION("apply_force") { world.apply_force(body, newtons(1, 0, 0)); }
    SECTION("write") { world.write<Heat>(body, 1.0 * joule); }
    SECTION("wake") { world.wake(body); }
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.motion(other) == Motion::resting);
}
