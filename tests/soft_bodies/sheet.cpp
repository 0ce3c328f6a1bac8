// SPDX-License-Identifier: BSL-1.0
// A sheet as it moves: at rest, moved at a corner, hung up, left alone, and its stable step (hard cases K).

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/velocity_verlet.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/springs/stable_step.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <string>

using namespace soft_tests;

namespace {

/// n x n bodies of 1/n^2 kg, all the same, with springs of one stiffness: 0.1 m apart, without damping.
Cloth even(std::size_t n, double k, bool shear, bool bend) {
    Cloth cloth{.mesh = sheet(n, n), .lumping = Lumping::equal};
    cloth.mass_per_area = 1.0 * kilogram / cloth.mesh.area();
    cloth.structural.stiffness = k * N_per_m;
    if (shear) cloth.shear.stiffness = k * N_per_m;
    if (bend) cloth.bend.stiffness = k * N_per_m;
    return cloth;
}
using SheetWorld = World<SemiImplicitEuler, Springs<>>;

/// sum m x cross v about the origin.
template <class World_> VectorQuantity<unit::AngularMomentum> angular_momentum(const World_& world) {
    VectorQuantity<unit::AngularMomentum> sum;
    world.for_each([&](Handle body) { sum += world.mass(body) * cross(world.position(body), world.velocity(body)); });
    return sum;
}

} // namespace

TEST_CASE("a sheet as built has no tension in any spring, and left alone it stays to the bit, in every space",
          "[soft_bodies]") {
    const auto rests = []<class World_>(World_ world, const TriangleMesh& mesh) {
        Cloth cloth = woven(7, 6);
        cloth.mesh = mesh;
        const ClothParts parts = add_cloth(world, cloth);
        CHECK(largest_tension(world) == 0);
        const World_ before = world;
        run(world, 500, 0.01);
        for (const Handle body : parts.bodies) {
            CHECK(world.position(body) == before.position(body));
            CHECK(norm(world.velocity(body)).value() == 0);
        }
        CHECK(largest_tension(world) == 0);
    };
    // In no round numbers, so that every rest length was rounded.
    const TriangleMesh askew = TriangleMesh::grid(7, 6, metres(0.7, 0.1, 0), metres(-0.03, 0.9, 0), metres(3, 7, 0));
    const TriangleMesh tilted = TriangleMesh::grid(7, 6, metres(0.7, 0.1, 0.3), metres(0.2, 0.9, -1), metres(3, 7, 1));
    rests(World{SemiImplicitEuler{}, Springs{}}, tilted);
    rests(World{SemiImplicitEuler{}, Springs{}, Space<float, 2>{}}, askew);
#ifndef ANSATZ_FEWER_TYPES
    rests(World{VelocityVerlet{}, Springs{}, Space<float, 3>{}}, tilted);
#endif
}

TEST_CASE("a sheet moved at a corner: the nearest springs act first, one ring of vertices a step", "[soft_bodies]") {
    const std::size_t n = 16;
    SheetWorld world{SemiImplicitEuler{}, Springs{}};
    Cloth cloth = even(n, 1, true, false);
    cloth.structural.damping = cloth.shear.damping = 0.02 * N_s_per_m;
    const ClothParts parts = add_cloth(world, cloth);
    world.set_position(parts.bodies[0], world.position(parts.bodies[0]) + metres(-0.02, -0.01, 0.01));
    // Step 1 is what the springs of the corner do: they pull its three neighbours, and no other body.
    std::size_t reached = 1;
    for (std::size_t step = 1; step <= n; ++step) {
        world.step(0.03 * second);
        reached = 0;
        for (std::size_t v = 0; v < n * n; ++v) {
            const std::size_t ring = std::max(v % n, v / n);
            const bool moves = norm(world.velocity(parts.bodies[v])).value() != 0;
            if (moves) ++reached;
            if (moves) CHECK(ring <= step);
            if (ring == 1 && step == 1) CHECK(moves);
        }
        // Along the diagonal and the two sides each ring is reached in its turn: nothing runs ahead, nothing waits.
        const std::size_t far = std::min(step, n - 1);
        for (const std::size_t v : {far, far * n, far * n + far})
            CHECK(norm(world.velocity(parts.bodies[v])).value() != 0);
    }
    CHECK(reached == n * n); // "almost all of the surface", after so many steps all of it
}

TEST_CASE("hard case K2: the stiffness of a sheet is that of its kinds of springs, and the step ends where it says",
          "[soft_bodies][slow]") {
    const double k = 10;
    const std::size_t n = 20;
    const double m = 1.0 / (n * n);
    struct Row {
        bool shear, bend;
        double lambda, bound;
    };
    for (const auto& [shear, bend, lambda, bound] :
         {Row{false, false, 3.975, 8}, Row{true, false, 7.93, 16}, Row{true, true, 9.98, 24}}) {
        INFO("lambda " << lambda);
        World world{SemiImplicitEuler{}, Springs<Undamped>{}};
        const ClothParts parts = add_cloth(world, even(n, k, shear, bend));
        const double measured = measured_stiffness(world, 150).value() * m / k;
        CHECK(measured == Approx(lambda).epsilon(1e-3)); // the figures have three digits
        if (!shear) CHECK(measured == Approx(4 * std::pow(std::cos(std::acos(-1.0) / (2 * n)), 2)).epsilon(1e-6));
        // What stable_step takes is the number of springs at a body, twice: certain, and too short.
        const double unit_of_time = std::sqrt(m / k);
        CHECK(stable_step(world).value() == Approx(2 / std::sqrt(bound) * unit_of_time).epsilon(1e-6));
        const auto grown = [&](double part) {
            auto copy = world;
            std::mt19937 random(1);
            std::uniform_real_distribution<double> push(-1e-7, 1e-7);
            for (const Handle body : parts.bodies)
                copy.set_velocity(body, metres_per_second(push(random), push(random), 0));
            run(copy, 400, part * 2 / std::sqrt(measured) * unit_of_time);
            double farthest = 0;
            for (const Handle body : parts.bodies) {
                const double way = norm(copy.position(body) - world.position(body)).value();
                farthest = way <= farthest ? farthest : way; // what is no number any more is far away, too
            }
            return std::isfinite(farthest) ? farthest : std::numeric_limits<double>::infinity();
        };
        // 1e-7 m/s and some seconds: what does not grow stays within micrometres.
        CHECK(grown(0.95) < 1e-6);
        CHECK(grown(1.05) > 1e-2);
    }
}

TEST_CASE("hard case K3: a hung sheet of structural springs is longer by the hanging chain's formula, column by column",
          "[soft_bodies][slow]") {
    const double m = 0.05, k = 500, g = 9.81;
    const std::size_t links = 20, rows = links + 1;
    const auto hung = [&](std::size_t columns, Lumping lumping, double of_area) {
        World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second}};
        Cloth cloth{.mesh = sheet(columns, rows), .structural = {k * N_per_m, 0.3 * N_s_per_m}, .lumping = lumping};
        cloth.mass_per_area = of_area * kilogram / cloth.mesh.area();
        for (std::size_t i = 0; i < columns; ++i) cloth.pins.push_back(std::uint32_t(i + columns * links));
        const ClothParts parts = add_cloth(world, cloth);
        run(world, 10000, 0.002);
        std::vector<double> stretch;
        for (std::size_t i = 0; i < columns; ++i)
            stretch.push_back(world.position(parts.bodies[i + columns * links]).value()[1] -
                              world.position(parts.bodies[i]).value()[1] - 0.1 * double(links));
        return stretch;
    };
    // All masses the same: m g N (N + 1) / 2k.
    for (const double stretch : hung(3, Lumping::equal, m * 3 * rows))
        CHECK(std::abs(stretch - m * g * links * (links + 1) / (2 * k)) <= 1e-6);
    // By area the lowest row has half of the others' mass: m g N^2 / 2k.
    for (const double stretch : hung(2, Lumping::by_area, m * 2 * links))
        CHECK(std::abs(stretch - m * g * links * links / (2 * k)) <= 1e-6);
}

TEST_CASE("hard case K8: a free sheet keeps its angular momentum, whatever its springs and dampers do",
          "[soft_bodies]") {
    const auto turns = []<class World_>(World_ world) {
        const ClothParts parts = add_cloth(world, woven(8, 8));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> push(-1, 1);
        for (const Handle body : parts.bodies)
            world.set_velocity(
                body, cross(Quantity<unit::Frequency, Vector<double, 3>>::from_value({1, 2, 5}), world.position(body)) +
                          metres_per_second(push(random), push(random), push(random)));
        const auto before = angular_momentum(world);
        const auto energy = total_energy(world);
        const double dt = 0.5 * stable_step(world).value();
        run(world, 1000, dt);
        CHECK(norm(angular_momentum(world) - before) <= 1e-10 * norm(before));
        CHECK(total_energy(world) < 0.95 * energy); // the springs and dampers were at work
        CHECK(total_energy(world).value() > 0);
    };
    turns(World{SemiImplicitEuler{}, Springs{}});
    turns(World{VelocityVerlet{}, Springs{}});
}

TEST_CASE("hard case K9: pins are where they were, to the bit, after 1e5 steps", "[soft_bodies][slow]") {
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Space<float, 3>{}};
    Cloth cloth = woven(3, 3);
    cloth.mesh = TriangleMesh::grid(3, 3, metres(0.3, 0, 0.01), metres(0.1, 0.3, 0), metres(0.7, 1.3, 0.1));
    cloth.pins = {6, 8};
    const ClothParts parts = add_cloth(world, cloth);
    const auto a = world.position(parts.bodies[6]), b = world.position(parts.bodies[8]);
    run(world, 100000, 0.002);
    CHECK(world.position(parts.bodies[6]) == a);
    CHECK(world.position(parts.bodies[8]) == b);
    CHECK(world.status().ok());
}
