// SPDX-License-Identifier: BSL-1.0
// Bodies of infinite mass: platforms, which go where they are told to, and fixed ones.

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a platform goes where its velocity takes it, and nothing pulls, slows or stops it", "[world]",
                   SemiImplicitEuler, Verlet, ImplicitEuler) {
    World world{TestType{}, Gravity{}, Drag{0.5 / second}, AppliedForces{}, Rest{}};
    const auto lift = world.add(position(metres(0, 1, 0)), velocity(metres_per_second(0, 0.5, 0)), moving);
    const auto still =
        world.add(position(metres(3, 1, 0)), moving); // slower than the threshold of Rest, and a platform all the same
    const auto body = world.add(mass(1.0 * kilogram));
    for (int i = 0; i < 128; ++i) {
        world.apply_force(lift, newtons(1, 1, 1));
        world.apply_impulse(lift, newton_seconds(1, 1, 1));
        world.step(1.0 / 64 * second); // a step whose multiples are exact
    }
    CHECK(world.position(lift) == metres(0, 2, 0));
    CHECK(world.velocity(lift) == metres_per_second(0, 0.5, 0));
    CHECK(world.acceleration(lift) == metres_per_second_squared(0, 0, 0));
    CHECK(world.position(still) == metres(3, 1, 0));
    CHECK(world.motion(still) == Motion::moving);
    CHECK(world.motion(lift) == Motion::moving);
    CHECK(world.inverse_mass(lift).value() == 0);
    CHECK(world.position(body).value()[1] < -10);         // the others fall
    world.set_velocity(lift, metres_per_second(1, 0, 0)); // and it turns when it is told to
    for (int i = 0; i < 64; ++i) world.step(1.0 / 64 * second);
    CHECK(world.position(lift) == metres(1, 2, 0));
    CHECK(world.velocity(lift) == metres_per_second(1, 0, 0));
}

TEMPLATE_TEST_CASE("no physics touches a fixed body", "[world]", SemiImplicitEuler, Verlet, ImplicitEuler) {
    World world{TestType{}, Gravity{}, Drag{0.5 / second}, AppliedForces{}};
    const auto ground = world.add(position(metres(1, 2, 3)), fixed);
    for (int i = 0; i < 10; ++i) {
        world.apply_force(ground, newtons(1e6, 0, 0));
        world.step(1.0 / 60 * second);
    }
    CHECK(same_bits(world.position(ground), metres(1, 2, 3)));
    CHECK(same_bits(world.velocity(ground), metres_per_second(0, 0, 0)));
    CHECK(world.acceleration(ground) == metres_per_second_squared(0, 0, 0));
    world.set_position(ground, metres(4, 5, 6)); // but a program may put it elsewhere, where it stays
    world.step(1.0 / 60 * second);
    CHECK(world.position(ground) == metres(4, 5, 6));
    CHECK(world.velocity(ground) == metres_per_second(0, 0, 0));
}
