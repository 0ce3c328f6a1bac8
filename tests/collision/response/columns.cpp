// SPDX-License-Identifier: BSL-1.0
// Impulse and projection where many touch: columns (V8), energy from nothing (V3), rows of balls, and the order of
// insertion (R14).
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/collision/near_contacts.hpp>
#include <ansatz/collision/response/contact_pushes.hpp>
#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/projection.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60; // s

enum class Ground { plane, box };
struct Column {
    int n = 8;
    bool boxes = false;
    Ground ground = Ground::plane;
    double gap = 0; // between two of them at the start, m
    std::vector<double> masses{};
    double e = 0;
};
/// How deep two are in each other at most, over a radius, and how fast some body is at most, in the last two of ten
/// seconds.
struct Settled {
    double depth = 0, speed = 0;
};
template <class World_> Settled settle(World_ world, const Column& column, double rate = 60) {
    using S = typename World_::S;
    column.ground == Ground::plane ? world.add(Plane::ground(), fixed)
                                   : world.add(Box{vector_in<S, unit::Length>(3, 0.5, 3)}, at<S>(0, -0.5), fixed);
    std::vector<Handle> bodies;
    for (int i = 0; i < column.n; ++i) {
        const auto m =
            mass((column.masses.empty() ? 1.0 : column.masses[std::size_t(i) % column.masses.size()]) * kilogram);
        const auto place = at<S>(0, 0.5 + column.gap + i * (1 + column.gap));
        bodies.push_back(
            column.boxes ? world.add(Box{vector_in<S, unit::Length>(0.5, 0.5, 0.5)}, place, m, restitution(column.e))
                         : world.add(Sphere{0.5 * metre}, place, m, restitution(column.e)));
    }
    Settled settled;
    for (int i = 0; i < 10 * rate; ++i) {
        world.step(1 / rate * second);
        if (i < 8 * rate) continue;
        double below = 0;
        for (const auto body : bodies) {
            const double y = height_of(world, body);
            settled.depth = std::max(settled.depth, (below + (below > 0 ? 1 : 0.5) - y) / 0.5);
            settled.speed = std::max(settled.speed, double(norm(world.velocity(body)).value()));
            below = y;
        }
    }
    return settled;
}
template <class... P> auto pair_of(P... policies) {
    return world_of(policies..., Gravity{}, Impulse<>{}, Projection{});
}
/// V8
void check_settled(const Settled& settled) {
    CHECK(settled.depth <= 0.05);
    CHECK(settled.speed <= 0.05);
}

/// J, of what a world's awake bodies have.
template <class World_> double energy(const World_& world) { return double(kinetic_energy(world).value()); }

/// Bodies apart from each other in a closed box of planes, at a speed of so many radii a step.
template <class World_>
void scatter(World_& world, int n, bool boxes, double radii_a_step, unsigned seed, double most_e = 1) {
    using S = typename World_::S;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit_range(0, 1);
    const double r = 0.1, room = 0.25 * std::cbrt(double(n)) + 0.2; // m
    for (const double side : {-1.0, 1.0})
        for (int k = 0; k < 3; ++k)
            world.add(Plane{Eigen::Vector3d(-side * Eigen::Vector3d::Unit(k)), -room * metre}, fixed, restitution(0));
    const int a_row = int(std::ceil(std::cbrt(double(n))));
    for (int i = 0; i < n; ++i) {
        const auto coordinate = [&](int k) { return ((k + 0.5) / a_row * 2 - 1) * (room - 0.12); };
        Eigen::Vector3d v(unit_range(random) - 0.5, unit_range(random) - 0.5, unit_range(random) - 0.5);
        v *= radii_a_step * r / dt / v.norm();
        const auto x = at<S>(coordinate(i % a_row), coordinate(i / a_row % a_row), coordinate(i / a_row / a_row));
        const auto speed = velocity(vector_in<S, unit::Velocity>(v[0], v[1], v[2]));
        const auto m = mass((1 + 9 * unit_range(random)) * kilogram);
        const auto e = restitution(most_e * unit_range(random));
        if (boxes && i % 2 == 0) world.add(Box{vector_in<S, unit::Length>(0.8 * r, 0.9 * r, r)}, x, speed, m, e);
        else world.add(Sphere{r * metre}, x, speed, m, e);
    }
}
/// V3: no step has more kinetic energy than the one before.
template <class World_> void check_energy(const World_& empty) {
    for (const auto& [n, radii] : {std::pair(1, 10.0), std::pair(12, 0.01), std::pair(60, 0.3), std::pair(120, 10.0),
                                   std::pair(250, 1.0), std::pair(40, 50.0)})
        for (const bool boxes : {false, true}) {
            INFO(n << " bodies, " << radii << " radii a step" << (boxes ? ", boxes" : ""));
            auto world = empty;
            scatter(world, n, boxes, radii, unsigned(n));
            double before = energy(world), worst = 0;
            for (int i = 0; i < 150; ++i) {
                world.step(dt * second);
                const double now = energy(world);
                worst = std::max(worst, before > 0 ? now / before - 1 : now);
                before = now;
            }
            CHECK(worst <= 1e-12);
        }
}

/// Five balls in a row, the first of which come from the left at 1 m/s; their velocities at last, from the left.
template <class World_>
std::vector<double> cradle(World_ world, const std::vector<int>& order, int moving_ones, double gap) {
    std::vector<Handle> balls(5);
    for (const int i : order)
        balls[std::size_t(i)] =
            world.add(Sphere{0.5 * metre}, at<Space<>>(i * (1 + gap)), going<Space<>>(i < moving_ones ? 1 : 0),
                      mass(1.0 * kilogram), restitution(1));
    run(world, 60, dt);
    std::vector<double> speeds;
    for (const auto ball : balls) speeds.push_back(speed_along(world, ball));
    return speeds;
}
} // namespace

TEST_CASE("V8: a column of eight stands, of spheres and of boxes, on a plane and on a box, dropped or set",
          "[collision][columns]") {
    for (const bool boxes : {false, true})
        for (const auto ground : {Ground::plane, Ground::box})
            for (const double gap : {0.0, 0.01, 0.1}) {
                INFO((boxes ? "boxes" : "spheres")
                     << (ground == Ground::plane ? " on a plane" : " on a box") << ", gaps of " << gap << " m");
                check_settled(settle(pair_of(SemiImplicitEuler{}), {8, boxes, ground, gap}));
            }
}

TEST_CASE("V8: twelve stand, of one mass and of several, a heavy one on top, bouncing ones, at other steps",
          "[collision][columns]") {
    const auto world = pair_of(SemiImplicitEuler{});
    check_settled(settle(world, {12}));
    check_settled(settle(world, {12, true, Ground::plane, 0.02}));
    check_settled(settle(world, {12, false, Ground::plane, 0.02, {1, 3, 5}}));
    check_settled(settle(world, {8, false, Ground::plane, 0.01, {1, 1, 1, 1, 1, 1, 1, 100}}));
    for (const double e : {0.1, 0.5, 1.0}) check_settled(settle(world, {8, true, Ground::box, 0, {}, e}));
    for (const double rate : {30.0, 240.0}) check_settled(settle(world, {8, false, Ground::plane, 0.01}, rate));
}

TEST_CASE("V8: a column of eight stands with other integrators, in float and in two dimensions",
          "[collision][columns]") {
    check_settled(settle(pair_of(Verlet{}), {8, false, Ground::plane, 0.01}));
    check_settled(settle(pair_of(RungeKutta4{}), {8, true, Ground::plane, 0.01}));
    check_settled(settle(pair_of(SemiImplicitEuler{}, Space<float, 2>{}), {8, false, Ground::plane, 0.01}));
}

namespace {
/// How deep two of a column are in each other at most while it is dropped and settles, over a radius; and how it lies
/// then.
struct Dropped {
    double deepest = 0;
    Settled settled{};
    bool rose = false; // whether its energy was ever more than at the start
};
template <class World_> Dropped drop(World_ world, const Column& column, double rate) {
    using S = typename World_::S;
    world.add(Plane::ground(), fixed);
    std::vector<Handle> bodies;
    double top = 0; // J, of 1 kg each
    for (int i = 0; i < column.n; ++i) {
        const double y = 0.5 + column.gap + i * (1 + column.gap);
        const auto m = mass(1.0 * kilogram);
        top += 9.81 * y;
        bodies.push_back(column.boxes ? world.add(Box{vector_in<S, unit::Length>(0.5, 0.5, 0.5)}, at<S>(0, y), m,
                                                  restitution(column.e))
                                      : world.add(Sphere{0.5 * metre}, at<S>(0, y), m, restitution(column.e)));
    }
    Dropped dropped;
    for (int i = 0; i < 10 * rate; ++i) {
        world.step(1 / rate * second);
        double below = 0, deepest = 0, fastest = 0, now = 0;
        for (const auto body : bodies) {
            const double y = height_of(world, body), v = speed_along(world, body, 1);
            deepest = std::max(deepest, (below + (below > 0 ? 1 : 0.5) - y) / 0.5);
            fastest = std::max(fastest, std::abs(v));
            now += 9.81 * y + v * v / 2;
            below = y;
        }
        dropped.deepest = std::max(dropped.deepest, deepest);
        // The velocity is half a step ahead of the place: v g dt / 2 each, and what it came from.
        const double ahead = 9.81 / rate * column.n * (fastest + 9.81 / rate);
        dropped.rose = dropped.rose || now > top + ahead + rounding<S>(100 * top);
        if (i < 8 * rate) continue;
        dropped.settled.depth = std::max(dropped.settled.depth, deepest);
        dropped.settled.speed = std::max(dropped.settled.speed, fastest);
    }
    return dropped;
}
/// Columns of 4, 8 and 12 with gaps of nothing to 20 cm.
template <class World_> void check_dropped(const World_& world, std::initializer_list<double> rates) {
    for (const double rate : rates)
        for (const bool boxes : {false, true})
            for (const int n : {4, 8, 12})
                for (const double gap : {0.0, 0.01, 0.05, 0.2})
                    for (const double e : {0.0, 0.2, 0.5, 0.8}) {
                        INFO(n << (boxes ? " boxes, " : " spheres, ") << "gaps of " << gap << " m, e = " << e << ", "
                               << rate << " steps a second");
                        const auto dropped = drop(world, {n, boxes, Ground::plane, gap, {}, e}, rate);
                        CHECK(dropped.deepest <= 0.05);
                        CHECK_FALSE(dropped.rose);
                        check_settled(dropped.settled);
                    }
}
} // namespace

TEST_CASE("V8: columns that are dropped, with gaps and restitution, do not fall into each other and come to rest",
          "[collision][columns]") {
    check_dropped(pair_of(SemiImplicitEuler{}), {30.0, 60.0, 120.0});
}

TEST_CASE("V8: nor do they in float and in two dimensions", "[collision][columns]") {
    check_dropped(pair_of(SemiImplicitEuler{}, Space<float, 3>{}), {60.0});
    check_dropped(pair_of(SemiImplicitEuler{}, Space<float, 2>{}), {60.0});
    check_dropped(pair_of(SemiImplicitEuler{}, Space<double, 2>{}), {60.0});
}

TEST_CASE("V8: more sweeps are never worse, and enough of them are exact", "[collision][columns]") {
    auto depth = [](int n, int sweeps) {
        auto world = pair_of(SemiImplicitEuler{});
        auto impulse = world.get<Impulse<>>();
        auto projection = world.get<Projection>();
        impulse.sweeps = projection.sweeps = sweeps;
        world.set(impulse);
        world.set(projection);
        return settle(world, {n}).depth;
    };
    for (const int n : {4, 8}) { // taller ones are a heap with one sweep or two
        double before = HUGE_VAL;
        for (const int sweeps : {1, 2, 4, 8, 16, 32}) {
            const double now = depth(n, sweeps);
            INFO(n << " bodies, " << sweeps << " sweeps: " << now << " radii");
            CHECK(now <= before * 1.001 + 1e-9);
            if (sweeps >= n) CHECK(now <= 0.01);
            before = now;
        }
    }
}

TEST_CASE("V3: impulse and projection make no energy, whatever meets and however fast", "[collision][columns]") {
    check_energy(world_of(SemiImplicitEuler{}, Impulse<>{}));
    check_energy(world_of(SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Impulse<>{}, Projection{}));
    auto projected = world_of(SemiImplicitEuler{}, Projection{}, Keep<InverseMass, Restitution>{});
    check_energy(projected);
    check_energy(World{SemiImplicitEuler{}, BoundingBoxes{}, Swept<Narrowphase<Sphere, Plane, Box>>{}, Impulse<>{},
                       Projection{}});
}

TEST_CASE("a row of balls hands a blow on, with its energy, in whatever order they were added",
          "[collision][columns]") {
    const std::vector<std::vector<int>> orders{{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {2, 0, 4, 1, 3}};
    for (const auto& world :
         {world_of(SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Impulse<>{}, Projection{})})
        for (const double gap : {0.0, -1e-3, 1e-3})
            for (const int coming : {1, 2, 3})
                for (const auto& order : orders) {
                    const auto speeds = cradle(world, order, coming, gap);
                    INFO(coming << " come, gap " << gap);
                    for (int i = 0; i < 5; ++i)
                        CHECK(std::abs(speeds[std::size_t(i)] - (i < 5 - coming ? 0 : 1)) <= 1e-12);
                }
}

TEST_CASE("one ball that hits two at once hits them alike, and keeps its energy", "[collision][columns]") {
    auto world = world_of(SemiImplicitEuler{}, Impulse<>{});
    const auto ball =
        world.add(Sphere{0.5 * metre}, at<Space<>>(0), going<Space<>>(1), mass(1.0 * kilogram), restitution(1));
    std::vector<Handle> two;
    for (const double side : {-1.0, 1.0})
        two.push_back(world.add(Sphere{0.5 * metre}, at<Space<>>(std::sqrt(0.75) - 1e-3, 0.5 * side),
                                mass(1.0 * kilogram), restitution(1)));
    world.step(1e-6 * second);
    CHECK(std::abs(speed_along(world, ball) + 0.2) <= 0.01); // along x: -1/5 and 3/5 each, were they only touching
    CHECK(std::abs(speed_along(world, two[0]) - speed_along(world, two[1])) <= 1e-15);
    CHECK(std::abs(speed_along(world, two[0], 1) + speed_along(world, two[1], 1)) <= 1e-15);
    CHECK(std::abs(2 * energy(world) - 1) <= 1e-12);
}

TEST_CASE("R14: where a heap comes to lie does not depend on the order of insertion", "[collision][columns]") {
    auto drop = [](bool reversed) {
        auto world = pair_of(SemiImplicitEuler{});
        const int n = 30;
        std::vector<Handle> balls(n);
        auto add = [&](int i) {
            balls[std::size_t(i)] = world.add(
                Sphere{0.5 * metre},
                at<Space<>>(0.97 * (i % 3) + 0.01 * i, 0.6 + 1.05 * (i / 9), 0.97 * (i / 3 % 3) + 0.013 * (i % 7)),
                mass((1 + i % 4) * kilogram), restitution(0.1 * (i % 5)));
        };
        if (!reversed) world.add(Plane::ground(), fixed);
        for (int i = 0; i < n; ++i) add(reversed ? n - 1 - i : i);
        if (reversed) world.add(Plane::ground(), fixed);
        run(world, 120, dt);
        std::vector<double> places;
        for (const auto ball : balls) places.push_back(x_of(world, ball)), places.push_back(height_of(world, ball));
        return places;
    };
    const auto one = drop(false), other = drop(true);
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(std::abs(one[i] - other[i]) <= 1e-9);
}
