// SPDX-License-Identifier: BSL-1.0
// V2, R11: no support, no sleep. Whatever sleeps wakes in the step in which what holds it goes, whatever the response,
// the support and the way to go, and from there on falls as a body that nothing holds.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/penalty.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>

#include <random>

using namespace collision_tests;

namespace {

constexpr double dt = 1.0 / 60, g = 9.81;
constexpr double tall = 5; // m, of a support: a crate falls for half a second before it meets what lies under it

/// How a support goes.
enum class Way { velocity_down, velocity_aside, put_down, put_aside, put_a_little_aside, removed };
constexpr const char* name(Way way) {
    constexpr const char* names[] = {"goes down",    "goes aside",        "is put down",
                                     "is put aside", "is put just clear", "is removed"};
    return names[int(way)];
}
constexpr double far = 30; // m/s downwards, faster than what falls; m

template <class World_> void go(World_& world, Handle support, Way way) {
    const auto from = world.position(support);
    switch (way) {
    case Way::velocity_down: world.set_velocity(support, metres_per_second(0, -far, 0)); break;
    case Way::velocity_aside: world.set_velocity(support, metres_per_second(1e4, 0, 0)); break;
    case Way::put_down: world.set_position(support, from + metres(0, -far, 0)); break;
    case Way::put_aside: world.set_position(support, from + metres(far, 0, 0)); break;
    case Way::put_a_little_aside: world.set_position(support, from + metres(2.6, 0, 0)); break;
    case Way::removed: world.remove(support); break;
    }
}

/// A crate that sleeps, on a support that is asleep with it if it is a body.
template <class World_> struct Asleep {
    World_ world;
    Handle support, crate;
    Asleep(const World_& empty, Motion kind) : world(empty) {
        const auto shape = Box{metres(2, tall / 2, 2)};
        const auto rubs = friction(0.5);
        if (kind == Motion::fixed) support = world.add(shape, fixed, rubs);
        else if (kind == Motion::moving) support = world.add(shape, moving, rubs);
        else {
            world.add(Box{metres(2, 0.5, 2)}, position(metres(0, -tall / 2 - 0.5, 0)), fixed, rubs);
            support = world.add(shape, mass(5.0 * kilogram), rubs);
        }
        crate = world.add(Sphere{0.5 * metre}, position(metres(0, tall / 2 + 0.5, 0)), mass(2.0 * kilogram), rubs);
        for (int i = 0; i < 900 && world.motion(crate) == Motion::awake; ++i) world.step(dt * second);
        run(world, 30, dt); // and stays so
    }
    bool sleeps() const { return world.motion(crate) == Motion::resting; }
};

/// \param held_so_long steps in which it may still have been held
template <class World_> void check_falls(World_ world, Handle crate, int held_so_long) {
    double before = height_of(world, crate);
    world.step(dt * second);
    CHECK(world.motion(crate) == Motion::awake);
    if (held_so_long > 0) before = height_of(world, crate);
    run(world, 29 + held_so_long, dt);
    CHECK(before - height_of(world, crate) >= 0.99 * 0.5 * g * 0.25);
}

/// What becomes of a body that lies on another.
enum class Pile { not_held, perhaps_asleep, asleep };

template <class... P> void check_all(Pile pile, P... policies) {
    const World empty{
        SemiImplicitEuler{},        Gravity{},       AppliedForces{}, Rest{}, policies..., BoundingBoxes{},
        Narrowphase<Sphere, Box>{}, Keep<Friction>{}};
    for (const auto kind : {Motion::fixed, Motion::moving, Motion::resting, Motion::awake}) {
        INFO("on a support that is " << ansatz::name_of(kind));
        const bool alone = kind == Motion::fixed || kind == Motion::moving;
        if (!alone && pile == Pile::not_held) continue;
        const Asleep asleep(empty, kind);
        if (alone || pile == Pile::asleep) REQUIRE(asleep.sleeps());
        for (const auto way : {Way::velocity_down, Way::velocity_aside, Way::put_down, Way::put_aside,
                               Way::put_a_little_aside, Way::removed}) {
            const bool by_velocity = way == Way::velocity_down || way == Way::velocity_aside;
            if (kind == Motion::fixed && by_velocity) continue;
            if (!alone && (way == Way::velocity_down || way == Way::put_down)) continue; // into its ground
            INFO("that " << name(way));
            auto world = asleep.world;
            if (kind == Motion::awake) world.wake(asleep.support);
            go(world, asleep.support, way);
            check_falls(world, asleep.crate, way == Way::velocity_aside); // it was there when that step began
        }
        if (!asleep.sleeps()) continue;
        INFO("that stays");
        auto wakes_by = [&](const char* what, auto&& act) {
            INFO(what);
            auto world = asleep.world;
            act(world);
            world.step(dt * second);
            CHECK(world.motion(asleep.crate) == Motion::awake);
        };
        wakes_by("a force", [&](auto& world) { world.apply_force(asleep.crate, newtons(0.01, 0, 0)); });
        wakes_by("an impulse", [&](auto& world) { world.apply_impulse(asleep.crate, newton_seconds(0.001, 0, 0)); });
        wakes_by("gravity", [&](auto& world) { world.set(Gravity{metres_per_second_squared(0, -g / 2, 0)}); });
        wakes_by("a hit at 0.01 m/s",
                 [&](auto& world) { // it touches in the very next step, and falls less than it is large in it
                     const auto beside = world.position(asleep.crate) + metres(1 + 0.5e-2 * dt, 0, 0);
                     world.add(Sphere{0.5 * metre}, position(beside), velocity(metres_per_second(-0.01, 0, 0)),
                               mass(1.0 * kilogram));
                 });
        auto world = asleep.world;
        world.set(Gravity{metres_per_second_squared(0, g, 0)});
        const double before = height_of(world, asleep.crate);
        run(world, 30, dt);
        CHECK(height_of(world, asleep.crate) - before >= 0.99 * 0.5 * g * 0.25);
    }
}

} // namespace

TEST_CASE("V2: no support, no sleep: a support that goes wakes bodies that sleep on it, which fall",
          "[collision][V2][R11]") {
    SECTION("Impulse") { check_all(Pile::not_held, Impulse<>{}); }
    SECTION("Impulse with friction, and Projection") {
        check_all(Pile::perhaps_asleep, Impulse<Friction>{}, Projection{});
    }
    SECTION("Impulse, and Projection that leaves a slop") {
        check_all(Pile::perhaps_asleep, Impulse<Friction>{}, Projection{1e-3 * metre});
    }
    SECTION("Penalty") { check_all(Pile::asleep, Penalty{5e3 * newton_per_metre, 50.0 * newton_second_per_metre}); }
    SECTION("SoftSubsteps with friction") { check_all(Pile::asleep, SoftSubsteps<Friction>{}); }
}

namespace {
/// Between two walls, in a gap as wide as given, under gravity along the walls.
auto between_walls(double gap, double gravity, double mu) {
    World world{SemiImplicitEuler{},
                Gravity{metres_per_second_squared(0, -gravity, 0)},
                AppliedForces{},
                Rest{},
                SoftSubsteps<Friction>{},
                BoundingBoxes{},
                Narrowphase<Sphere, Box>{},
                Keep<Friction>{}};
    for (const double side : {-1, 1})
        world.add(Box{metres(1, 50, 1)}, position(metres(side * (1 + gap / 2), 0, 0)), fixed, friction(mu));
    return world;
}
} // namespace

TEST_CASE("R12: what is held by friction alone falls asleep, and wakes when what presses it goes",
          "[collision][rest][R12]") {
    for (const double mu : {0.3, 0.9})
        for (const int n : {1, 3}) {
            INFO(n << " in a row, friction " << mu);
            // Pressed so much that friction carries them: no normal points upwards.
            auto world = between_walls(n - 0.01, 9.81, mu);
            std::vector<Handle> balls;
            for (int i = 0; i < n; ++i)
                balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(i - (n - 1) / 2.0, 0, 0)),
                                          mass(0.1 * kilogram), friction(mu)));
            run(world, 120, dt);
            CHECK(height_of(world, balls[0]) > -0.1); // or it is no test
            CHECK(world.count(Motion::resting) == std::size_t(n));
            const double before = height_of(world, balls[0]);
            world.set_position(world.body_at(world.size() - 1), metres(50, 0, 0));
            run(world, 31, dt);
            CHECK(before - height_of(world, balls[0]) >= 0.99 * 0.5 * 9.81 * 0.25);
        }
}

TEST_CASE("R9: nothing falls asleep on its way down a wall, rough or not, however weak gravity is",
          "[collision][rest][R9]") {
    for (const double gravity : {0.01, 0.1, 1.62, 9.81})
        for (const double gap : {1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.2})
            for (const double thrown : {0.0, 0.04}) {
                INFO("g = " << gravity << " m/s^2, in a gap of " << gap << " m, thrown at " << thrown << " m/s");
                auto world = between_walls(gap, gravity, 0.5);
                const auto ball =
                    world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), velocity(metres_per_second(0, thrown, 0)),
                              mass(1.0 * kilogram), friction(0.5));
                bool slept = false;
                for (int i = 0; i < 300; ++i) {
                    world.step(dt * second);
                    slept = slept || world.motion(ball) != Motion::awake;
                }
                CHECK_FALSE(slept);
            }
}

TEST_CASE("R9: what slides down a slope without friction does not fall asleep on it, however weak gravity is",
          "[collision][rest][R9]") {
    for (const double gravity : {0.01, 0.1, 1.62, 9.81})
        for (const double slope : {0.2, 0.5, 1.0}) {
            INFO("g = " << gravity << " m/s^2, slope " << slope);
            // The wall stands upright, and gravity leans.
            World world{SemiImplicitEuler{},
                        Gravity{metres_per_second_squared(gravity * std::sin(slope), -gravity * std::cos(slope), 0)},
                        AppliedForces{},
                        Rest{},
                        SoftSubsteps<Friction>{},
                        BoundingBoxes{},
                        Narrowphase<Sphere, Box>{},
                        Keep<Friction>{}};
            world.add(Box{metres(100, 1, 1)}, position(metres(0, -1, 0)), fixed);
            const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
            run(world, 180, dt);
            const double a = gravity * std::sin(slope);
            CHECK(std::abs(x_of(world, ball) - a * 9 / 2) <= 0.02 * a * 9 / 2);
        }
}

TEST_CASE("R12: piles with friction fall asleep, however rough", "[collision][rest][R12]") {
    for (const double mu : {0.1, 0.5, 0.9})
        for (const unsigned seed : {0u, 1u}) {
            INFO("friction " << mu << ", seed " << seed);
            auto world = between_walls(3, 9.81, mu);
            world.add(Box{metres(10, 1, 10)}, position(metres(0, -1, 0)), fixed, friction(mu));
            for (const double side : {-1, 1}) {
                world.add(Box{metres(10, 10, 1)}, position(metres(0, 9, side * 2.5)), fixed, friction(mu));
                // The walls that are there leave gaps as wide as a ball.
                world.add(Box{metres(1, 10, 10)}, position(metres(side * 2.5, 9, 0)), fixed, friction(mu));
            }
            std::mt19937 random(seed);
            const auto beside = [&] { return 0.08 * (double(random() % 2001) / 1000 - 1); };
            for (int i = 0; i < 160; ++i)
                world.add(Sphere{0.25 * metre},
                          position(metres(-1.05 + 0.7 * (i % 4) + beside(), 0.4 + 0.7 * (i / 16),
                                          -1.05 + 0.7 * (i / 4 % 4) + beside())),
                          mass(1.0 * kilogram), friction(mu));
            int steps = 0;
            for (; world.count(Motion::awake) > 0 && steps < 1200; ++steps) world.step(dt * second);
            INFO("after " << steps << " steps");
            CHECK(world.count(Motion::resting) == 160);
        }
}
