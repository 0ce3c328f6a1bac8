// SPDX-License-Identifier: BSL-1.0
#include <ansatz/motion/integrators/verlet.hpp>

#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("Verlet's positions and velocities are those of velocity Verlet, whose history it keeps",
          "[motion][verlet]") {
    // With the right start, x_{n+1} = 2 x_n - x_{n-1} + a_n h^2 is the same sequence; the velocity now is
    // (x_n - x_{n-1}) / h + a_n h / 2, which for an oscillator is velocity Verlet's too.
    check_closed_form<Verlet>([](long double w, long double h) {
        const long double q = w * w * h * h;
        return Amplification{1 - q / 2, h, -w * w * h * (1 - q / 4), 1 - q / 2};
    });
}

TEST_CASE("Verlet asks forces of position once a step", "[motion][verlet]") {
    CHECK(evaluations_of_a_step<Verlet>() == 1);
}

TEST_CASE("I4 Verlet keeps its invariant over a million steps", "[motion][verlet][I4]") {
    // The mean velocity of the last step, u = (x_n - x_{n-1}) / h, and both positions: x_n^2 + x_{n-1}^2 - (2 - q) x_n
    // x_{n-1} is what the recurrence keeps. Its roundings are of positions only.
    const double w = 10, h = 1.0 / 60, q = w * w * h * h;
    World world{Space<double, 2>{}, Verlet{}, Oscillator{w / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 3.0 * metre_per_second});
    world.step(h * second);
    auto invariant = [&, before = 1.0]() mutable {
        const double x = world.position(body).value()[0];
        const double value = x * x + before * before - (2 - q) * x * before;
        before = x;
        return value;
    };
    const double kept = invariant();
    double drift = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        world.step(h * second);
        drift = std::max(drift, std::abs(invariant() / kept - 1));
    }
    INFO("largest drift " << drift);
    CHECK(drift <= 1e-11);
}

namespace {
/// The error at t = 10 of a Verlet whose history begins with `previous`, by hand.
double error_of_start(int n, double (*previous)(double x, double v, double a, double h)) {
    const double h = 10.0 / n;
    double x = 1, before = previous(1, 0.5, -1, h);
    for (int i = 0; i < n; ++i) {
        const double next = 2 * x - before - x * h * h;
        before = x;
        x = next;
    }
    return std::abs(x - (std::cos(10.0) + 0.5 * std::sin(10.0)));
}
double error_of_world(int n) {
    World world{Space<double, 2>{}, Verlet{}, Oscillator{1.0 / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 0.5 * metre_per_second});
    run(world, n, 10.0 / n);
    return std::abs(state(world, body)[0] - (std::cos(10.0) + 0.5 * std::sin(10.0)));
}
} // namespace

TEST_CASE("I11 Verlet start: with half an acceleration the order is 2, without it 1, without a velocity it is lost",
          "[motion][verlet][I11]") {
    check_order(2, 0.01, 400, 5, error_of_world);
    // What the other starts would give, so that the bound above means something.
    check_order(2, 0.01, 400, 5, [](int n) {
        return error_of_start(n, [](double x, double v, double a, double h) { return x - v * h + 0.5 * a * h * h; });
    });
    check_order(1, 0.05, 400, 5, [](int n) {
        return error_of_start(n, [](double x, double v, double, double h) { return x - v * h; });
    });
    const double lost = error_of_start(6400, [](double x, double, double, double) { return x; });
    INFO("x_{-1} = x_0 is off by " << lost << " m however small the step");
    CHECK(std::abs(lost - 0.27) <= 0.01);
}
