// SPDX-License-Identifier: BSL-1.0
// What is held by a solver of positions, and falls asleep: there is no force that would say how strongly it is held.

#include "tests/soft_bodies/support.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/soft_bodies.hpp>

using namespace soft_tests;

namespace {
/// A body that is let go on a stretched spring, slowly: a swing in 21 s, or 0.04 1/s of its way on a damper.
template <class... P> void is_let_go(double k, double c, P... policies) {
    const auto go = [&](auto world) {
        const auto body = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
        world.add(Spring{.first = body,
                         .second = metres(0, 0, 0),
                         .stiffness = k * N_per_m,
                         .damping = c * N_s_per_m,
                         .rest_length = 0.0 * metre});
        run(world, 600, 1.0 / 60);
        return double(world.position(body).value()[0]);
    };
    const double without = go(World{SemiImplicitEuler{}, Springs{}, policies...});
    INFO("k = " << k << ", c = " << c << ", without Rest at " << without);
    CHECK(go(World{SemiImplicitEuler{}, Springs{}, Rest{}, policies...}) == without);
    CHECK(without < 0.7);
}
template <class Solver> void falls_asleep_on_the_ground() {
    World world{SemiImplicitEuler{},          Gravity{},       Springs{}, Rest{}, Solver{}, BoundingBoxes{},
                Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}};
    world.add(Plane::ground(), fixed);
    std::vector<Handle> ends;
    for (const double x : {0.0, 0.3})
        ends.push_back(world.add(Sphere{0.1 * metre}, position(metres(x, 0.1, 0)), mass(1.0 * kilogram)));
    world.add(Spring{.first = ends[0], .second = ends[1], .stiffness = 100.0 * N_per_m, .damping = 1.0 * N_s_per_m});
    run(world, 300, 1.0 / 60);
    CHECK(world.count(Motion::resting) == 2);
}
} // namespace

TEMPLATE_TEST_CASE("R13 what a solver holds does not fall asleep on its way", "[soft_bodies][rest][R13]", Xpbd,
                   ColouredXpbd, VertexBlockDescent) {
    is_let_go(0.09, 0, TestType{});
    is_let_go(4, 100, TestType{});
}

TEMPLATE_TEST_CASE("what lies on the ground falls asleep, though a solver holds it", "[soft_bodies][rest][R12]", Xpbd,
                   ColouredXpbd, VertexBlockDescent) {
    falls_asleep_on_the_ground<TestType>();
}

TEMPLATE_TEST_CASE("what sleeps wakes where its hook is put so far away that a slack rope is taut",
                   "[soft_bodies][rest]", Xpbd, ColouredXpbd, VertexBlockDescent) {
    const bool is_fixed = GENERATE(true, false);
    CAPTURE(is_fixed);
    World world{SemiImplicitEuler{},          Gravity{},       Ropes{}, Rest{}, TestType{}, BoundingBoxes{},
                Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}};
    world.add(Plane::ground(), fixed);
    const auto high = position(metres(0, 2, 0));
    const auto hook = is_fixed ? world.add(high, shapeless, fixed) : world.add(high, shapeless, moving);
    const auto body = world.add(Sphere{0.1 * metre}, position(metres(0, 0.1, 0)), mass(1.0 * kilogram));
    const auto beside = world.add(Sphere{0.1 * metre}, position(metres(1, 0.1, 0)), mass(1.0 * kilogram));
    world.add(Rope{hook, body, 200.0 * N_per_m, 5.0 * N_s_per_m, 3.0 * metre});
    run(world, 300, 1.0 / 60);
    REQUIRE(world.count(Motion::resting) == 2);
    auto woken = world;
    woken.wake(body);
    for (auto* one : {&world, &woken}) {
        one->set_position(hook, metres(0, 4, 0));
        run(*one, 20, 1.0 / 60);
    }
    CHECK(world.position(body).value()[1] > 0.5);
    CHECK(world.position(body) == woken.position(body));
    CHECK(world.motion(beside) == Motion::resting);
}
