// SPDX-License-Identifier: BSL-1.0
// Walkers in worlds: on their way to the rounding whatever the speed, step and integrator; pushed off and back; what
// they tell; and all that a state of a world must be able to.

#include <ansatz/paths/walking/walk.hpp>
#include <ansatz/paths/walking/walkers.hpp>

#include "tests/paths/walking/worlds.hpp"
#include "tests/refusal.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

using namespace ansatz::test;
using namespace walking_tests;
using Catch::Matchers::ContainsSubstring;

TEMPLATE_TEST_CASE("a walker is where its way says, at any step and speed, and stands still at the end", "[walking]",
                   Simple, Flat, Third, Solved) {
    using W = TestType;
    using S = typename W::S;
    const double eps = std::numeric_limits<typename S::Scalar>::epsilon();
    std::mt19937 random(17);
    for (const double speed : {0.3, 3.0, 30.0})
        for (const double dt : {0.01, 0.1, 1.0}) {
            W world;
            const double a = 2;
            const auto body = [&] {
                if constexpr (S::dimension == 2) return world.add(position(metres(1, 2)));
                else return world.add(position(metres(1, 2, 0)));
            }();
            const auto path = random_path(random, 6, 20);
            const auto walk = world.add(walk_of(body, path, speed, a));
            const double all = double(world.walking(walk).time_left.value());
            const double rounding = 400 * eps * 30;
            int steps = 0, passed = 0, arrivals = 0, others = 0;
            auto v = world.velocity(body);
            for (; steps * dt < 1.5 * all + 5 * dt && arrivals == 0; ++steps) {
                world.step(dt * second);
                const auto now = world.velocity(body);
                REQUIRE(double(norm(now).value()) <= speed * (1 + 1e-4) + rounding / dt);
                REQUIRE(double(norm(now - v).value()) <= a * dt * (1 + 1e-4) + 2 * rounding / dt);
                REQUIRE(double(norm(world.position(body) - world.walking(walk).should_be).value()) <= rounding);
                v = now;
                for (const auto& event : world.walk_events()) {
                    passed += event.news == WalkNews::way_point ? int(event.passed) : 0;
                    arrivals += event.news == WalkNews::arrived;
                    others += event.news > WalkNews::arrived;
                }
            }
            INFO("speed " << speed << ", step " << dt << ", " << all << " s");
            CHECK(arrivals == 1);
            CHECK(passed == 5);
            CHECK(others == 0);
            CHECK((steps - 1) * dt <= all * (1 + 1e-3) + 2 * dt); // it is told in the step in which it stands
            for (int i = 0; i < 20; ++i) world.step(dt * second);
            CHECK(double(world.velocity(body).value().norm()) == 0);
            const auto& end = path.back().place.value();
            CHECK(std::hypot(double(world.position(body).value()[0]) - end[0],
                             double(world.position(body).value()[1]) - end[1]) <= rounding);
            CHECK(world.walk_events().empty());
        }
}

TEST_CASE("a walker on the ground leaves heights alone, and walks against drag", "[walking]") {
    Ground world;
    const auto body = world.add(position(metres(0, 100, 0)));
    auto walk = walk_of(body, {{metres(8, 5, 0), 1.0 * metre}, {metres(8, -3, 6)}}, 1.5, 2);
    walk.up = Eigen::Vector3d(0, 2, 0); // its length does not matter
    const auto id = world.add(walk);
    const double all = world.walking(id).time_left.value();
    const auto falling = world.add(position(metres(0, 100, 0)));
    double time = 0;
    int told = 0;
    for (; time < 2 * all && told == 0; time += 0.01) {
        world.step(0.01 * second);
        told += count(world, WalkNews::arrived);
        CHECK(world.walking(id).off == false);
        REQUIRE(world.position(body).value()[1] == world.position(falling).value()[1]);
    }
    CHECK(told == 1);
    CHECK(time <= 1.05 * all); // drag takes 0.45 of its 2 m/s^2 at full speed
    CHECK(world.position(body).value()[0] == Approx(8).margin(1e-3));
    CHECK(world.position(body).value()[2] == Approx(6).margin(1e-3));
}

TEST_CASE("pushed off it is told, comes back, and arrives; what it adds never exceeds its acceleration", "[walking]") {
    std::mt19937 random(23);
    for (int i = 0; i < 60; ++i) {
        Simple world;
        const auto body = world.add(position(metres(0, 0, 0)));
        const double a = 3, dt = std::array{0.01, 0.05, 0.3}[std::size_t(i % 3)];
        const auto walk = world.add(walk_of(body, random_path(random, 4, 15), 2, a));
        const double all = world.walking(walk).time_left.value();
        int off = 0, back = 0, arrived = 0, pushes = 0;
        for (double time = 0; time < 3 * all + 30 && arrived == 0; time += dt) {
            if (pushes < 3 && random() % 1000 < 1000 * dt / 3) {
                ++pushes;
                const double x = std::uniform_real_distribution<double>(-5, 5)(random);
                world.set_velocity(body, metres_per_second(x, 4 - x, x / 2));
            }
            const auto v = world.velocity(body);
            world.step(dt * second);
            REQUIRE(norm(world.velocity(body) - v).value() <= a * dt + 1e-10);
            off += count(world, WalkNews::pushed_off), back += count(world, WalkNews::back);
            arrived += count(world, WalkNews::arrived);
        }
        INFO("case " << i << " step " << dt << " pushes " << pushes);
        CHECK(arrived == 1);
        CHECK(off == back);
        if (pushes > 0 && dt < 0.1) CHECK(off <= pushes);
    }
}

TEST_CASE("put elsewhere on its way, or beside it, it goes on from the nearest place, and not from where it was",
          "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(20, 0, 0)}}, 2, 2));
    const double all = world.walking(walk).time_left.value();
    double time = 0, x = 0;
    const auto go_on = [&](double until) {
        for (; time < until && !world.walking(walk).arrived; time += 0.02) {
            world.step(0.02 * second);
            REQUIRE(world.position(body).value()[0] >= x - 1e-9); // never back
            x = world.position(body).value()[0];
        }
    };
    go_on(3);
    world.set_position(body, metres(x + 6, 0, 0));
    x += 6;
    go_on(5);
    world.set_position(body, metres(x, 0, 0.3)); // not far enough to be told
    go_on(20);
    CHECK(world.walking(walk).arrived);
    CHECK(time == Approx(all - 6 / 2.0).margin(0.1)); // 6 m at 2 m/s less, and hardly anything for the way back
    CHECK(norm(world.position(body) - metres(20, 0, 0)).value() < 1e-9);
}

TEST_CASE("stuck is told once, and again only when it has got on", "[walking]") {
    Simple world;
    world.set(Walkers{.patience = 2.0 * second});
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(10, 0, 0)}}, 1, 1));
    int stuck = 0, arrived = 0;
    double first = 0;
    for (int i = 0; i < 400; ++i) {
        if (i < 200 && world.position(body).value()[0] > 4) world.set_position(body, metres(4, 0, 0)); // a hand
        world.step(0.05 * second);
        stuck += count(world, WalkNews::stuck);
        if (stuck == 1 && first == 0) first = 0.05 * i;
        arrived += count(world, WalkNews::arrived);
        if (i < 200) CHECK(world.walking(walk).stuck == (stuck == 1));
    }
    CHECK(stuck == 1);
    CHECK(first > 4.5 + 1.5);
    CHECK(first < 4.5 + 2.5);
    CHECK(arrived == 1);
    CHECK(!world.walking(walk).stuck);
}

TEST_CASE("halted it stops as soon as it can, where it says, and goes on", "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(10, 0, 0), 1.0 * metre}, {metres(10, 10, 0)}}, 2, 1));
    for (int i = 0; i < 90; ++i) world.step(0.05 * second);
    const auto stop = world.where_it_can_stop(walk);
    const auto v = world.velocity(body);
    const auto x = world.position(body);
    world.halt(walk);
    for (int i = 0; i < 60; ++i) world.step(0.05 * second);
    CHECK(world.velocity(body).value().norm() == 0);
    CHECK(norm(world.position(body) - stop).value() < 1e-9);
    CHECK(norm(stop - x).value() == Approx(v.value().squaredNorm() / 2).epsilon(1e-9)); // v^2 / 2a
    CHECK(world.walk_events().empty());
    world.halt(walk, false);
    int arrived = 0;
    for (int i = 0; i < 300; ++i) world.step(0.05 * second), arrived += count(world, WalkNews::arrived);
    CHECK(arrived == 1);
    CHECK(norm(world.position(body) - metres(10, 10, 0)).value() < 1e-9);
}

TEST_CASE("two who are steered apart keep their momentum", "[walking]") {
    World world{SemiImplicitEuler{}, Apart{}};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> at(-2, 2), heavy(0.5, 4);
    for (int i = 0; i < 30; ++i)
        world.add(position(metres(at(random), at(random), at(random))), mass(heavy(random) * kilogram));
    for (int i = 0; i < 300; ++i) world.step(0.005 * second);
    Eigen::Vector3d sum(0, 0, 0);
    double size = 0;
    for (const auto body : world.handles()) {
        const Eigen::Vector3d p = world.mass(body).value() * world.velocity(body).value();
        sum += p, size += p.norm();
    }
    CHECK(size > 10);
    CHECK(sum.norm() < 1e-13 * size);
}
