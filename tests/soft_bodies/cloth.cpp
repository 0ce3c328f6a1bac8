// SPDX-License-Identifier: BSL-1.0
// Sheets: what is built of a description, in which order, and what is refused.

#include <ansatz/soft_bodies/cloth.hpp>

#include "tests/soft_bodies/support.hpp"

#include <ansatz/soft_bodies/closed_meshes.hpp>

using namespace soft_tests;

namespace {

using Plain = World<SemiImplicitEuler, Springs<>>;
Plain empty() { return World{SemiImplicitEuler{}, Springs{}}; }

/// The vertices that a spring joins.
std::array<std::size_t, 2> ends_of(const Plain& world, const ClothParts& parts, SpringHandle spring) {
    const auto found = [&](const SpringEnd& end) {
        return std::size_t(std::find(parts.bodies.begin(), parts.bodies.end(), end.body()) - parts.bodies.begin());
    };
    const Spring it = world.get(spring);
    return {found(it.first), found(it.second)};
}
/// That a refusal says this, and that the world is as it was, down to the handles that it gives out next.
template <class World_> void check_refused(World_& world, const Cloth& cloth, const std::string& said) {
    const auto before = world.hash();
    CHECK(refusal([&] { add_cloth(world, cloth); }) == said);
    CHECK(world.hash() == before);
    CHECK(world.size() == 0);
    CHECK(world.template elements<Spring>().ids() == 0);
}

} // namespace

TEST_CASE("a grid becomes as many bodies and springs as its formulas say, and nothing else", "[soft_bodies]") {
    for (const std::size_t n : {2, 3, 8})
        for (const std::size_t m : {2, 5, 8}) {
            INFO(n << " x " << m);
            Plain world = empty();
            const ClothParts parts = add_cloth(world, woven(n, m));
            CHECK(parts.bodies.size() == n * m);
            CHECK(parts.structural.size() == (n - 1) * m + n * (m - 1));
            CHECK(parts.shear.size() == 2 * (n - 1) * (m - 1));
            CHECK(parts.bend.size() == (n - 2) * m + n * (m - 2));
            CHECK(world.size() == n * m);
            CHECK(world.elements<Spring>().size() == parts.structural.size() + parts.shear.size() + parts.bend.size());
            CHECK(world.count(Motion::awake) == n * m);
        }
    Plain world = empty(); // the sheet of the tables of costs
    add_cloth(world, woven(50, 50));
    CHECK(world.elements<Spring>().size() == 14502);
}

TEST_CASE("handles come in the documented order, with the constants of their kind", "[soft_bodies]") {
    Plain world = empty();
    const Cloth cloth = woven(3, 3);
    const ClothParts parts = add_cloth(world, cloth);
    for (std::size_t v = 0; v < 9; ++v) CHECK(world.position(parts.bodies[v]) == cloth.mesh.vertices()[v]);
    using Ends = std::array<std::size_t, 2>;
    const std::vector<Ends> structural{{0, 1}, {1, 2}, {3, 4}, {4, 5}, {6, 7}, {7, 8},
                                       {0, 3}, {1, 4}, {2, 5}, {3, 6}, {4, 7}, {5, 8}},
        shear{{0, 4}, {1, 3}, {1, 5}, {2, 4}, {3, 7}, {4, 6}, {4, 8}, {5, 7}},
        bend{{0, 2}, {3, 5}, {6, 8}, {0, 6}, {1, 7}, {2, 8}};
    const auto check_kind = [&](const std::vector<SpringHandle>& springs, const std::vector<Ends>& ends,
                                const SpringConstants& constants) {
        REQUIRE(springs.size() == ends.size());
        for (std::size_t i = 0; i < ends.size(); ++i) {
            CHECK(ends_of(world, parts, springs[i]) == ends[i]);
            const Spring it = world.get(springs[i]);
            CHECK(it.stiffness == constants.stiffness);
            CHECK(it.damping == constants.damping);
            const auto apart = cloth.mesh.vertices()[ends[i][0]] - cloth.mesh.vertices()[ends[i][1]];
            CHECK(it.rest_length->value() == Approx(norm(apart).value()).epsilon(1e-15));
        }
    };
    check_kind(parts.structural, structural, cloth.structural);
    check_kind(parts.shear, shear, cloth.shear);
    check_kind(parts.bend, bend, cloth.bend);
}

TEST_CASE("a mesh that is no grid has a spring on each edge and one across each inner edge", "[soft_bodies]") {
    Plain world = empty();
    const TriangleMesh ball = ball_mesh(0.5 * metre, 1);
    Cloth cloth = woven(2, 2);
    cloth.mesh = ball;
    const ClothParts parts = add_cloth(world, cloth);
    REQUIRE(parts.structural.size() == ball.edges().size());
    REQUIRE(parts.bend.size() == ball.inner_edges().size());
    CHECK(parts.shear.empty());
    for (std::size_t e = 0; e < ball.edges().size(); ++e) {
        const auto& [a, b] = ball.edges()[e];
        CHECK(ends_of(world, parts, parts.structural[e]) == std::array<std::size_t, 2>{a, b});
        const auto& across = ball.inner_edges()[e].opposite;
        CHECK(ends_of(world, parts, parts.bend[e]) == std::array<std::size_t, 2>{across[0], across[1]});
        CHECK(world.get(parts.bend[e]).stiffness == cloth.shear.stiffness + cloth.bend.stiffness);
        CHECK(world.get(parts.bend[e]).damping == cloth.shear.damping + cloth.bend.damping);
    }
    CHECK(mass_of_all(world) == Approx(0.15 * ball.area().value()).epsilon(1e-13));
}

TEST_CASE("kinds that do nothing are not built; the masses are those of the areas, or all the same", "[soft_bodies]") {
    for (const auto lumping : {Lumping::by_area, Lumping::equal}) {
        Plain world = empty();
        Cloth cloth = woven(5, 4);
        cloth.shear = cloth.bend = {};
        cloth.lumping = lumping;
        const ClothParts parts = add_cloth(world, cloth);
        CHECK(parts.shear.empty());
        CHECK(parts.bend.empty());
        CHECK(world.elements<Spring>().size() == parts.structural.size());
        CHECK(mass_of_all(world) == Approx(0.15 * 0.4 * 0.3).epsilon(1e-13));
        const double of_cell = 0.15 * 0.01;
        const bool equal = lumping == Lumping::equal;
        CHECK(world.mass(parts.bodies[0]).value() == Approx(equal ? of_cell * 12 / 20 : of_cell / 4).epsilon(1e-13));
        CHECK(world.mass(parts.bodies[1]).value() == Approx(equal ? of_cell * 12 / 20 : of_cell / 2).epsilon(1e-13));
        CHECK(world.mass(parts.bodies[6]).value() == Approx(equal ? of_cell * 12 / 20 : of_cell).epsilon(1e-13));
    }
    Plain world = empty();
    Cloth damper = woven(2, 2);
    damper.structural = {};
    damper.shear = {0.0 * N_per_m, 1.0 * N_s_per_m}; // without stiffness, but it does something
    damper.bend = {};
    CHECK(add_cloth(world, damper).shear.size() == 2);
}

TEST_CASE("pins are fixed bodies, dragged vertices moving ones, and the others have the velocity", "[soft_bodies]") {
    Plain world = empty();
    Cloth cloth = woven(4, 4);
    cloth.pins = {12, 15};
    cloth.dragged = {0};
    cloth.velocity = metres_per_second(1, 2, 3);
    const ClothParts parts = add_cloth(world, cloth);
    for (std::size_t v = 0; v < 16; ++v) {
        const auto motion = v == 12 || v == 15 ? Motion::fixed : v == 0 ? Motion::moving : Motion::awake;
        CHECK(world.motion(parts.bodies[v]) == motion);
        CHECK(world.velocity(parts.bodies[v]) ==
              (motion == Motion::awake ? metres_per_second(1, 2, 3) : metres_per_second(0, 0, 0)));
    }
    world.set_velocity(parts.bodies[0], metres_per_second(-1, 0, 0));
    run(world, 10, 0.01);
    CHECK(world.position(parts.bodies[0]).value()[0] == Approx(-0.1).epsilon(1e-14));
    CHECK(world.status().ok());
}

TEST_CASE("vertices in one place: two triangles that lie on each other are a sheet that moves and stays whole (K10)",
          "[soft_bodies]") {
    Plain world = empty();
    Cloth book = woven(2, 2);
    book.mesh = {{metres(0, 0, 0), metres(0, 1, 0), metres(1, 0.5, 0), metres(1, 0.5, 0)}, {{0, 1, 2}, {1, 0, 3}}};
    const ClothParts parts = add_cloth(world, book);
    REQUIRE(parts.bend.size() == 1);
    CHECK(world.get(parts.bend[0]).rest_length->value() == 0);
    CHECK(largest_tension(world) == 0);
    world.set_velocity(parts.bodies[2], metres_per_second(0, 0, 0.5));
    run(world, 1000, 0.01);
    CHECK(world.status().ok());
    CHECK(norm(world.position(parts.bodies[2])).value() < 10);
}

TEST_CASE("two sheets in one world, one of which goes, its springs with it", "[soft_bodies]") {
    Plain world = empty();
    const ClothParts one = add_cloth(world, woven(3, 4)), other = add_cloth(world, woven(4, 3));
    const auto springs = world.elements<Spring>().size();
    for (const Handle body : one.bodies) world.remove(body);
    CHECK(world.size() == 12);
    CHECK(world.elements<Spring>().size() == springs / 2);
    for (const auto& kind : {other.structural, other.shear, other.bend})
        for (const auto spring : kind) CHECK(world.contains(spring));
    // Into the room that has become free.
    const ClothParts third = add_cloth(world, woven(3, 4));
    CHECK(world.elements<Spring>().size() == springs);
    for (const Handle body : third.bodies) CHECK(world.contains(body));
    run(world, 10, 0.01);
    CHECK(largest_tension(world) == 0);
}

TEST_CASE("what a sheet cannot be is refused by name, index, value and unit, and the world is as it was",
          "[soft_bodies]") {
    Plain world = empty();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [](auto&& change) {
        Cloth cloth = woven(3, 3);
        change(cloth);
        return cloth;
    };
    check_refused(world, with([](Cloth& c) { c.mass_per_area = 0.0 * kg_per_m2; }),
                  "add_cloth: mass per area is 0 kg/m^2; it must be finite and greater than zero");
    check_refused(world, with([&](Cloth& c) { c.mass_per_area = nan * kg_per_m2; }),
                  "add_cloth: mass per area is nan kg/m^2; it must be finite and greater than zero");
    check_refused(world, with([](Cloth& c) { c.structural.stiffness = -3.0 * N_per_m; }),
                  "add_cloth: structural stiffness is -3 N/m; it must be finite and not negative");
    check_refused(world, with([&](Cloth& c) { c.shear.stiffness = nan * N_per_m; }),
                  "add_cloth: shear stiffness is nan N/m; it must be finite and not negative");
    check_refused(world, with([](Cloth& c) { c.bend.damping = -0.5 * N_s_per_m; }),
                  "add_cloth: bend damping is -0.5 kg/s; it must be finite and not negative");
    check_refused(world, with([](Cloth& c) {
                      c.pins = {8, 9};
                  }),
                  "add_cloth: pins[1] is 9; there are 9 of them, from 0");
    check_refused(world, with([](Cloth& c) {
                      c.pins = {8, 0, 8};
                  }),
                  "add_cloth: pins[2] is 8; that vertex is held already; each is named once");
    check_refused(world, with([](Cloth& c) {
                      c.pins = {8}, c.dragged = {1, 8};
                  }),
                  "add_cloth: dragged[1] is 8; that vertex is held already; each is named once");
    check_refused(world, with([&](Cloth& c) { c.velocity = metres_per_second(0, nan, 0); }),
                  "add_cloth: velocity is (0, nan, 0) m/s; it must be finite");
    check_refused(world, with([](Cloth& c) { c.mass_per_area = 1e-320 * kg_per_m2; }),
                  "add_cloth, vertex 0: mass is 2.5e-323 kg; a mass is finite and greater than 0 kg in the world's "
                  "scalar, and its inverse is a number (a body that nothing moves is added as `fixed`, without a "
                  "mass)");
}

TEST_CASE("what the world's scalar, dimension or springs cannot hold is refused before anything is added",
          "[soft_bodies]") {
    World single{SemiImplicitEuler{}, Springs{}, Space<float, 3>{}};
    Cloth far = woven(3, 3);
    far.mesh = far.mesh.moved(metres(1e39, 0, 0));
    check_refused(single, far, "World: add_cloth, vertex 0 is (1e+39, 0, 0) m; the world's scalar can hold it");
    Cloth stiff = woven(3, 3);
    stiff.bend.stiffness = 1e39 * N_per_m;
    check_refused(single, stiff, "World: stiffness is 1e+39 N/m; the world's scalar can hold it");
    Cloth large = woven(3, 3);
    large.mesh = TriangleMesh::grid(2, 2, metres(1e30, 0, 0), metres(0, 1e30, 0));
    large.mass_per_area = 1e-55 * kg_per_m2;
    check_refused(single, large,
                  "add_cloth: the distance of vertex 0 and 1 is inf m; it is a finite number that the world's scalar "
                  "can hold");
    World plane{SemiImplicitEuler{}, Springs<Undamped>{}, Space<double, 2>{}};
    check_refused(plane, woven(3, 3), "add_cloth: damping is 0.02 kg/s; the springs of this world are Undamped");
    Cloth upright = woven(3, 3);
    upright.structural.damping = upright.shear.damping = upright.bend.damping = 0.0 * N_s_per_m;
    upright.mesh = TriangleMesh::grid(3, 3, metres(1, 0, 0), metres(0, 0, 1));
    check_refused(
        plane, upright,
        "World: add_cloth, vertex 3 is (0, 0, 0.5) m; this world has two dimensions, so its third component must be 0");
    upright.mesh = sheet(3, 3);
    CHECK(add_cloth(plane, upright).bodies.size() == 9);
}
