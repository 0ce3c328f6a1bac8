// SPDX-License-Identifier: BSL-1.0

// QuadraticDrag against its closed forms: hard case I9.

#include <ansatz/motion/quadratic_drag.hpp>

#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {

constexpr auto g = 9.81 * metre_per_second_squared;
constexpr auto terminal = 50.0 * metre_per_second;

/// A fall from rest, or with an upward velocity, at 240 Hz.
template <class S, class I> auto falling(double up = 0) {
    World world{S{}, I{}, Gravity{}, QuadraticDrag::with_terminal_speed(terminal, 80.0 * kilogram, g)};
    const auto body = world.add(at<S>(0, 0), going<S>(0, up), mass(80.0 * kilogram));
    return std::pair(world, body);
}

} // namespace

TEST_CASE("I9 quadratic drag: v = v_t tanh(g t / v_t), s = v_t^2/g ln cosh(g t / v_t)",
          "[motion][I9][quadratic_drag]") {
    struct Row {
        double t, v, s;
    };
    for (const Row& row : {Row{5, 37.674924, 106.877442}, Row{20, 49.960962, 823.456492}}) {
        const double t = row.t, v = row.v, s = row.s; // clang 14 captures no structured bindings
        const auto exact = fall_with_quadratic_drag(terminal, g, t * second);
        CHECK(std::abs(exact.v.value() - v) <= 1e-6);
        CHECK(std::abs(exact.x.value() - s) <= 1e-6);
        for_each_type(Types<VelocityVerlet, Verlet, RungeKutta4>{}, [&]<class I> {
            auto [world, body] = falling<Space<double, 3>, I>();
            run(world, int(240 * t), 1.0 / 240);
            INFO("t = " << t << " s: v " << -world.velocity(body).value()[1] << " m/s, s "
                        << -world.position(body).value()[1] << " m");
            CHECK(std::abs(-world.velocity(body).value()[1] / v - 1) <= 1e-4);
            CHECK(std::abs(-world.position(body).value()[1] / s - 1) <= 1e-4);
        });
    }
}

TEST_CASE("I9 quadratic drag: a launch upwards at 60 m/s, drag against the velocity at all times",
          "[motion][I9][quadratic_drag]") {
    for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S> {
        for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, []<class I> {
            auto [world, body] = falling<S, I>(60);
            // Up: v_t atan(v0 / v_t) / g = 4.466 s and v_t^2 / (2 g) ln(1 + (v0 / v_t)^2) = 113.66 m.
            const double top = 2500 / (2 * 9.81) * std::log(1 + 1.44);
            double highest = 0;
            bool against = true;
            for (int i = 0; i < 240 * 10; ++i) {
                world.step(1.0 / 240 * second);
                highest = std::max(highest, double(world.position(body).value()[1]));
                const auto v = world.velocity(body);
                const auto f = world.laws().template get<QuadraticDrag>().force(v, 0);
                against = against && dot(v, f).value() <= 0;
            }
            CHECK(against);
            INFO("highest point " << highest << " m, should be " << top << " m");
            // The first-order scheme is off by half a step of the launch's velocity; float's Verlet by its roundings.
            CHECK(std::abs(highest / top - 1) <=
                  (I::order == 1 ? 60.0 / 240 / top : 2e-4) + (std::is_same_v<typename S::Scalar, float> ? 2e-3 : 0));
        });
    });
}

TEST_CASE("quadratic drag: terminal speed sqrt(m g / k), approached and not passed", "[motion][quadratic_drag]") {
    // Two masses, one law: the heavier falls faster, by the root of the ratio.
    World world{Space<double, 2>{}, RungeKutta4{}, Gravity{}, QuadraticDrag{0.5 * kilogram_per_metre}};
    const auto light = world.add(mass(2.0 * kilogram)), heavy = world.add(mass(18.0 * kilogram));
    double before = 0;
    bool monotone = true;
    for (int i = 0; i < 6000; ++i) {
        world.step(1.0 / 100 * second);
        const double now = -world.velocity(light).value()[1];
        monotone = monotone && now >= before - 1e-12;
        before = now;
    }
    CHECK(monotone);
    CHECK(std::abs(before - std::sqrt(2 * 9.81 / 0.5)) <= 1e-9);
    CHECK(std::abs(-world.velocity(heavy).value()[1] / before - 3) <= 1e-9);
}

TEST_CASE("quadratic drag is against the motion in every direction, with the square of the speed",
          "[motion][quadratic_drag]") {
    const detail::Bound<QuadraticDrag, Space<double, 3>> law(QuadraticDrag{0.25 * kilogram_per_metre});
    const auto f = law.force(metres_per_second(3, -4, 12), 0); // |v| = 13
    CHECK(f.value().isApprox(-0.25 * 13 * Eigen::Vector3d(3, -4, 12), 1e-15));
    CHECK(law.force(metres_per_second(6, -8, 24), 0).value().isApprox(4 * f.value(), 1e-15));
    CHECK(law.force(metres_per_second(0, 0, 0), 0).value() == Eigen::Vector3d::Zero());
    // Its Jacobian is the derivative: central differences, whose error is h^2 times the third derivative.
    const auto j = law.jacobian(metres_per_second(3, -4, 12), 0);
    for (int i = 0; i < 3; ++i) {
        Eigen::Vector3d up(3, -4, 12), down(3, -4, 12);
        up[i] += 1e-4;
        down[i] -= 1e-4;
        const Eigen::Vector3d slope_i = (law.force(up * (1.0 * metre_per_second), 0).value() -
                                         law.force(down * (1.0 * metre_per_second), 0).value()) /
                                        2e-4;
        CHECK((j.velocity.value().col(i) - slope_i).norm() <= 1e-8);
    }
    CHECK(law.jacobian(metres_per_second(0, 0, 0), 0).velocity.value().norm() == 0);
}

TEST_CASE("quadratic drag from the shape: 1/2 rho C A", "[motion][quadratic_drag]") {
    const auto ball = QuadraticDrag::of(1.2 * kilogram_per_cubic_metre, 0.47, 0.01 * square_metre);
    CHECK(std::abs(ball.coefficient.value() - 0.5 * 1.2 * 0.47 * 0.01) <= 1e-18);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, QuadraticDrag{-1.0 * kilogram_per_metre}}), std::invalid_argument);
}
