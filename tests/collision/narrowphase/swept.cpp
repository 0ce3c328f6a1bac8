// SPDX-License-Identifier: BSL-1.0
// Steps that are too large, with Swept: hard cases C18 to C20, G12, and what must stay as it was.
// Compiles like 20 kB: worlds with Swept under every integrator and in every space.

#include "tests/collision/support.hpp"

#include <ansatz/collision/narrowphase/swept.hpp>
#include <ansatz/collision/swept_collisions.hpp>

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

/// The walls that a ball is shot at along the first axis, with a surface at x = 0.
enum class Wall { box, ball, plane };
template <class World_> void build(World_& world, Wall wall, double origin) {
    using S = typename World_::S;
    if (wall == Wall::box) world.add(box<S>(0.05, 5, 5), at<S>(origin + 0.05), fixed);
    if (wall == Wall::ball) world.add(Sphere{0.05 * metre}, at<S>(origin + 0.05), fixed);
    if (wall == Wall::plane) world.add(Plane{Eigen::Vector3d(-1, 0, 0)}, at<S>(origin), fixed);
}
/// Where a ball of radius 0.1 m is at most, seen from the wall, of a hundred that begin at other places, m.
template <class World_> double furthest(const World_& empty, Wall wall, double speed, double origin = 0) {
    using S = typename World_::S;
    double most = -1e9;
    for (int from = 0; from < 100; ++from) {
        auto world = empty;
        build(world, wall, origin);
        const auto ball = world.add(Sphere{0.1 * metre}, at<S>(origin - 1 - from * speed * dt / 100), going<S>(speed),
                                    mass(1.0 * kilogram));
        for (int i = 0; i < 30; ++i) {
            world.step(dt * second);
            most = std::max(most, x_of(world, ball) - origin);
        }
        CHECK(world.status().ok());
    }
    return most;
}
} // namespace

TEST_CASE("C18: without Swept a ball is stopped below the critical speed and may pass above it; with it nothing passes",
          "[collision][swept]") {
    const auto plain = discrete(SemiImplicitEuler{}, Impulse<>{});
    CHECK(furthest(plain, Wall::box, 8.9) < 0.05);
    CHECK(furthest(plain, Wall::box, 18.1) > 1); // some of a hundred are never seen
    for_each_type(AllSpaces{}, [&]<class S>() {
        const double close = 0.025; // a quarter of the radius is left to the discrete functions
        for (const auto wall : {Wall::box, Wall::ball, Wall::plane})
            for (const double speed : {17.9, 18.1, 200.0, 500.0}) {
                INFO("wall " << int(wall) << ", " << speed << " m/s");
                CHECK(furthest(swept(SemiImplicitEuler{}, S{}, Impulse<>{}, Projection{}), wall, speed) <=
                      -0.1 + close + rounding<S>(16));
            }
    });
    // Nothing separates them but Swept.
    CHECK(furthest(swept(SemiImplicitEuler{}, Impulse<>{}), Wall::box, 500) <= -0.1 + 0.025 + rounding<Space<>>(16));
    CHECK(furthest(swept(SemiImplicitEuler{}, Impulse<>{}, Projection{}), Wall::box, 200, 1e7) <=
          -0.1 + 0.025 + rounding<Space<>>(4e7));
}

TEST_CASE("C18: with every integrator and every response", "[collision][swept]") {
    for_each_type(AllIntegrators{}, []<class I>() {
        for (const auto wall : {Wall::box, Wall::ball}) {
            INFO("wall " << int(wall));
            CHECK(furthest(swept(I{}, Impulse<>{}, Projection{}), wall, 500) < 0);
            if constexpr (std::is_same_v<I, SemiImplicitEuler> || std::is_same_v<I, Verlet>) {
                CHECK(furthest(swept(I{}, SoftSubsteps<>{}), wall, 500) < 0);
                CHECK(furthest(swept(I{}, Penalty{}), wall, 500) < 0.05);
            }
        }
    });
}

TEST_CASE("C20: bullets that meet head on do, where and when they should", "[collision][swept]") {
    for_each_type(AllSpaces{}, []<class S>() {
        auto world = swept(SemiImplicitEuler{}, S{}, Impulse<>{});
        const auto a = world.add(Sphere{0.05 * metre}, at<S>(-1), going<S>(100), mass(1.0 * kilogram), restitution(1));
        const auto b =
            world.add(Sphere{0.05 * metre}, at<S>(1.3), going<S>(-100), mass(1.0 * kilogram), restitution(1));
        world.step(dt * second);
        REQUIRE(world.contacts().size() == 1);
        CHECK(world.contacts()[0].begins());
        CHECK(world.contacts()[0].normal[0] == -1);
        const double when = (2.3 - 0.1) / 200; // closed form
        CHECK(std::abs((x_of(world, a) + 1) / 100 - when) <= 1e-4 * when);
        CHECK(std::abs((1.3 - x_of(world, b)) / 100 - when) <= 1e-4 * when);
        CHECK(std::abs(double(world.contacts()[0].point.value()[0]) - 0.15) <= 1e-4);
        CHECK(std::abs(speed_along(world, a) + 100) <= rounding<S>(200)); // they have exchanged their velocities
        CHECK(std::abs(speed_along(world, b) - 100) <= rounding<S>(200));
        run(world, 10, dt);
        CHECK((x_of(world, a) < -15 && x_of(world, b) > 15));
    });
}

TEST_CASE("a sphere that would pass beside the centre is turned as the tangent says", "[collision][swept]") {
    auto world = swept(SemiImplicitEuler{}, Impulse<>{});
    const auto a =
        world.add(Sphere{0.5 * metre}, at<Space<>>(-2, 0.5), going<Space<>>(240), mass(1.0 * kilogram), restitution(1));
    world.add(Sphere{0.5 * metre}, at<Space<>>(0), fixed);
    world.step(dt * second);          // it would be at 2 m, on the other side
    const double c = std::sqrt(0.75); // N = (-c, 0.5)
    CHECK(std::abs(x_of(world, a) + c) <= rounding<Space<>>(64));
    CHECK(std::abs(speed_along(world, a, 0) - (240 - 2 * 240 * c * c)) <= rounding<Space<>>(4e4));
    CHECK(std::abs(speed_along(world, a, 1) - 2 * 240 * c * 0.5) <= rounding<Space<>>(4e4));
}
