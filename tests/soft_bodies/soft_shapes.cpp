// SPDX-License-Identifier: BSL-1.0
// Balls, boxes and bodies of one's own: what is built, mass and symmetry, that they come back to their shape.

#include <ansatz/soft_bodies/plan.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/soft_bodies/soft_box.hpp>
#include <ansatz/springs/stable_step.hpp>

#include "tests/soft_bodies/support.hpp"

using namespace soft_tests;

namespace {

using Jelly = World<SemiImplicitEuler, Springs<>>;
Jelly nothing() { return World{SemiImplicitEuler{}, Springs{}}; }

SoftBall ball() {
    return {.centre = metres(1, 2, 3),
            .radius = 0.3 * metre,
            .density = 40.0 * kilogram_per_cubic_metre,
            .divisions = 2,
            .structural = {60.0 * N_per_m, 0.5 * N_s_per_m},
            .bend = {20.0 * N_per_m, 0.2 * N_s_per_m},
            .spokes = {80.0 * N_per_m, 0.5 * N_s_per_m}};
}
SoftBox box() {
    return {.centre = metres(1, 2, 3),
            .size = metres(0.3, 0.4, 0.6),
            .cells = {3, 2, 4},
            .density = 40.0 * kilogram_per_cubic_metre,
            .structural = {60.0 * N_per_m, 0.5 * N_s_per_m},
            .shear = {40.0 * N_per_m, 0.5 * N_s_per_m},
            .bend = {20.0 * N_per_m, 0.2 * N_s_per_m}};
}
VectorQuantity<unit::Length> centre_of_mass(const Jelly& world) {
    VectorQuantity<unit::Length> sum;
    world.for_each([&](Handle body) { sum += (world.mass(body).value() / mass_of_all(world)) * world.position(body); });
    return sum;
}
/// Squeezed to nine tenths along y and let go, it gets its lengths back: no spring pulls any more.
void check_comes_back(Jelly world) {
    CHECK(largest_tension(world) == 0);
    const auto centre = centre_of_mass(world);
    for (const Handle body : world.handles()) {
        auto x = world.position(body) - centre;
        world.set_position(body, centre + metres(x.value()[0], 0.9 * x.value()[1], x.value()[2]));
    }
    const double squeezed = largest_tension(world);
    CHECK(squeezed > 0.1);
    run(world, 4000, 0.5 * stable_step(world).value());
    CHECK(world.status().ok());
    CHECK(largest_tension(world) <= 1e-3 * squeezed);
    CHECK(norm(centre_of_mass(world) - centre).value() <= 1e-12);
}

} // namespace

TEST_CASE("a soft ball: its skin, its middle, the mass of the polyhedron, and its shape comes back", "[soft_bodies]") {
    Jelly world = nothing();
    const SoftBallParts parts = add_soft_ball(world, ball());
    const TriangleMesh mesh = ball_mesh(0.3 * metre, 2, metres(1, 2, 3));
    REQUIRE(parts.bodies.size() == mesh.vertices().size() + 1);
    CHECK(parts.structural.size() == mesh.edges().size());
    CHECK(parts.bend.size() == mesh.inner_edges().size());
    CHECK(parts.spokes.size() == mesh.vertices().size());
    CHECK(world.size() == parts.bodies.size());
    CHECK(world.elements<Spring>().size() == 2 * mesh.edges().size() + mesh.vertices().size());
    for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
        CHECK(world.position(parts.bodies[v]) == mesh.vertices()[v]);
        CHECK(world.get(parts.spokes[v]).first.body() == parts.bodies[v]);
        CHECK(world.get(parts.spokes[v]).second.body() == parts.bodies.back());
    }
    const double all = 40 * mesh.volume().value();
    CHECK(mass_of_all(world) == Approx(all).epsilon(1e-12));
    CHECK(world.mass(parts.bodies.back()).value() == Approx(all / 4).epsilon(1e-12));
    CHECK(norm(centre_of_mass(world) - metres(1, 2, 3)).value() <= 1e-14 * 10);
    check_comes_back(world);
}

TEST_CASE("a soft box: a lattice of its formulas, the mass of its volume, and its shape comes back", "[soft_bodies]") {
    Jelly world = nothing();
    const SoftBox it = box();
    const SoftBoxParts parts = add_soft_box(world, it);
    const std::size_t x = 3, y = 2, z = 4, X = x + 1, Y = y + 1, Z = z + 1;
    REQUIRE(parts.bodies.size() == X * Y * Z);
    CHECK(parts.structural.size() == x * Y * Z + X * y * Z + X * Y * z);
    CHECK(parts.shear.size() == 2 * (x * y * Z + X * y * z + x * Y * z) + 4 * x * y * z);
    CHECK(parts.bend.size() == (x - 1) * Y * Z + X * (y - 1) * Z + X * Y * (z - 1));
    CHECK(world.elements<Spring>().size() == parts.structural.size() + parts.shear.size() + parts.bend.size());
    CHECK(world.position(parts.bodies[it.at(0, 0, 0)]) == metres(0.85, 1.8, 2.7));
    CHECK(norm(world.position(parts.bodies[it.at(3, 2, 4)]) - metres(1.15, 2.2, 3.3)).value() <= 1e-15 * 10);
    CHECK(norm(world.position(parts.bodies[it.at(1, 0, 2)]) - metres(0.95, 1.8, 3)).value() <= 1e-15 * 10);
    CHECK(mass_of_all(world) == Approx(40 * 0.3 * 0.4 * 0.6).epsilon(1e-12));
    const double of_cell = 40 * 0.1 * 0.2 * 0.15;
    CHECK(world.mass(parts.bodies[it.at(0, 0, 0)]).value() == Approx(of_cell / 8).epsilon(1e-12));
    CHECK(world.mass(parts.bodies[it.at(1, 1, 1)]).value() == Approx(of_cell).epsilon(1e-12));
    // No spring stands twice.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const auto spring : world.elements<Spring>().handles()) {
        const Spring one = world.get(spring);
        const auto a = one.first.body().id, b = one.second.body().id;
        ends.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(ends.begin(), ends.end());
    CHECK(std::adjacent_find(ends.begin(), ends.end()) == ends.end());
    check_comes_back(world);
}

TEST_CASE("balls and boxes that cannot be are refused, and the world is as it was", "[soft_bodies]") {
    Jelly world = nothing();
    const auto before = world.hash();
    const auto ball_said = [&](auto&& change) {
        SoftBall it = ball();
        change(it);
        return refusal([&] { add_soft_ball(world, it); });
    };
    const auto box_said = [&](auto&& change) {
        SoftBox it = box();
        change(it);
        return refusal([&] { add_soft_box(world, it); });
    };
    CHECK(ball_said([](SoftBall& b) { b.radius = 0.0 * metre; }) ==
          "add_soft_ball: radius is 0 m; it must be finite and greater than zero");
    CHECK(ball_said([](SoftBall& b) { b.density = -1.0 * kilogram_per_cubic_metre; }) ==
          "add_soft_ball: density is -1 kg/m^3; it must be finite and greater than zero");
    CHECK(ball_said([](SoftBall& b) { b.divisions = 12; }) == "ball_mesh: divisions is 12; 0 to 8 of them are made");
    CHECK(ball_said([](SoftBall& b) { b.spokes.damping = -1.0 * N_s_per_m; }) ==
          "add_soft_ball: spokes' damping is -1 kg/s; it must be finite and not negative");
    CHECK(box_said([](SoftBox& b) { b.size = metres(1, 1, -1); }) ==
          "add_soft_box: size along z is -1 m; it must be finite and greater than zero");
    CHECK(box_said([](SoftBox& b) { b.cells[1] = 0; }) ==
          "add_soft_box: the number of cells along y is 0; it is at least 1, and 1000 at most");
    CHECK(box_said([](SoftBox& b) { b.dragged = {60}; }) ==
          "add_soft_box: dragged[0] is 60; there are 60 of them, from 0");
    CHECK(world.hash() == before);
}

TEST_CASE("a soft body of one's own is a plan, checked as a whole before it is built", "[soft_bodies]") {
    Jelly world = nothing();
    SoftPlan plan{.where = "add_cross", .vertex = "tip", .velocity = {}, .bodies = {}, .links = {}};
    for (const auto& tip : {metres(1, 0, 0), metres(-1, 0, 0), metres(0, 1, 0), metres(0, -1, 0)})
        plan.bodies.push_back({.place = tip, .mass = 0.1 * kilogram});
    for (const auto& [a, b] : {std::pair{0U, 1U}, {2U, 3U}, {0U, 2U}}) plan.link(a, b, {5.0 * N_per_m});
    plan.link(1, 3, {}); // does nothing, and is left out
    plan.check<Spring>(world);
    std::vector<Handle> bodies;
    std::vector<SpringHandle> springs;
    plan.build<Spring>(world, bodies, springs);
    CHECK(bodies.size() == 4);
    CHECK(springs.size() == 3);
    CHECK(world.get(springs[1]).rest_length->value() == 2);
    plan.bodies[2].mass = {};
    CHECK(refusal([&] { plan.check<Spring>(world); }) ==
          "add_cross, tip 2: mass is 0 kg; a mass is finite and greater than 0 kg (a body that nothing moves is added "
          "as `fixed`, without a mass)");
}
