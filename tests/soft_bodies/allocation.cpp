// SPDX-License-Identifier: BSL-1.0
// A warm step of a solver allocates nothing; a copy takes what it needs in its first step.

#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/coloured_xpbd.hpp>
#include <ansatz/soft_bodies/pressure.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>

#include "tests/operator_new.hpp"

using namespace soft_bodies_tests;

namespace {
std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}
template <class F> std::size_t during(F&& f) {
    allocations = 0;
    ansatz::test::before_allocation = count;
    f();
    ansatz::test::before_allocation = nullptr;
    return allocations;
}
template <class Solver> std::size_t in_warm_steps(const Solver& solver) {
    auto world = world_of<double>(solver);
    const auto sheet = lay_sheet(world, 6, 1, 0, 0.1, 300, 0.1);
    world.add(Spring{sheet[0], metres(0, 1, 0), 100.0 * newton_per_metre});
    world.step(frame);
    auto copy = world;
    copy.step(frame);
    return during([&] {
        for (int i = 0; i < 50; ++i) {
            world.step(frame);
            copy.step(frame);
        }
    });
}
template <class World_> std::size_t with_a_filling(World_ world) {
    const auto mesh = ball_mesh(0.5 * metre, 1);
    std::vector<Handle> all;
    for (const auto& x : mesh.vertices()) all.push_back(world.add(position(x), mass(0.2 * kilogram)));
    for (const auto& [a, b] : mesh.edges()) world.add(Spring{all[a], all[b], 100.0 * newton_per_metre});
    world.add(Enclosure::of(all, mesh, {.inside = 300.0 * pascal, .damping = 2.0 * pascal_second}));
    for (int i = 0; i < 3; ++i) world.step(frame);
    return during([&] {
        for (int i = 0; i < 20; ++i) world.step(frame);
    });
}
template <class World_> std::size_t with_a_stiff_sheet_in_the_wind(World_ world) {
    Cloth cloth{.mesh = TriangleMesh::grid(5, 5, metres(1, 0, 0), metres(0, 1, 0)),
                .mass_per_area = 0.2 * (kilogram / square_metre),
                .structural = {50.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                .rigidity = 0.01 * joule,
                .drag = 1,
                .lift = 0.5};
    cloth.pins = {0, 20};
    add_cloth(world, cloth);
    for (int i = 0; i < 3; ++i) world.step(frame);
    return during([&] {
        for (int i = 0; i < 20; ++i) world.step(frame);
    });
}
/// \return how often steps allocated in which springs broke and vertices split, and how many did
template <class World_>
std::pair<std::size_t, std::size_t> in_steps_that_tear(World_ world, Quantity<unit::Energy> rigidity, double drag) {
    Cloth cloth{.mesh = TriangleMesh::grid(8, 8, metres(1, 0, 0), metres(0, 1, 0)),
                .mass_per_area = 0.2 * (kilogram / square_metre),
                .structural = {50.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                .shear = {20.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                .bend = {5.0 * newton_per_metre, 0.1 * newton_second_per_metre}};
    cloth.rigidity = rigidity;
    cloth.drag = drag;
    const auto parts = add_cloth(world, cloth);
    for (int i = 0; i < 3; ++i) world.step(frame);
    std::size_t all = 0;
    for (std::size_t i = 0; i < parts.structural.size(); i += 3) {
        if (!world.contains(parts.structural[i])) continue;
        auto spring = world.get(parts.structural[i]);
        spring.rest_length = 0.01 * metre;
        world.set(parts.structural[i], spring, breaks_at(0.5));
        all += during([&] { world.step(frame); });
    }
    return {all, world.tearing().split};
}
} // namespace

TEST_CASE("A warm step that tears a sheet and splits its vertices allocates nothing", "[soft_bodies][tearing]") {
    const Tearing<Splitting> tearing{.room = 200};
    const auto [forces, split] = in_steps_that_tear(
        World{SemiImplicitEuler{}, Springs<Breaking>{}, Bending{}, Wind{}, tearing}, 0.001 * joule, 1);
    CHECK(forces == 0);
    CHECK(split > 2);
    const auto [held, parted] =
        in_steps_that_tear(World{SemiImplicitEuler{}, Springs<Breaking>{}, Xpbd{2, 2}, tearing}, 0.0 * joule, 0);
    CHECK(held == 0);
    CHECK(parted > 2);
    const auto [coloured, coloured_split] = in_steps_that_tear(
        World{SemiImplicitEuler{}, Springs<Breaking>{}, ColouredXpbd{2, 2}, tearing}, 0.0 * joule, 0);
    CHECK(coloured == 0);
    CHECK(coloured_split > 2);
    const auto [descended, descended_split] = in_steps_that_tear(
        World{SemiImplicitEuler{}, Springs<Breaking>{}, VertexBlockDescent{2, 3}, tearing}, 0.0 * joule, 0);
    CHECK(descended == 0);
    CHECK(descended_split > 2);
}

TEST_CASE("A warm step with hinges and sails allocates nothing", "[soft_bodies][bending][wind]") {
    const Wind wind{metres_per_second(0, 0, 3)};
    CHECK(with_a_stiff_sheet_in_the_wind(World{SemiImplicitEuler{}, Springs<>{}, Bending{}, wind, Xpbd{2, 2}}) == 0);
    CHECK(with_a_stiff_sheet_in_the_wind(World{ImplicitEuler{}, Springs<>{}, Bending{}, wind}) == 0);
}

TEST_CASE("A warm step with a filling allocates nothing", "[soft_bodies][pressure]") {
    CHECK(with_a_filling(World{SemiImplicitEuler{}, Springs<>{}, Pressure{}}) == 0);
    CHECK(with_a_filling(World{SemiImplicitEuler{}, Springs<>{}, Pressure{}, Xpbd{2, 3}}) == 0);
    CHECK(with_a_filling(World{SemiImplicitEuler{}, Springs<>{}, Pressure{}, VertexBlockDescent{2, 3}}) == 0);
    CHECK(with_a_filling(World{ImplicitEuler{}, Springs<>{}, Pressure{}}) == 0);
}

TEST_CASE("A warm step of a solver allocates nothing", "[soft_bodies]") {
    REQUIRE(during([] { std::vector<int>(3).at(0) = 1; }) > 0); // the count counts
    CHECK(in_warm_steps(Xpbd{4, 1}) == 0);
    CHECK(in_warm_steps(Xpbd{2, 3}) == 0);
    CHECK(in_warm_steps(ColouredXpbd{2, 3}) == 0);
    CHECK(in_warm_steps(VertexBlockDescent{2, 3}) == 0);
}
