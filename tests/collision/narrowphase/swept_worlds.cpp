// SPDX-License-Identifier: BSL-1.0
// Worlds with Swept: hard cases C19 and G12, energy, many impacts at once, and what must stay as it was.
// Compiles like 25 kB: worlds with Swept, and others beside them, under many integrators and responses.

#include "tests/collision/support.hpp"

#include <ansatz/collision/narrowphase/swept.hpp>
#include <ansatz/collision/swept_collisions.hpp>
#include <ansatz/world/save.hpp>

#include <random>
#include <sstream>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60;
using Shapes = Narrowphase<Sphere, Plane, Box>;

template <class... P> auto swept(P... policies) { return World{policies..., SortAndSweep{}, Swept{Shapes{}}}; }
template <class... P> auto discrete(P... policies) { return World{policies..., SortAndSweep{}, Shapes{}}; }
template <class S> Box box(double x, double y, double z) {
    if constexpr (S::dimension == 2) return Box{metres(x, y)};
    else return Box{metres(x, y, z)};
}

} // namespace

TEST_CASE("a ball with e = 1 keeps its energy, whatever the integrator, through steps that are too large",
          "[collision][swept]") {
    for_each_type(Staged{}, []<class I>() {
        // A ball between floor and ceiling, 4 m high, that moves by 2 m in a step.
        auto world = swept(I{}, Gravity{}, Impulse<>{}, Projection{});
        world.add(box<Space<>>(5, 0.05, 5), at<Space<>>(0, -0.05), fixed);
        world.add(box<Space<>>(5, 0.05, 5), at<Space<>>(0, 4.05), fixed);
        const auto ball = world.add(Sphere{0.05 * metre}, at<Space<>>(0, 1), going<Space<>>(0, 120),
                                    mass(1.0 * kilogram), restitution(1));
        const double v0 = 120 - detail::velocity_leads<I>() * 9.81 * dt, start = 0.5 * v0 * v0 + 9.81;
        int hits = 0;
        double worst = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(dt * second);
            hits += !world.contacts().empty();
            // The velocity of an Euler method belongs to half a step before or behind the place.
            const double v = speed_along(world, ball, 1) - detail::velocity_leads<I>() * 9.81 * dt;
            worst = std::max(worst, std::abs(0.5 * v * v + 9.81 * height_of(world, ball) - start) / start);
        }
        CHECK(hits > 200);
        INFO("worst " << worst);
        CHECK(worst <= rounding<Space<>>(1e4)); // of some hundred hits
    });
}

TEST_CASE("what a platform takes along meets the same bodies, whatever the broadphase", "[collision][swept]") {
    auto run = [](auto world) {
        world.add(Sphere{0.5 * metre}, at<Space<>>(1, 3), mass(1.0 * kilogram), restitution(0));
        world.add(Sphere{0.5 * metre}, at<Space<>>(-0.3, 2.5), mass(1.0 * kilogram), restitution(0));
        world.add(Sphere{1.0 * metre}, at<Space<>>(-1, 2), going<Space<>>(56, 0), moving);
        for (int i = 0; i < 3; ++i) world.step(1.0 * second);
        return world.hash();
    };
    CHECK(run(World{SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{}, AllPairs{}, Swept{Shapes{}}}) ==
          run(swept(SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{})));
}

TEST_CASE("what lies, rolls or falls slowly moves as without Swept, to the bit", "[collision][swept]") {
    for_each_type(Types<Space<>, Space<float, 2>>{}, []<class S>() {
        auto scene = [](auto world) {
            world.add(Plane::ground(), fixed);
            world.add(box<S>(2, 0.25, 2), at<S>(4, 0.25), fixed);
            for (int i = 0; i < 12; ++i)
                world.add(Sphere{0.5 * metre}, at<S>(0.9 * i - 1, 1.1 + 0.15 * i), mass((1.0 + i) * kilogram),
                          restitution(0.1 * (i % 4)));
            for (int i = 0; i < 4; ++i)
                world.add(box<S>(0.5, 0.5, 0.5), at<S>(-4, 0.6 + 1.1 * i), mass(1.0 * kilogram));
            return world;
        };
        auto same = [&](auto with, auto without) {
            for (int i = 0; i < 240; ++i) {
                with.step(dt * second), without.step(dt * second);
                REQUIRE(with.hash() == without.hash());
            }
        };
        same(scene(swept(SemiImplicitEuler{}, S{}, Gravity{}, Rest{}, Impulse<>{}, Projection{})),
             scene(discrete(SemiImplicitEuler{}, S{}, Gravity{}, Rest{}, Impulse<>{}, Projection{})));
        same(scene(swept(Verlet{}, S{}, Gravity{}, Rest{}, SoftSubsteps<>{})),
             scene(discrete(Verlet{}, S{}, Gravity{}, Rest{}, SoftSubsteps<>{})));
    });
}

TEST_CASE("a fast ball rolls over the seams of a floor, and off its edge", "[collision][swept]") {
    auto world = swept(SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{});
    for (int i = 0; i < 20; ++i)
        world.add(box<Space<>>(0.5, 0.02, 1), at<Space<>>(0.5 + i, -0.02), fixed); // 4 cm thick
    const auto ball = world.add(Sphere{0.1 * metre}, at<Space<>>(0.3, 0.1), going<Space<>>(60), mass(1.0 * kilogram));
    run(world, 18, dt);
    CHECK(std::abs(x_of(world, ball) - 18.3) <= rounding<Space<>>(400));
    CHECK(std::abs(height_of(world, ball) - 0.1) <= 1e-9);
    run(world, 30, dt);
    CHECK(std::abs(speed_along(world, ball) - 60) <= 0.05 * 60);
    CHECK(height_of(world, ball) < 0);
}

TEST_CASE("C19: of a swarm at 250 m/s in a box no ball escapes, and its energy stays", "[collision][swept]") {
#ifdef NDEBUG
    constexpr int bodies = 5000, steps = 500;
#else
    constexpr int bodies = 1000, steps = 100;
#endif
    for (const bool of_planes : {true, false}) {
        INFO((of_planes ? "planes" : "boxes of 0.1 m"));
        auto world = swept(SemiImplicitEuler{}, Impulse<>{0.0 * metre_per_second}, Projection{});
        for (int k = 0; k < 3; ++k)
            for (const int side : {-1, 1}) {
                Eigen::Vector3d n = Eigen::Vector3d::Zero(), h(51, 51, 51), x = Eigen::Vector3d::Zero();
                n[k] = -side, h[k] = 0.05, x[k] = side * 50.05;
                if (of_planes) world.add(Plane{n, -50.0 * metre}, fixed);
                else world.add(Box{metres(h[0], h[1], h[2])}, position(metres(x[0], x[1], x[2])), fixed);
            }
        std::mt19937 random(1);
        auto number = [&] { return 2 * double(random()) / 4294967295.0 - 1; };
        std::vector<Handle> swarm;
        for (int i = 0; i < bodies; ++i) {
            const Eigen::Vector3d v = 250 * Eigen::Vector3d(number(), number(), number()).normalized();
            const double x = 49 * number(), y = 49 * number(), z = 49 * number();
            swarm.push_back(world.add(Sphere{0.5 * metre}, at<Space<>>(x, y, z), going<Space<>>(v[0], v[1], v[2]),
                                      mass(1.0 * kilogram), restitution(1)));
        }
        run(world, steps, dt);
        int escapes = 0;
        double energy = 0;
        for (const auto body : swarm) {
            escapes += !(world.position(body).value().cwiseAbs().maxCoeff() < 50);
            energy += 0.5 * double(squared_norm(world.velocity(body)).value()) / bodies;
        }
        CHECK(escapes == 0);
        CHECK(std::abs(energy / 31250 - 1) <= rounding<Space<>>(1e4));
        CHECK(world.status().ok());
    }
}

TEST_CASE("many impacts in one step: a corner, a row of bullets, a crowd shot into a corner", "[collision][swept]") {
    for_each_type(Types<Space<>, Space<float, 2>>{}, []<class S>() {
        auto world = swept(SemiImplicitEuler{}, S{}, Impulse<>{}, Projection{});
        world.add(box<S>(0.05, 50, 50), at<S>(0.05), fixed);
        world.add(box<S>(50, 0.05, 50), at<S>(0, 0.05), fixed);
        std::vector<Handle> all;
        for (int i = 0; i < 40; ++i)
            all.push_back(world.add(Sphere{0.1 * metre}, at<S>(-1 - 0.25 * i, -1 - 0.25 * (i % 7)),
                                    going<S>(300, 300 + 10 * (i % 3)), mass((1.0 + i % 5) * kilogram)));
        run(world, 60, dt);
        for (const auto ball : all) CHECK((x_of(world, ball) < 0 && height_of(world, ball) < 0));
    });
}

TEST_CASE("sensors notice what flies through them, and stop nothing, and layers are asked", "[collision][swept]") {
    World world{SemiImplicitEuler{}, Impulse<>{}, SortAndSweep{}, Swept<Shapes>{}, Layers{}};
    const auto gate = world.add(Box{metres(0.01, 1, 1)}, fixed, sensor);
    world.add(Box{metres(0.01, 1, 1)}, position(metres(0.5, 0, 0)), fixed, member_of(1));
    const auto ghost =
        world.add(Sphere{0.1 * metre}, at<Space<>>(-1), going<Space<>>(150), mass(1.0 * kilogram), ignores(1));
    world.step(dt * second);
    CHECK(x_of(world, ghost) == -1 + 150 * (1.0 * dt));
    REQUIRE(world.contacts().size() == 1);
    CHECK(world.contacts()[0].first == gate);
    CHECK(std::abs(double(world.contacts()[0].point.value()[0]) + 0.01) <= 1e-12);
    world.step(dt * second);
    CHECK(world.contacts().empty());
    CHECK(world.contacts_ended().size() == 1);
}

TEST_CASE("a platform takes along what it runs into, and a hail does not hold up a crate", "[collision][swept]") {
    auto world = swept(SemiImplicitEuler{}, Impulse<>{});
    const auto platform = world.add(Box{metres(0.05, 1, 1)}, at<Space<>>(-1), going<Space<>>(300), moving);
    const auto ball = world.add(Sphere{0.1 * metre}, at<Space<>>(0), mass(1.0 * kilogram));
    run(world, 5, dt);
    CHECK(x_of(world, platform) == Approx(-1 + 5 * 300 * dt));
    CHECK(x_of(world, ball) > x_of(world, platform) + 0.1);

    auto hail = swept(SemiImplicitEuler{}, Impulse<>{});
    const auto crate = hail.add(Box{metres(1, 1, 1)}, at<Space<>>(0), going<Space<>>(0, 1), mass(1e6 * kilogram));
    for (int i = 0; i < 20; ++i)
        hail.add(Sphere{0.1 * metre}, at<Space<>>(-3 - 5 * i, 0.1 * (i % 5)), going<Space<>>(300),
                 mass(1e-3 * kilogram));
    run(hail, 20, dt);
    CHECK(std::abs(height_of(hail, crate) - 20 * dt) <= 1e-12);
}

TEST_CASE("a copy and a saved world continue with the same bits through impacts", "[collision][swept]") {
    for_each_type(Types<SemiImplicitEuler, Verlet>{}, []<class I>() {
        auto first = swept(I{}, Gravity{}, Impulse<>{}, Projection{});
        first.add(box<Space<>>(50, 0.05, 50), at<Space<>>(0, -0.05), fixed);
        first.add(box<Space<>>(50, 0.05, 50), at<Space<>>(0, 6), fixed);
        for (int i = 0; i < 50; ++i)
            first.add(Sphere{0.1 * metre}, at<Space<>>(0.3 * i, 1 + 0.07 * i),
                      going<Space<>>(20 * (i % 3 - 1), 100 + i), mass((1.0 + i % 3) * kilogram), restitution(0.9));
        run(first, 17, dt);
        auto copy = first;
        std::stringstream file;
        save(first, file);
        auto loaded = swept(I{}, Gravity{}, Impulse<>{}, Projection{});
        load(loaded, file);
        for (int i = 0; i < 60; ++i) {
            for (auto* w : {&first, &copy, &loaded}) w->step(dt * second);
            REQUIRE((copy.hash() == first.hash() && loaded.hash() == first.hash()));
        }
    });
}

TEST_CASE("a world without Swept holds nothing of it", "[collision][swept]") {
    using Without = decltype(discrete(SemiImplicitEuler{}, Impulse<>{}));
    using With = decltype(swept(SemiImplicitEuler{}, Impulse<>{}));
    static_assert(!Without::composition::continuous && With::composition::continuous);
    static_assert(
        std::is_same_v<decltype(WorldData<Without::composition>::collisions), Collisions<Without::composition>>);
    static_assert(Without::bytes_per_body == With::bytes_per_body); // no column of its own
    SUCCEED();
}
