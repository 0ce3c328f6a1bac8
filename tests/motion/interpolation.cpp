// SPDX-License-Identifier: BSL-1.0
// Interpolation: a body is drawn between its last two states, and nowhere else.

#include <ansatz/motion/interpolation.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

using namespace ansatz;
using namespace ansatz::test;

namespace {
template <class W> double drawn(const W& world, Handle body, double alpha) {
    return double(interpolated_position(world, body, alpha).value()[0]);
}
} // namespace

TEMPLATE_TEST_CASE("a body is drawn on the way from its state before the last step to the present one",
                   "[world][interpolation]", SemiImplicitEuler, Verlet, ImplicitEuler) {
    World world{TestType{}, Interpolation{}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(32, 0, 0)));
    for (const double alpha : {0.0, 0.5, 1.0})
        CHECK(drawn(world, body, alpha) == 1); // before the first step: where it is
    for (int i = 0; i < 3; ++i) {
        world.step(1.0 / 64 * second);
        CHECK(drawn(world, body, 0) == 1 + 0.5 * i);
        CHECK(drawn(world, body, 0.25) == 1 + 0.5 * i + 0.125);
        CHECK(drawn(world, body, 1) == 1 + 0.5 * (i + 1));
    }
    const auto before = world;
    world.step(0.0 * second); // nothing happened, nothing changes on the screen
    CHECK(drawn(world, body, 0.25) == drawn(before, body, 0.25));
}

TEMPLATE_TEST_CASE("a teleport is not smeared", "[world][interpolation]", SemiImplicitEuler, Verlet) {
    World world{Space<float, 2>{}, TestType{}, Interpolation{}};
    const auto body = world.add(velocity(metres_per_second(64, 0)));
    world.step(1.0 / 64 * second);
    world.set_position(body, metres(1000, 0));
    for (const double alpha : {0.0, 0.5, 1.0}) CHECK(drawn(world, body, alpha) == 1000);
    world.step(1.0 / 64 * second);
    CHECK(drawn(world, body, 0) == 1000);
    CHECK(drawn(world, body, 0.5) == 1000.5);
}

TEMPLATE_TEST_CASE("a platform is drawn in between as well, a fixed body is where it is", "[world][interpolation]",
                   SemiImplicitEuler, Verlet) {
    World world{TestType{}, Gravity{}, Interpolation{}};
    const auto lift = world.add(velocity(metres_per_second(64, 0, 0)), moving),
               ground = world.add(position(metres(5, 0, 0)), fixed);
    for (int i = 0; i < 2; ++i) world.step(1.0 / 64 * second);
    CHECK(drawn(world, lift, 0) == 1);
    CHECK(drawn(world, lift, 0.5) == 1.5);
    CHECK(drawn(world, ground, 0.5) == 5);
    world.set_position(ground, metres(9, 0, 0));
    CHECK(drawn(world, ground, 0) == 9);
}

TEMPLATE_TEST_CASE("a resting body is drawn where it lies, also when it has just woken", "[world][interpolation]",
                   SemiImplicitEuler, Verlet) {
    World world{TestType{}, AppliedForces{}, Rest{4.0 * metre_per_second, 0.0 * second}, Interpolation{}};
    const auto body = world.add(velocity(metres_per_second(2, 0, 0)),
                                mass(1.0 * kilogram)); // slow enough to sleep at once, a step further
    world.step(1.0 / 64 * second);
    REQUIRE(world.motion(body) == Motion::resting);
    const double place = world.position(body).value()[0];
    REQUIRE(place == 2.0 / 64);
    for (const double alpha : {0.0, 0.5, 1.0}) CHECK(drawn(world, body, alpha) == place);
    for (int i = 0; i < 3; ++i) world.step(1.0 / 64 * second);
    SECTION("woken between steps") {
        world.wake(body);
        for (const double alpha : {0.0, 0.5, 1.0}) CHECK(drawn(world, body, alpha) == place);
    }
    SECTION("pushed, and drawn after the step") {
        world.set_velocity(body, metres_per_second(64, 0, 0));
        CHECK(drawn(world, body, 0) == place);
        world.step(1.0 / 64 * second);
        CHECK(drawn(world, body, 0) == place);
        CHECK(drawn(world, body, 1) == place + 1);
    }
}

TEST_CASE("a body that wakes within a step is drawn from where it lay", "[world][interpolation]") {
    World world{SemiImplicitEuler{}, Nothing{}, Later{4.5 / 64 * second}, Rest{4.0 * metre_per_second, 0.0 * second},
                Interpolation{}};
    const auto body = world.add(velocity(metres_per_second(2, 0, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 5; ++i) world.step(1.0 / 64 * second);
    REQUIRE(world.motion(body) == Motion::resting);
    const double place = world.position(body).value()[0];
    world.step(1.0 / 64 * second);
    REQUIRE(world.motion(body) == Motion::awake);
    CHECK(world.position(body).value()[0] > place);
    CHECK(drawn(world, body, 0) == place);
}

TEST_CASE("a body that is added is drawn where it was added", "[world][interpolation]") {
    World world{SemiImplicitEuler{}, Interpolation{}};
    world.remove(world.add(position(metres(99, 0, 0)))); // its slot and id are used again
    const auto body = world.add(position(metres(7, 0, 0)));
    CHECK(drawn(world, body, 0) == 7);
}
