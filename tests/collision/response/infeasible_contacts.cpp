// SPDX-License-Identifier: BSL-1.0
// Contacts whose targets contradict each other (R17): balls in a press, between walls that approach, between what is
// fixed.

#include "tests/collision/support.hpp"
#include "tests/measured.hpp"

#include <ansatz/collision/response/contact_pushes.hpp>
#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/infeasible_contacts.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace collision_tests;

namespace {
using S3 = Space<double, 3>;
/// A row of balls along the first axis from a wall that stands still to one that comes, at one metre a second.
template <class S> ContactPushes<S> row_of(const std::vector<double>& masses) {
    using Scalar = typename S::Scalar;
    using Raw = typename ContactPushes<S>::Raw;
    ContactPushes<S> pushes;
    const auto n = masses.size();
    pushes.clear(n + 2);
    for (std::uint32_t slot = 0; slot < n + 2; ++slot) {
        const bool ball = slot > 0 && slot <= n;
        const Raw u = slot == n + 1 ? Raw(-Raw::Unit(0)) : Raw(Raw::Zero());
        pushes.body(slot, ball ? Scalar(1 / masses[slot - 1]) : Scalar(0), [&] { return u; });
    }
    for (std::uint32_t k = 0; k <= n; ++k) {
        auto& push = pushes.pushes.emplace_back();
        push.a = k + 1;
        push.b = k;
        push.which = k;
        push.normal = Raw::Unit(0);
        push.point = Scalar(k) * Raw::Unit(0);
    }
    return pushes;
}
/// The speeds that share the walls' approach among the contacts, each by its n_a w_a + n_b w_b: the minimum of the sum
/// of squares over those, of misses whose sum is the approach.
std::vector<double> least_squares(const std::vector<double>& masses) {
    const auto n = masses.size();
    std::vector<double> shares;
    for (std::size_t k = 0; k <= n; ++k)
        shares.push_back((k > 0 ? 2 / masses[k - 1] : 0.0) + (k < n ? 2 / masses[k] : 0.0));
    double all = 0, some = 0;
    for (const double share : shares) all += share;
    std::vector<double> speeds;
    for (std::size_t k = 0; k < n; ++k) speeds.push_back(-(some += shares[k]) / all);
    return speeds;
}
template <class S> double worst_speed(const std::vector<double>& masses, int sweeps) {
    auto pushes = row_of<S>(masses);
    pushes.solve(sweeps);
    const auto expected = least_squares(masses);
    double worst = 0;
    for (std::size_t k = 0; k < masses.size(); ++k)
        worst = std::max(worst, std::abs(double(pushes.bodies[k + 1].u[0]) - expected[k]));
    return worst;
}

/// What becomes of balls on a plane, one on the other, under one that comes down.
struct Pressed {
    double out = 0;     // how far a centre comes below the plane, or above that of the press, m
    double fastest = 0; // m/s
};
template <class World_> Pressed press(World_ world, int n, double speed, const std::vector<double>& masses) {
    using S = typename World_::S;
    world.add(Plane::ground(), fixed);
    std::vector<Handle> balls;
    for (int k = 0; k < n; ++k)
        balls.push_back(world.add(Sphere{0.5 * metre}, at<S>(0, 0.5 + k), restitution(0.0),
                                  mass(masses[std::size_t(k) % masses.size()] * kilogram)));
    const auto lid = world.add(Sphere{0.5 * metre}, at<S>(0, n + 0.6), going<S>(0, -speed), moving);
    Pressed pressed;
    for (int step = 0; step < 0.9 / speed * 240; ++step) { // the press goes on until its ball is deep in the last one
        world.step(1.0 / 240 * second);
        for (const auto ball : balls) {
            const double y = height_of(world, ball), v = double(norm(world.velocity(ball)).value());
            const double out = std::max(-y, y - height_of(world, lid));
            pressed.out = std::isfinite(y) ? std::max(pressed.out, out) : INFINITY;
            pressed.fastest = std::isfinite(v) ? std::max(pressed.fastest, v) : INFINITY;
        }
    }
    return pressed;
}
} // namespace

TEST_CASE("a row between two walls that approach shares their speed out by least squares", "[collision]") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-1, 1);
    for (std::size_t n = 1; n <= 8; ++n)
        for (int round = 0; round < 5; ++round) {
            std::vector<double> masses;
            for (std::size_t k = 0; k < n; ++k) masses.push_back(round == 0 ? 1 : std::pow(10, exponent(random)));
            CAPTURE(n, masses);
            CHECK(worst_speed<S3>(masses, 500) < 1e-4);
            if (round > 0) continue;
            CHECK(worst_speed<S3>(masses, 24) < 0.01);
            CHECK(worst_speed<Space<float, 2>>(masses, 24) < 0.01);
        }
}

TEST_CASE("a row that is not held is pushed on by the wall", "[collision]") {
    for (const std::size_t n : {1u, 3u, 8u}) {
        auto pushes = row_of<S3>(std::vector<double>(n, 1.0));
        pushes.pushes.front().waits = true; // the wall that stands still is not in its way
        pushes.solve(24);
        for (std::size_t k = 1; k <= n; ++k) CHECK(pushes.bodies[k].u[0] == Approx(-1).margin(1e-12));
    }
}

TEMPLATE_TEST_CASE("R17: balls in a press stay in it, and none is faster than the press", "[collision]",
                   (Space<double, 3>), (Space<float, 2>)) {
    using S = TestType;
    double out = 0, fastest = 0, fastest_of_many = 0;
    const auto check = [&](const auto& world) {
        for (const double speed : {0.3, 3.0})
            for (const int n : {1, 2, 5, 20})
                for (const double ratio : {1.0, 3.0, 100.0}) {
                    const auto pressed = press(world, n, speed, {1.0, ratio});
                    out = std::max(out, pressed.out);
                    // A tall column of unlike balls, which the sweeps do not hold at once, may fall within itself.
                    if (n == 20 && ratio > 3) fastest_of_many = std::max(fastest_of_many, pressed.fastest - 4 * speed);
                    else fastest = std::max(fastest, (pressed.fastest - 9.81 / 240) / speed);
                }
    };
    check(world_of(SemiImplicitEuler{}, S{}, Gravity{}, Impulse<>{}, Projection{}));
    check(world_of(VelocityVerlet{}, S{}, Gravity{}, Impulse<>{}, Projection{1e-3 * metre}));
    check(world_of(ImplicitEuler{}, S{}, Gravity{}, Impulse<Friction>{}, Projection{}));
    CHECK(test::measured("R17", "how far a ball comes out of the press", out, test::at_most(0), "m"));
    CHECK(test::measured("R17", "the fastest ball, over the speed of the press", fastest, test::at_most(1)));
    CHECK(fastest_of_many <= std::sqrt(2 * 9.81 * 20));
    out = fastest = fastest_of_many = 0;
    check(world_of(SemiImplicitEuler{}, S{}, Gravity{}, SoftSubsteps<>{}));
    CHECK(test::measured("R17", "the same under SoftSubsteps: how far a ball comes out", out, test::at_most(0), "m"));
    CHECK(test::measured("R17", "the same: the fastest, over the press", fastest, test::at_most(1.05)));
    CHECK(fastest_of_many <= std::sqrt(2 * 9.81 * 20));
}

TEST_CASE("two presses that come alike leave the ball in the middle where it is", "[collision]") {
    auto world = world_of(SemiImplicitEuler{}, Impulse<>{}, Projection{});
    std::vector<Handle> balls;
    for (const double x : {-1.0, 0.0, 1.0})
        balls.push_back(world.add(Sphere{0.5 * metre}, at<S3>(x), mass(1.0 * kilogram)));
    for (const double side : {-1.0, 1.0}) world.add(Sphere{0.5 * metre}, at<S3>(2 * side), going<S3>(-side), moving);
    for (int step = 0; step < 200; ++step) {
        world.step(1.0 / 240 * second);
        CHECK(std::abs(x_of(world, balls[1])) < 1e-9);
        CHECK(std::abs(x_of(world, balls[0]) + x_of(world, balls[2])) < 1e-9);
        CHECK(std::abs(speed_along(world, balls[2])) <= 1);
    }
}

TEST_CASE("what lies elsewhere does not know of a press", "[collision]") {
    // Through a ground that both share: the same bits with and without the press.
    const auto settle = [](bool pressed) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, Impulse<Friction>{}, Projection{});
        world.add(Plane::ground(), fixed, friction(0.5));
        std::vector<Handle> balls;
        for (int k = 0; k < 6; ++k)
            balls.push_back(
                world.add(Sphere{0.5 * metre}, at<S3>(0.1 * (k % 2), 0.6 + k), mass(1.0 * kilogram), friction(0.5)));
        if (pressed) {
            for (int k = 0; k < 2; ++k)
                world.add(Sphere{0.5 * metre}, at<S3>(20, 0.5 + k), mass(1.0 * kilogram), friction(0.5));
            world.add(Sphere{0.5 * metre}, at<S3>(20, 2.5), going<S3>(0, -1), moving, friction(0.5));
        }
        std::vector<typename decltype(world)::S::Position> places;
        for (int step = 0; step < 240; ++step) {
            world.step(1.0 / 240 * second);
            for (const auto ball : balls) places.push_back(world.position(ball));
        }
        return places;
    };
    CHECK(settle(true) == settle(false));
}

TEST_CASE("a press that goes up again lets the ball fall as if nothing had been", "[collision]") {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{});
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, at<S3>(0, 0.5), mass(1.0 * kilogram));
    const auto lid = world.add(Sphere{0.5 * metre}, at<S3>(0, 1.5), going<S3>(0, -1), moving);
    for (int step = 0; step < 120; ++step) world.step(1.0 / 240 * second);
    world.set_velocity(lid, metres_per_second(0, 10, 0));
    for (int step = 0; step < 240; ++step) world.step(1.0 / 240 * second);
    CHECK(height_of(world, ball) == Approx(0.5).margin(1e-9));
    CHECK(speed_along(world, ball, 1) == Approx(0).margin(1e-9));
}

TEMPLATE_TEST_CASE("what is 10^10 times heavier is carried: pushes that move nothing are not always in vain",
                   "[collision]", double, float) {
    for (const double ratio : {1e4, 1e7, 1e10})
        for (const int n : {1, 5}) {
            auto world = world_of(SemiImplicitEuler{}, Space<TestType, 3>{}, Gravity{}, Impulse<>{}, Projection{});
            using S = typename decltype(world)::S;
            world.add(Plane::ground(), fixed);
            for (int k = 0; k < n; ++k) world.add(Sphere{0.5 * metre}, at<S>(0, 0.5 + k), mass(1.0 * kilogram));
            const auto heavy = world.add(Sphere{0.5 * metre}, at<S>(0, 0.5 + n), mass(ratio * kilogram));
            for (int step = 0; step < 240; ++step) world.step(1.0 / 240 * second);
            CAPTURE(ratio, n);
            CHECK(std::abs(height_of(world, heavy) - 0.5 - n) < 1e-4);
        }
}
