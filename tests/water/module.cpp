// SPDX-License-Identifier: BSL-1.0
// Water beside collisions and rest: what sinks lies on the ground and sleeps there, what floats collides.

#include <ansatz/collision.hpp>
#include <ansatz/water.hpp>
#include <ansatz/water/module.hpp>
#include <ansatz/world.hpp>

#include "tests/water/support.hpp"

#include <sstream>

using namespace water_tests;

namespace {
using Sea = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Buoyancy, Rest, SortAndSweep,
                  Narrowphase<Sphere, Plane>, Impulse<>, Projection>;
} // namespace

TEST_CASE("a stone sinks, lies on the ground and sleeps, while a ball bobs above it", "[water]") {
    Sea world{{}, {}, {}, {}, {}, {}, {}, {}, {}};
    const Sphere ball{0.4 * metre};
    const auto pool =
        world.add(Pool{Surface{WaterColumns{3.0 * mps, 0.2 / second}, ColumnGrid(16, 16, 0.5 * metre), 3.0 * metre}});
    world.add(Plane::ground(), fixed);
    auto put = [&](double x, double y, double kilograms) {
        const auto body = world.add(ball, position(metres(x, y, 4)), mass(kilograms * kilogram), restitution(0.2));
        return std::pair(body, world.add(Floating{body, ball, 0.5, 0.2 / second}));
    };
    const auto stone = put(4, 1.5, 600), cork = put(4, 3.6, 60);
    bool slept_while_the_other_moved = false;
    for (int i = 0; i < 60 * 60; ++i) {
        world.step(1.0 / 60 * second);
        REQUIRE(world.position(stone.first).value()[1] > 0.39);
        REQUIRE(world.water(pool).volume().value() == Approx(64 * 3).epsilon(1e-12));
        slept_while_the_other_moved = slept_while_the_other_moved || (world.motion(stone.first) == Motion::resting &&
                                                                      world.motion(cork.first) == Motion::awake);
    }
    CHECK(slept_while_the_other_moved);
    CHECK(world.position(stone.first).value()[1] == Approx(0.4).margin(0.01));
    CHECK(world.afloat(cork.second).submerged.value() == Approx(0.06).epsilon(1e-3));
    CHECK(world.water(pool).displaced().value() == Approx(0.06 + 4.0 / 3 * pi * 0.064).epsilon(1e-4));
    // Heavier water lifts the stone, and wakes it.
    world.set(pool, Pool{Surface{WaterColumns{3.0 * mps, 0.2 / second}, ColumnGrid(16, 16, 0.5 * metre), 3.0 * metre},
                         3000.0 * kilogram_per_cubic_metre});
    for (int i = 0; i < 60 * 20; ++i) world.step(1.0 / 60 * second);
    CHECK(world.position(stone.first).value()[1] > 2.5);
    CHECK(world.status().ok());
}
