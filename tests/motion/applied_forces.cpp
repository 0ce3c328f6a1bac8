// SPDX-License-Identifier: BSL-1.0

// Forces from outside: summed as vectors, constant through all stages of one step, then gone.

#include <ansatz/motion/applied_forces.hpp>

#include "tests/motion/support.hpp"

using namespace motion_tests;

TEST_CASE("applied forces act for exactly one step, and their sum counts", "[motion][applied_forces]") {
    for_each_type(Staged{}, []<class I> {
        for_each_type(Types<Space<double, 2>, Space<float, 3>>{}, []<class S> {
            World world{S{}, I{}, AppliedForces{}};
            const auto body = world.add(mass(2.0 * kilogram));
            const double eps = 8 * std::numeric_limits<typename S::Scalar>::epsilon();
            world.apply_force(body, vector_in<S, unit::Force>(3, 1));
            world.apply_force(body, vector_in<S, unit::Force>(1, -5));
            world.step(0.5 * second);
            // v = (F1 + F2) / m dt = (4, -4) / 2 * 0.5
            auto v = state(world, body);
            CHECK(std::abs(v[3] - 1) <= eps);
            CHECK(std::abs(v[4] + 1) <= eps);
            world.step(0.5 * second);
            const auto later = state(world, body);
            INFO("the force is gone: v stays (1, -1), is (" << later[3] << ", " << later[4] << ")");
            CHECK(std::abs(later[3] - 1) <= 2 * eps);
            CHECK(std::abs(later[4] + 1) <= 2 * eps);
        });
    });
}

TEST_CASE("applied forces: a constant one is a constant acceleration, by each scheme's closed form",
          "[motion][applied_forces]") {
    // a = 3 m/s^2 for 10 steps of 0.1 s: x = a T^2 / 2 + (1/2) a T h times -1, 1, 0 as the scheme is explicit,
    // semi-implicit, or better.
    auto end = []<class I>(I integrator) {
        World world{integrator, AppliedForces{}};
        const auto body = world.add(mass(4.0 * kilogram));
        for (int i = 0; i < 10; ++i) {
            world.apply_force(body, newtons(12, 0, 0));
            world.step(0.1 * second);
        }
        return world.position(body).value()[0];
    };
    CHECK(std::abs(end(ExplicitEuler{}) - 1.35) <= 1e-14);
    CHECK(std::abs(end(SemiImplicitEuler{}) - 1.65) <= 1e-14);
    CHECK(std::abs(end(VelocityVerlet{}) - 1.5) <= 1e-14);
    CHECK(std::abs(end(RungeKutta4{}) - 1.5) <= 1e-14);
    CHECK(std::abs(end(Verlet{}) - 1.5) <= 1e-13);
}

TEST_CASE("applied forces do not move what is fixed, and opposite ones cancel to the bit", "[motion][applied_forces]") {
    World world{VelocityVerlet{}, AppliedForces{}};
    const auto wall = world.add(fixed), body = world.add(mass(3.0 * kilogram));
    for (int i = 0; i < 10; ++i) {
        world.apply_force(wall, newtons(1e9, 0, 0));
        world.apply_force(body, newtons(0.1, 0.7, -3));
        world.apply_force(body, newtons(-0.1, -0.7, 3));
        world.step(0.1 * second);
    }
    CHECK(world.position(wall).value() == Eigen::Vector3d::Zero());
    CHECK(world.position(body).value() == Eigen::Vector3d::Zero());
}

TEST_CASE("applied forces: a force and an impulse of the same F dt leave the same velocity",
          "[motion][applied_forces]") {
    World pushed{SemiImplicitEuler{}, AppliedForces{}}, kicked{SemiImplicitEuler{}, AppliedForces{}};
    const auto a = pushed.add(mass(0.3 * kilogram)), b = kicked.add(mass(0.3 * kilogram));
    pushed.apply_force(a, newtons(1, 2, 3));
    kicked.apply_impulse(b, newtons(1, 2, 3) * (0.02 * second));
    pushed.step(0.02 * second);
    kicked.step(0.02 * second);
    CHECK((pushed.velocity(a) - kicked.velocity(b)).value().norm() <= 1e-15);
}

TEST_CASE("applied forces: energy is taken from outside, by the work F s", "[motion][applied_forces]") {
    World world{VelocityVerlet{}, AppliedForces{}};
    const auto body = world.add(mass(2.0 * kilogram));
    for (int i = 0; i < 100; ++i) {
        world.apply_force(body, newtons(0, 5, 0));
        world.step(0.01 * second);
    }
    const double work = 5 * world.position(body).value()[1];
    CHECK(std::abs(kinetic_energy(world).value() - work) <= 1e-13 * work);
    CHECK(potential_energy(world).value() == 0);
}

TEST_CASE("applied forces: at any moment of a run they give F dt, and applying one does not yet change the velocity",
          "[motion][applied_forces]") {
    for_each_type(Staged{}, []<class I> {
        World world{I{}, AppliedForces{}, Gravity{}};
        const auto body = world.add(velocity(metres_per_second(1, 0, 0)), mass(2.0 * kilogram));
        double vx = 1, vy = 0;
        for (int i = 0; i < 30; ++i) {
            if (i % 7 == 3) {
                world.apply_force(body, newtons(4, 0, 0));
                vx += 4.0 / 2 * 0.1;
                INFO("with a force pending the velocity is still " << vy << " m/s down");
                CHECK(std::abs(world.velocity(body).value()[1] - vy) <= 1e-13);
            }
            world.step(0.1 * second);
            vy -= 9.81 * 0.1;
            INFO("after step " << i << ": should be (" << vx << ", " << vy << ") m/s");
            CHECK(std::abs(world.velocity(body).value()[0] - vx) <= 1e-13);
            CHECK(std::abs(world.velocity(body).value()[1] - vy) <= 1e-13);
        }
    });
}
