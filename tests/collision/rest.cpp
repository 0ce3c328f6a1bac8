// SPDX-License-Identifier: BSL-1.0
// What sleeps and what wakes where bodies collide: hard cases R5, R9 to R12, and removed loads (R7).

#include "tests/collision/support.hpp"

#include <ansatz/collision/contact_step.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/collision/step.hpp>
#include <ansatz/collision/substeps.hpp>
#include <ansatz/motion/islands.hpp>
#include <ansatz/motion/sleep.hpp>
#include <ansatz/springs.hpp>

using namespace collision_tests;

namespace {
template <class S = Space<>, class... P> auto with_rest(P... policies) {
    return world_of(SemiImplicitEuler{}, S{}, Gravity{}, Rest{}, policies...);
}
constexpr double dt = 1.0 / 60;

/// A column of n spheres of radius 0.5 m on the ground, from below; the masses in kg.
template <class World_> std::vector<Handle> column(World_& world, std::vector<double> masses, double gap = 0) {
    using S = typename World_::S;
    world.add(Plane::ground(), fixed);
    std::vector<Handle> bodies;
    for (std::size_t i = 0; i < masses.size(); ++i)
        bodies.push_back(
            world.add(Sphere{0.5 * metre}, at<S>(0, 0.5 + double(i) * (1 + gap)), mass(masses[i] * kilogram)));
    return bodies;
}
} // namespace

TEST_CASE("islands: what is united is one, and the smallest stands for it", "[collision][rest]") {
    Islands islands;
    islands.reset(6);
    islands.unite(4, 2);
    islands.unite(5, 4);
    islands.unite(0, 1);
    CHECK((islands.of(5) == 2 && islands.of(4) == 2 && islands.of(1) == 0 && islands.of(3) == 3));
    islands.unite(1, 5);
    CHECK((islands.of(5) == 0 && islands.of(2) == 0));
}

TEST_CASE("R5: a column of ten spheres stands, lies still and falls asleep", "[collision][rest]") {
    for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S>() {
        auto world = with_rest<S>(SoftSubsteps<>{});
        const auto bodies = column(world, std::vector<double>(10, 1.0), 0.05);
        run(world, 600, dt);
        const bool wide = std::is_same_v<typename S::Scalar, double>;
        double energy = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            CHECK(std::abs(x_of(world, bodies[i])) <= (wide ? 1e-6 : 1e-5));
            CHECK(std::abs(height_of(world, bodies[i]) - (0.5 + double(i))) <= 0.01 * double(i + 1));
            energy += 0.5 * double(squared_norm(world.velocity(bodies[i])).value());
        }
        CHECK(energy / 10 < (wide ? 1e-9 : 1e-5));
        CHECK(world.count(Motion::resting) == 10);
    });
}

TEST_CASE("R9: nothing falls asleep in the air, however weak gravity is", "[collision][rest]") {
    for (const double g : {0.01, 0.1, 1.62, 9.81})
        for (const double thrown : {0.0, 0.04}) {
            auto world = with_rest(Impulse<>{}, Projection{1e-3 * metre});
            world.set(Gravity{metres_per_second_squared(0, -g, 0)});
            // Two that touch each other, side by side and one upon the other, hold no body.
            const auto a =
                world.add(Sphere{0.5 * metre}, at<Space<>>(0, 100), going<Space<>>(0, thrown), mass(1.0 * kilogram));
            const auto b = world.add(Sphere{0.5 * metre}, at<Space<>>(0.9999, 100), going<Space<>>(0, thrown),
                                     mass(1.0 * kilogram));
            const auto c = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 100.9999), going<Space<>>(0, thrown),
                                     mass(1.0 * kilogram));
            world.add(Plane::ground(), fixed);
            for (int i = 0; i < 120; ++i) {
                world.step(dt * second);
                CHECK((world.motion(a) == Motion::awake && world.motion(b) == Motion::awake &&
                       world.motion(c) == Motion::awake));
            }
            CHECK(std::abs(height_of(world, b) - (100 + 2 * thrown - 2 * g)) <= 0.05 * g + 0.01);
        }
}

TEST_CASE("R10: asleep is exactly still, and no other body notices", "[collision][rest]") {
    auto sleepy = with_rest(SoftSubsteps<>{});
    auto awake = world_of(SemiImplicitEuler{}, Space<>{}, Gravity{}, SoftSubsteps<>{});
    auto fill = [](auto& world) {
        const auto below = column(world, {1, 1, 1});
        const auto flying =
            world.add(Sphere{0.5 * metre}, at<Space<>>(100, 1000), going<Space<>>(3), mass(1.0 * kilogram));
        return std::pair(below, flying);
    };
    const auto [bodies, flying] = fill(sleepy);
    fill(awake);
    run(sleepy, 300, dt);
    run(awake, 300, dt);
    for (const auto body : bodies) {
        CHECK(sleepy.motion(body) == Motion::resting);
        CHECK((sleepy.velocity(body).value().norm() == 0));
    }
    CHECK(sleepy.position(flying) == awake.position(flying)); // to the bit
    CHECK(sleepy.velocity(flying) == awake.velocity(flying));
    CHECK(sleepy.contacts().size() == 3); // kept while they sleep
}

TEST_CASE("R11: a hit, a force, a change of gravity, and a support that is taken away wake in the same step",
          "[collision][rest]") {
    auto asleep = [] {
        auto world = with_rest(SoftSubsteps<>{});
        const auto bodies = column(world, {1, 1, 1});
        run(world, 240, dt);
        REQUIRE(world.count(Motion::resting) == 3);
        return std::pair(world, bodies);
    };
    SECTION("the lowest is removed") {
        auto [world, bodies] = asleep();
        const double before = height_of(world, bodies[2]);
        world.remove(bodies[0]);
        run(world, 15, dt);
        CHECK(world.count(Motion::awake) == 2);
        CHECK(before - height_of(world, bodies[2]) >= 0.99 * 0.5 * 9.81 * 0.0625);
    }
    SECTION("the lowest is put aside") {
        auto [world, bodies] = asleep();
        world.set_position(bodies[0], metres(5, 0.5, 0));
        run(world, 15, dt);
        CHECK(world.count(Motion::awake) >= 2);
        CHECK(height_of(world, bodies[1]) < 1.3);
    }
    SECTION("hit slowly") {
        auto [world, bodies] = asleep();
        world.add(Sphere{0.5 * metre}, position(metres(1.0001, 0.5, 0)), velocity(metres_per_second(-0.01, 0, 0)),
                  mass(1.0 * kilogram));
        run(world, 2, dt);
        CHECK(world.count(Motion::awake) == 4);
    }
    SECTION("gravity turns round") {
        auto [world, bodies] = asleep();
        world.set(Gravity{metres_per_second_squared(0, 9.81, 0)});
        run(world, 60, dt);
        CHECK(world.count(Motion::awake) == 3);
        CHECK(height_of(world, bodies[0]) > 4);
    }
    SECTION("an impulse on the lowest wakes all of them") {
        auto [world, bodies] = asleep();
        world.apply_impulse(bodies[0], newton_seconds(0.5, 0, 0));
        run(world, 2, dt);
        CHECK(world.count(Motion::awake) == 3);
    }
}

TEST_CASE("a platform that begins to move wakes bodies that sleep on it, and carries them", "[collision][rest]") {
    auto world = with_rest(SoftSubsteps<>{});
    const auto lift = world.add(Box{metres(2, 0.5, 2)}, position(metres(0, 0, 0)), moving);
    const auto crate = world.add(Sphere{0.5 * metre}, position(metres(0, 1, 0)), mass(1.0 * kilogram));
    run(world, 120, dt);
    REQUIRE(world.motion(crate) == Motion::resting);
    world.set_velocity(lift, metres_per_second(0, 1, 0));
    run(world, 60, dt);
    CHECK(world.motion(crate) == Motion::awake);
    CHECK(std::abs(height_of(world, crate) - 2) <= 0.02);
}

TEST_CASE("R12: a pile of 300 with friction falls asleep, and stays so", "[collision][rest]") {
    auto world = with_rest<Space<float, 3>>(SoftSubsteps<Friction>{});
    using S = Space<float, 3>;
    const auto wall = [&](double x, double z) {
        world.add(Plane{Eigen::Vector3d(x, 0, z), -1.5 * metre}, fixed, friction(0.3));
    };
    world.add(Plane::ground(), fixed, friction(0.3));
    wall(1, 0);
    wall(-1, 0);
    wall(0, 1);
    wall(0, -1);
    for (int i = 0; i < 300; ++i)
        world.add(Sphere{0.2 * metre},
                  at<S>(-1.2 + 0.45 * (i % 6) + 0.01 * (i % 7), 0.5 + 0.45 * (i / 36),
                        -1.2 + 0.45 * (i / 6 % 6) + 0.01 * (i % 5)),
                  mass(1.0 * kilogram), friction(0.3));
    int steps = 0;
    while (world.count(Motion::awake) > 0 && steps < 600) {
        world.step(dt * second);
        ++steps;
    }
    INFO("asleep after " << steps << " steps");
    CHECK(world.count(Motion::resting) == 300);
    const auto before = world.position(world.handles().back());
    run(world, 120, dt);
    CHECK(world.count(Motion::resting) == 300);
    CHECK(world.position(world.handles().back()) == before);
}

TEST_CASE("a tower that wakes stands on the impulses that it fell asleep with", "[collision][rest]") {
    auto world = world_of(SemiImplicitEuler{}, Space<>{}, Gravity{}, Rest{1e-6 * metre_per_second},
                          SoftSubsteps<>{}); // it falls asleep settled
    const auto bodies = column(world, std::vector<double>(10, 1.0));
    run(world, 3000, dt);
    REQUIRE(world.count(Motion::resting) == 10);
    const double before = height_of(world, bodies.back());
    world.apply_impulse(bodies.back(), newton_seconds(0, -1e-9, 0));
    double sunk = 0;
    for (int i = 0; i < 20; ++i) {
        world.step(dt * second);
        sunk = std::max(sunk, before - height_of(world, bodies.back()));
    }
    INFO("sinks " << sunk << " m");
    CHECK(world.count(Motion::awake) == 10);
    CHECK(sunk <= 1e-5);
}

TEST_CASE("R7: a heavy load that is taken away does not throw up what it lay on", "[collision][rest]") {
    auto world = world_of(SemiImplicitEuler{}, Space<>{}, Gravity{}, SoftSubsteps<>{});
    const auto bodies = column(world, {1, 1, 100});
    run(world, 120, dt);
    const double before = height_of(world, bodies[1]);
    world.remove(bodies[2]);
    double rise = 0, speed = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(dt * second);
        rise = std::max(rise, height_of(world, bodies[1]) - before);
        speed = std::abs(speed_along(world, bodies[1], 1));
    }
    INFO("rises " << rise << " m");
    CHECK(rise <= 2 - before + 1e-3); // no further than to where it only touches
    CHECK(speed <= 0.05);
}

TEST_CASE("what lies in each other is separated before it falls asleep, however deep it is", "[collision][rest]") {
    const auto separated = [](const auto& start, double radius, double depth, bool sleep = true) {
        using S = typename std::remove_cvref_t<decltype(start)>::S;
        auto world = start;
        world.add(Plane::ground(), fixed);
        const auto sunk = world.add(Sphere{radius * metre}, at<S>(8 * radius, radius - depth), mass(1.0 * kilogram));
        std::vector<Handle> two;
        for (const double y : {radius, 3 * radius - depth})
            two.push_back(world.add(Sphere{radius * metre}, at<S>(0, y), mass(1.0 * kilogram)));
        run(world, 1200, dt);
        INFO("radius " << radius << " m, " << depth << " m deep");
        if (sleep) CHECK(world.count(Motion::resting) == 3);
        CHECK(height_of(world, sunk) >= radius - 1e-3);
        CHECK(norm(world.position(two[0]) - world.position(two[1])).value() >= 2 * radius - 1e-3);
    };
    for (const double radius : {0.5, 1.0, 2.0})
        for (const double share : {0.1, 0.8, 1.9}) {
            separated(with_rest(SoftSubsteps<>{}), radius, share * radius);
            separated(with_rest<Space<float, 2>>(SoftSubsteps<Friction>{}), radius, share * radius);
            separated(world_of(Verlet{}, Gravity{}, Rest{}, SoftSubsteps<>{}), radius, share * radius);
            separated(with_rest(Impulse{}, Projection{}), radius, share * radius, false); // columns may stay awake
        }
}

TEST_CASE("what sleeps wakes when what it lies on lets it through, or when something is put into it",
          "[collision][rest]") {
    auto asleep = [](auto& world, const auto&... more) {
        const auto ground = world.add(Plane::ground(), fixed);
        const auto ball = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 0.5), mass(1.0 * kilogram), more...);
        run(world, 200, dt);
        REQUIRE(world.motion(ball) == Motion::resting);
        return std::pair(ground, ball);
    };
    SECTION("the ground is ignored from now on") {
        auto world = with_rest(SoftSubsteps<>{}, Layers{});
        const auto [ground, ball] = asleep(world, member_of(1));
        world.write<Ignored>(ground, Quantity<unit::Dimensionless>(1.0));
        CHECK(world.motion(ball) == Motion::awake);
        run(world, 30, dt);
        CHECK(height_of(world, ball) < 0);
    }
    SECTION("a wall is put into it, or added there") {
        for (const bool added : {false, true}) {
            auto world = with_rest(SoftSubsteps<>{});
            const auto wall = world.add(Box{metres(0.5, 0.5, 0.5)}, at<Space<>>(10, 0.5), fixed);
            const auto [ground, ball] = asleep(world);
            if (added) world.add(Box{metres(0.5, 0.5, 0.5)}, at<Space<>>(0.9, 0.5), fixed);
            else world.set_position(wall, metres(0.9, 0.5, 0));
            CHECK(world.motion(ball) == Motion::awake);
            run(world, 200, dt);
            CHECK(x_of(world, ball) < -0.05);
        }
    }
    SECTION("what is put elsewhere wakes nobody") {
        auto world = with_rest(SoftSubsteps<>{});
        const auto wall = world.add(Box{metres(0.5, 0.5, 0.5)}, at<Space<>>(10, 0.5), fixed);
        const auto [ground, ball] = asleep(world);
        world.set_position(wall, metres(1.5, 0.5, 0));
        CHECK(world.motion(ball) == Motion::resting);
    }
}

TEST_CASE("a body that is put to rest in the air falls, also with the id of one that slept on the ground",
          "[collision][rest]") {
    for (const bool with_an_old_id : {false, true}) {
        // Where bodies pull at each other, sleepers are tested in every step.
        auto world = with_rest(Springs{}, SoftSubsteps<>{});
        const auto slept = column(world, {1.0}).front();
        world.add(Sphere{0.5 * metre}, position(metres(5, 1e3, 0)), mass(1.0 * kilogram)); // some body is awake
        run(world, 120, dt);
        REQUIRE(world.motion(slept) == Motion::resting);
        if (with_an_old_id) world.remove(slept);
        const auto body = world.add(Sphere{0.5 * metre}, position(metres(0, 10, 0)), mass(1.0 * kilogram), resting);
        CHECK((body.id == slept.id) == with_an_old_id);
        run(world, 30, dt);
        const double n = 30 * 4, h = dt / 4; // SoftSubsteps takes a step in four substeps
        CHECK(std::abs(height_of(world, body) - (10 - 0.5 * 9.81 * n * (n + 1) * h * h)) <= 1e-9);
    }
}
