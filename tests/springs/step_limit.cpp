// SPDX-License-Identifier: BSL-1.0
// Steps that are too long for the springs of a world: refused with the number, or divided.

#include <ansatz/collision.hpp>
#include <ansatz/springs/step_limit.hpp>

#include "tests/springs/support.hpp"

using namespace spring_tests;
using Catch::Matchers::ContainsSubstring;

namespace {
template <class I, class... More> auto stiff(double k, More... more) {
    World world{I{}, Springs{}, more...};
    const auto body = world.add(position(metres(1.001, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{metres(0, 0, 0), body, k * N_per_m, {}, 1.0 * metre});
    return world;
}
} // namespace

TEST_CASE("a step beyond the limit is refused with the longest that would do, and nothing has happened", "[springs]") {
    auto world = stiff<SemiImplicitEuler>(1e6, StepLimit<Refuse>{});
    const auto before = world.hash();
    CHECK_THROWS_WITH(world.step(1.0 / 60 * second),
                      ContainsSubstring("World::step: dt is 0.01666666666666666") &&
                          ContainsSubstring("the longest that is stable for these springs is 0.002 s;") &&
                          ContainsSubstring("StepLimit<Divide>, or ImplicitEuler"));
    CHECK(world.hash() == before);
    CHECK(world.tick() == 0);
    world.step(0.002 * second); // as the sentence says
    CHECK(world.tick() == 1);
    auto careful = stiff<SemiImplicitEuler>(1e6, StepLimit<Refuse>{.part = 0.5});
    CHECK_THROWS_AS(careful.step(0.0019 * second), std::invalid_argument);
    careful.step(0.00099 * second);
    auto never = stiff<ExplicitEuler>(1, StepLimit<Divide>{});
    CHECK_THROWS_WITH(never.step(1e-6 * second), ContainsSubstring("this integrator grows with every step"));
    auto implicit = stiff<ImplicitEuler>(1e6, StepLimit<Refuse>{});
    implicit.step(10.0 * second);
    CHECK(implicit.tick() == 1);
}

TEST_CASE("a refused step leaves the contacts that act in the next one as they were", "[springs]") {
    World world{SemiImplicitEuler{},   Gravity{}, Springs{}, StepLimit<Refuse>{}, AllPairs{},
                Narrowphase<Sphere>{}, Penalty{}};
    const auto a = world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(0.9, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{a, b, 1e6 * N_per_m});
    for (int i = 0; i < 8; ++i) {
        CAPTURE(i);
        const auto before = world.hash();
        const auto copy = world;
        CHECK_THROWS_AS(world.step(0.1 * second), std::invalid_argument);
        CHECK(world.hash() == before);
        auto never_asked = copy;
        never_asked.step(0.0005 * second);
        world.step(0.0005 * second);
        CHECK(world.hash() == never_asked.hash());
        world.set_position(b, metres(0.9 - 0.05 * i, 0, 0)); // what acts next is to be found anew
    }
}

TEST_CASE("a divided step is so many steps, to the bit, and lasts as long as it was asked to", "[springs]") {
    auto divided = stiff<VelocityVerlet>(1e6, StepLimit<Divide>{}, Gravity{});
    auto by_hand = stiff<VelocityVerlet>(1e6, Gravity{});
    for (int i = 0; i < 60; ++i) divided.step(1.0 / 60 * second);
    for (int i = 0; i < 60 * 9; ++i) by_hand.step(1.0 / 60 / 9 * second);
    CHECK(divided.tick() == 540); // 16.7 ms in substeps of at most 2 ms
    CHECK(divided.time().value() == Approx(1).epsilon(1e-15));
    CHECK(divided.position(divided.handles()[0]) == by_hand.position(by_hand.handles()[0]));
    CHECK(divided.hash() == by_hand.hash());
    auto soft = stiff<VelocityVerlet>(10, StepLimit<Divide>{});
    soft.step(1.0 / 60 * second);
    CHECK(soft.tick() == 1);
    auto too_many = stiff<VelocityVerlet>(1e6, StepLimit<Divide>{.most_parts = 8});
    CHECK_THROWS_WITH(too_many.step(1.0 / 60 * second), ContainsSubstring("and most_parts is 8"));
    CHECK(too_many.tick() == 0);
}

TEST_CASE("the limit follows the springs and the masses as they change", "[springs]") {
    auto world = stiff<SemiImplicitEuler>(100, StepLimit<Divide>{});
    const auto body = world.handles()[0];
    world.step(0.19 * second);
    CHECK(world.tick() == 1);
    const auto stiffer = world.add(Spring{metres(0, 0, 0), body, 300.0 * N_per_m, {}, 1.0 * metre});
    world.step(0.19 * second); // omega 20/s: the limit is 0.1 s
    CHECK(world.tick() == 3);
    world.set_mass(body, 0.25 * kilogram);
    world.step(0.19 * second);
    CHECK(world.tick() == 7);
    world.remove(stiffer);
    world.step(0.19 * second);
    CHECK(world.tick() == 9);
}

TEST_CASE("a force from outside acts in every part of a divided step, and what happened in any of them is told",
          "[springs]") {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, AppliedForces{}, StepLimit<Divide>{}};
    const auto pushed = world.add(position(metres(5, 0, 0)), mass(2.0 * kilogram));
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{metres(0, 0, 0), body, 1e6 * N_per_m, {}, 1.0 * metre},
              breaks_at(500.0 * newton)); // in the first millisecond
    world.apply_force(pushed, newtons(10, 0, 0));
    world.step(0.1 * second);
    CHECK(world.tick() >= 50);
    CHECK(x(world.velocity(pushed)).value() == Approx(0.5));
    CHECK(world.elements<Spring>().broken().size() == 1);
    world.step(0.1 * second);
    CHECK(x(world.velocity(pushed)).value() == Approx(0.5)); // it ended with its step
    CHECK(world.elements<Spring>().broken().empty());
}

TEST_CASE("a force between bodies that does not say how stiff it is stands beside springs, and is not counted",
          "[springs]") {
    World world{SemiImplicitEuler{}, Springs{}, Attraction{}, StepLimit<Refuse>{}};
    const auto body = world.add(position(metres(1.1, 0, 0)), mass(1.0 * kilogram));
    world.add(Spring{metres(0, 0, 0), body, 100.0 * N_per_m, {}, 1.0 * metre});
    CHECK(in(stable_step(world), second) == Approx(0.2));
    CHECK(measured_stiffness(world).value() == Approx(100));
    CHECK_THROWS_AS(world.step(0.201 * second), std::invalid_argument);
    world.step(0.199 * second);
    World alone{SemiImplicitEuler{}, Attraction{}};
    CHECK(!is_finite(stable_step(alone)));
}

TEST_CASE("what broke in one substep of a divided step is gone once, whatever substeps follow", "[springs]") {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, StepLimit<Divide>{}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto first = world.add(Spring{metres(0, 0, 0), body, 1e6 * N_per_m, {}, 1.0 * metre},
                                 breaks_at(500.0 * newton)); // in the first part
    const auto later = world.add(Spring{metres(0, 0, 0), body, 1.0 * N_per_m, {}, 1.0 * metre},
                                 breaks_at(0.03 * newton)); // in another
    const auto stays = world.add(Spring{metres(0, 0, 0), body, 1.0 * N_per_m, {}, 1.0 * metre});
    world.step(0.1 * second);
    REQUIRE(world.tick() >= 50);
    CHECK(broken<Spring>(world).size() == 2);
    CHECK(world.elements<Spring>().size() == 1);
    CHECK((!world.contains(first) && !world.contains(later) && world.contains(stays)));
    const auto one = world.add(Spring{metres(0, 0, 0), body, 2.0 * N_per_m}),
               other = world.add(Spring{metres(0, 0, 0), body, 3.0 * N_per_m});
    CHECK(one.generation == 1);
    CHECK(one.id != other.id);
    CHECK(world.get(one).stiffness.value() == 2);
    CHECK(world.elements<Spring>().size() == 3);
}

TEST_CASE("a divided step is drawn as the one that it is: from where bodies were before all of its substeps",
          "[springs]") {
    for_each_type(Types<SemiImplicitEuler, Verlet, RungeKutta4>{}, [&]<class I>() {
        World world{I{}, Springs{}, Interpolation{}, Drag{0.1 / second}, StepLimit<Divide>{}};
        const auto body = world.add(position(metres(1.1, 0, 0)), mass(1.0 * kilogram));
        const auto platform = world.add(position(metres(0, 0, 0)), velocity(metres_per_second(1, 0, 0)), moving);
        world.add(Spring{platform, body, 1e5 * N_per_m, {}, 1.0 * metre});
        for (int i = 0; i < 3; ++i) {
            const auto before = world.tick();
            const auto x = world.position(body), at = world.position(platform);
            world.step(1.0 / 60 * second);
            CHECK(world.tick() - before >= 2);
            CHECK(interpolated_position(world, body, 0.0) == x);
            CHECK(interpolated_position(world, platform, 0.0) == at);
            CHECK(interpolated_position(world, body, 1.0).value().isApprox(world.position(body).value()));
        }
    });
}

TEST_CASE("parameters of StepLimit that cannot be are refused", "[springs]") {
    CHECK_THROWS_WITH(stiff<Verlet>(1, StepLimit<Divide>{.part = 0}), ContainsSubstring("StepLimit: part is 0"));
    CHECK_THROWS_WITH(stiff<Verlet>(1, StepLimit<Divide>{.part = 1.5}), ContainsSubstring("StepLimit: part is 1.5"));
    CHECK_THROWS_WITH(stiff<Verlet>(1, StepLimit<Divide>{.most_parts = 0}),
                      ContainsSubstring("StepLimit: most_parts is 0"));
}
