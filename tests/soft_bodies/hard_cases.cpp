// SPDX-License-Identifier: BSL-1.0
// Hard cases K that no header of the module is the place of: energy over long runs, and one sheet at three resolutions.
// Runs long with the sanitizers.

#include "tests/soft_bodies/support.hpp"

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs/stable_step.hpp>

#include <random>

using namespace soft_tests;

namespace {

template <class World_> void push(World_& world, const std::vector<Handle>& bodies) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const Handle body : bodies)
        world.set_velocity(body, metres_per_second(number(random), number(random), number(random)));
}

} // namespace

TEST_CASE("hard case K4: the energy of a damped sheet never rises under implicit Euler", "[soft_bodies][K4]") {
    World world{ImplicitEuler{.tolerance = 1e-12}, Springs{}};
    const auto parts = add_cloth(world, woven(5, 5));
    push(world, parts.bodies);
    double energy = total_energy(world).value();
    const double first = energy;
    for (int i = 0; i < 300; ++i) {
        world.step(1.0 / 60 * second);
        const double now = total_energy(world).value();
        CHECK(now <= energy * (1 + 1e-12));
        energy = now;
    }
    CHECK(world.status().ok());
    CHECK(energy < 0.9 * first);
}

TEST_CASE(
    "hard case K4: under velocity Verlet the energy of an undamped sheet swings by no more in 1e5 steps than at first",
    "[soft_bodies][K4][slow]") {
    World world{VelocityVerlet{}, Springs<Undamped>{}};
    auto cloth = woven(4, 4);
    for (auto* kind : {&cloth.structural, &cloth.shear, &cloth.bend}) kind->damping = 0.0 * N_s_per_m;
    const auto parts = add_cloth(world, cloth);
    push(world, parts.bodies);
    const double start = total_energy(world).value(), dt = 0.2 * stable_step(world).value();
    const auto swing = [&](int steps) {
        double most = 0;
        for (int i = 0; i < steps; ++i) {
            world.step(dt * second);
            most = std::max(most, std::abs(total_energy(world).value() - start));
        }
        return most;
    };
    const double at_first = swing(10000), later = swing(90000);
    CHECK(at_first < 0.02 * start);
    CHECK(later <= 1.5 * at_first);
}

TEST_CASE("hard case K7: a sheet sags alike, whatever its resolution", "[soft_bodies][K7][slow]") {
    // Level between two pinned sides. The stiffness of a square net is that of its threads, whatever their number.
    const auto sag = [](std::size_t n) {
        World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{4.0 / second}};
        Cloth cloth{.mesh = TriangleMesh::grid(n + 1, n + 1, metres(1, 0, 0), metres(0, 0, 1)),
                    .mass_per_area = 0.15 * kg_per_m2,
                    .structural = {100.0 * N_per_m, 0.0 * N_s_per_m},
                    .shear = {50.0 * N_per_m, 0.0 * N_s_per_m}};
        for (std::size_t j = 0; j <= n; ++j)
            for (const std::size_t side : {std::size_t(0), n}) cloth.pins.push_back(std::uint32_t(side + (n + 1) * j));
        const auto parts = add_cloth(world, cloth);
        const double dt = stable_step(world).value();
        run(world, int(2.5 / dt), dt);
        return -world.position(parts.bodies[n / 2 + (n + 1) * (n / 2)]).value()[1];
    };
    const double at_10 = sag(10), at_20 = sag(20), at_40 = sag(40);
    CHECK(at_40 > 0.05);
    CHECK(at_10 == Approx(at_40).epsilon(0.05));
    CHECK(at_20 == Approx(at_40).epsilon(0.02));
}
