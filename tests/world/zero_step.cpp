// SPDX-License-Identifier: BSL-1.0
// Steps of no time, of hardly any and of far too much (hard case I21).

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a step of zero is exactly nothing, for every integrator", "[world][step][I21]",
                   ANSATZ_INTEGRATORS) {
    World world{TestType{}, Gravity{}, Drag{}, AppliedForces{}, Rest{}, Interpolation{}};
    const auto body = world.add(position(metres(1, 2, 3)), velocity(metres_per_second(4, 5, 6)), mass(2.0 * kilogram));
    for (int round = 0; round < 2; ++round) { // before the first step, and after one
        world.apply_force(body, newtons(1, 2, 3));
        const auto before = world;
        world.step(0.0 * second);
        world.step(-0.0 * second);
        CHECK(world.hash() == before.hash());
        CHECK(same_bits(world.position(body), before.position(body)));
        CHECK(same_bits(world.velocity(body), before.velocity(body)));
        CHECK(same_bits(world.template read<AppliedForce>(body),
                        before.template read<AppliedForce>(body))); // a force waits for a real step
        CHECK(same_bits(world.template read<DrawnPosition>(body), before.template read<DrawnPosition>(body)));
        CHECK(world.tick() == before.tick());
        CHECK(world.time() == before.time());
        world.step(1.0 / 60 * second);
        CHECK(world.hash() != before.hash());
    }
}

TEMPLATE_TEST_CASE("steps of a picosecond and of ten seconds are taken", "[world][step][I21]",
                   (World<Space<double, 3>, ImplicitEuler>), (World<Space<double, 3>, Verlet>),
                   (World<Space<float, 2>, Verlet>), (World<Space<float, 2>, RungeKutta4>)) {
    TestType world{typename TestType::S{}, typename TestType::Integrator{}};
    const auto body = world.add(velocity(vec<TestType>(metre_per_second, 1, 0)));
    const bool narrow = sizeof(typename TestType::Scalar) == 4;
    double expected = 0;
    for (const double dt : {1e-12, 10.0}) {
        world.step(dt * second);
        expected += dt;
        // Free flight: x = v t; a handful of roundings, since Verlet's history is a difference of positions.
        CHECK(double(world.position(body).value()[0]) == Catch::Approx(expected).epsilon(narrow ? 1e-6 : 1e-14));
        CHECK(world.time() == expected * second);
        CHECK(world.status().ok());
    }
}
