// SPDX-License-Identifier: BSL-1.0
// A world is a value: a copy is the snapshot, both go on to the same bits and know nothing of each other.

#include "tests/catch.hpp"
#include "tests/world/lives.hpp"

#include <span>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a world copied at step 30 and run to 60 is the world run to 60, to the bit", "[world][I19]",
                   VelocityVerlet, Verlet, ImplicitEuler) {
    auto world = eventful<Space<>, TestType>();
    live(world, 0, 30);
    REQUIRE(world.count(Motion::resting) > 0); // the copy is taken while some body sleeps and a force waits
    REQUIRE(world.count(Motion::awake) > 1);
    const auto copy_of_30 = world;
    CHECK(same_to_the_bit(copy_of_30, world));

    auto first = copy_of_30;
    live(first, 30, 60);
    CHECK(same_to_the_bit(copy_of_30, world)); // neither knows of the other
    live(world, 30, 60);
    CHECK(same_to_the_bit(first, world));
    CHECK(first.status().ok());
    CHECK(world.tick() == 60);

    auto assigned = world; // assigned over, moved, returned
    assigned = copy_of_30;
    auto third = std::move(assigned);
    live(third, 30, 60);
    CHECK(same_to_the_bit(third, world));
}

TEMPLATE_TEST_CASE("the same life twice gives the same bits, at every single step", "[world][I19]", Verlet) {
    auto once = eventful<Space<float, 2>, TestType>(), again = eventful<Space<float, 2>, TestType>();
    for (int i = 0; i < 60; ++i) {
        live(once, i);
        live(again, i);
        INFO("after step " << i);
        REQUIRE(same_to_the_bit(once, again));
        auto copy = once; // a copy at any step does not disturb, and would do the same
        live(copy, i + 1);
        auto original = once;
        live(original, i + 1);
        REQUIRE(same_to_the_bit(copy, original));
    }
}

TEMPLATE_TEST_CASE("a world whose bodies couple is copied whole as well", "[world][I19]", Verlet, RungeKutta4) {
    World world{TestType{}, Attraction{1.0 * (cubic_metre / (kilogram * second * second))}, AppliedForces{},
                Drag{0.1 / second}};
    for (int i = 0; i < 4; ++i)
        world.add(position(metres(i, i * i, 1)), velocity(metres_per_second(0, 1, -i)), mass((1.0 + i) * kilogram));
    auto run = [](auto& w, int steps) {
        for (int i = 0; i < steps; ++i) w.step(1.0 / 60 * second);
    };
    run(world, 30);
    world.apply_force(world.handles()[2], newtons(1, 2, 3));
    auto copy = world;
    run(world, 30);
    run(copy, 30);
    CHECK(same_to_the_bit(copy, world));
}

TEST_CASE("an order in which bodies were removed and added does not change what becomes of the others", "[world]") {
    // The slots differ, the bodies do not: nothing in a world of single bodies depends on its neighbours.
    World plain{RungeKutta4{}, Gravity{}, Drag{}}, stirred{RungeKutta4{}, Gravity{}, Drag{}};
    const auto a = plain.add(position(metres(1, 2, 3)), velocity(metres_per_second(1, 0, 0)));
    const auto other = stirred.add(), another = stirred.add(fixed);
    const auto b = stirred.add(position(metres(1, 2, 3)), velocity(metres_per_second(1, 0, 0)));
    for (int i = 0; i < 20; ++i) {
        if (i == 5) stirred.remove(other);
        if (i == 9) stirred.add();
        if (i == 11) stirred.remove(another);
        plain.step(1.0 / 60 * second);
        stirred.step(1.0 / 60 * second);
        CHECK(same_bits(plain.position(a), stirred.position(b)));
        CHECK(same_bits(plain.velocity(a), stirred.velocity(b)));
    }
}

TEST_CASE("lanes are what the handles say, slot by slot", "[world]") {
    World world{SemiImplicitEuler{}, Rest{}, Keep<Heat>{}};
    for (int i = 0; i < 7; ++i) world.add(position(metres(i, 10 * i, 100 * i)), with<Heat>(i * joule));
    world.remove(world.handles()[2]);
    world.add(resting, position(metres(9, 90, 900)), with<Heat>(9.0 * joule));
    const auto x = world.lane<Position>(0), z = world.lane<Position>(2);
    const auto heat = world.lane<Heat>();
    REQUIRE(x.size() == world.size());
    REQUIRE(heat.size() == world.size());
    for (std::size_t slot = 0; slot < world.size(); ++slot) {
        const auto h = world.body_at(slot);
        CHECK(world.position(h).value()[0] == x[slot]);
        CHECK(world.position(h).value()[2] == z[slot]);
        CHECK(world.read<Heat>(h).value() == heat[slot]);
    }
}

TEST_CASE("properties that are not given are the origin, zero and awake", "[world]") {
    World world{Space<float, 2>{}, Verlet{}, Keep<Heat, Home>{}};
    const auto body = world.add();
    CHECK(world.position(body).value() == Eigen::Vector2f::Zero());
    CHECK(world.velocity(body).value() == Eigen::Vector2f::Zero());
    CHECK(world.read<Heat>(body).value() == 0);
    CHECK(world.read<Home>(body).value() == Eigen::Vector2f::Zero());
    CHECK(world.motion(body) == Motion::awake);
    CHECK(world.size() == 1);
    CHECK(world.contains(body));
    CHECK(world.time() == 0.0 * second);
    CHECK(world.status().ok());
}
