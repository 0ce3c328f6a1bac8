// SPDX-License-Identifier: BSL-1.0
// Steering verbs: their closed forms, step by step, and the laws that hold for any place, speed and step.

#include <ansatz/paths/walking/steering.hpp>

#include "tests/catch.hpp"

#include <ansatz/world/space.hpp>

#include <cmath>
#include <random>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// Quantities of a space, at random.
template <class S> struct Dice {
    std::mt19937 random{11};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    double logarithmic(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    template <class Unit> auto vector(double size) {
        Vector<typename S::Scalar, S::dimension> v;
        for (int k = 0; k < S::dimension; ++k) v[k] = typename S::Scalar(uniform(-size, size));
        return S::template VectorOf<Unit>::from_value(v);
    }
    template <class Unit> auto number(double low, double high) {
        return S::template ScalarOf<Unit>::from_value(typename S::Scalar(logarithmic(low, high)));
    }
};

} // namespace

TEMPLATE_TEST_CASE("who arrives lands on the target to the rounding, in the steps that its speeds allow", "[steering]",
                   (Space<double, 2>), (Space<double, 3>), (Space<float, 2>), (Space<float, 3>)) {
    using S = TestType;
    using Scalar = typename S::Scalar;
    const double eps = std::numeric_limits<Scalar>::epsilon();
    Dice<S> dice;
    for (int i = 0; i < 400; ++i) {
        auto x = dice.template vector<unit::Length>(50);
        const auto target = dice.template vector<unit::Length>(50);
        const auto speed = dice.template number<unit::Velocity>(0.1, 10);
        const auto a = dice.template number<unit::Acceleration>(0.1, 10);
        const auto dt = dice.template number<unit::Time>(0.01, 1);
        auto v = S::template zero_vector<unit::Velocity>();
        const double u = double(speed.value()), acc = double(a.value()), h = double(dt.value());
        const double d = double(norm(target - x).value());
        const double flat = u * u / acc < d ? d / u + u / acc : 2 * std::sqrt(d / acc); // the trapezoid
        const double floor = 40 * 100 * eps;                                            // the rounding of a place here
        int steps = 0;
        for (; steps < int(flat / h) + 5 && double(norm(target - x).value()) > floor; ++steps) {
            const auto wanted = arrive(x, target, speed, a, dt);
            const auto next = steered(v, wanted, a, dt);
            REQUIRE(double(norm(next - v).value()) <= acc * h + 8 * eps * u);
            REQUIRE(double(norm(next).value()) <= u * (1 + 8 * eps));
            v = next;
            x = x + v * dt;
        }
        INFO("distance " << d << " speed " << u << " acceleration " << acc << " step " << h);
        CHECK(double(norm(target - x).value()) <= floor);
        CHECK(steps * h <= flat * (1 + 200 * eps) + 3 * h); // speeding up by whole steps, and the step that lands
        const auto rest = steered(v, arrive(x, target, speed, a, dt), a, dt);
        CHECK(double(norm(rest).value()) <= 2 * floor / h + 8 * eps * u);
    }
}

TEST_CASE("from any place and velocity arrive comes to rest at the target", "[steering]") {
    using S = Space<double, 2>;
    Dice<S> dice;
    for (int i = 0; i < 300; ++i) {
        auto x = dice.vector<unit::Length>(20);
        const auto target = dice.vector<unit::Length>(20);
        const auto speed = dice.number<unit::Velocity>(0.1, 10);
        const auto a = dice.number<unit::Acceleration>(0.1, 10);
        const auto dt = dice.number<unit::Time>(0.01, 0.5);
        auto v = seek(x, x + dice.vector<unit::Length>(1), speed);
        // Stops at the worst, and has then come no farther than v^2/2a: from there the trapezoid, twice for the turn.
        const auto far = norm(target - x) + speed * speed / a;
        const auto time = 2.0 * (2.0 * sqrt(far / a) + far / speed + speed / a) + 10.0 * dt;
        for (auto t = 0.0 * second; t < time; t += dt) {
            v = steered(v, arrive(x, target, speed, a, dt), a, dt);
            x = x + v * dt;
        }
        INFO("speed " << speed.value() << " acceleration " << a.value() << " step " << dt.value());
        CHECK(norm(target - x).value() < 1e-9);
        CHECK(norm(v).value() < 1e-9 / dt.value());
    }
}

TEST_CASE("arrival speeds are those that braking by a dt a step uses up", "[steering]") {
    const auto a = 3.0 * metre / second / second;
    const auto dt = 0.125 * second;
    for (double d = 0; d < 20; d += 0.0137) {
        double left = d, u = arrival_speed(d * metre, a, dt).value(), all = 0;
        for (; u > 0; u -= a.value() * dt.value()) all += u * dt.value();
        CHECK(all == Approx(left).margin(1e-12));
    }
    // And in the limit of short steps the root of 2 a d, with an error of the first order.
    double before = 0;
    for (const double h : {1e-2, 5e-3, 2.5e-3}) {
        const double off = std::sqrt(2 * 3.0 * 7.0) - arrival_speed(7.0 * metre, a, h * second).value();
        if (before > 0) CHECK(before / off == Approx(2).epsilon(0.02));
        before = off;
    }
}

TEST_CASE("seeking from rest is a uniform acceleration of the steps", "[steering]") {
    const auto a = 2.0 * metre / second / second;
    const auto dt = 0.25 * second;
    auto x = metres(0, 0, 0);
    auto v = metres_per_second(0, 0, 0);
    for (int n = 1; n <= 12; ++n) {
        v = steered(v, seek(x, metres(1000, 0, 0), 6.0 * metre / second), a, dt);
        x = x + v * dt;
        CHECK(x.value()[0] == 2 * 0.25 * 0.25 * n * (n + 1) / 2); // dt^2 a n (n + 1) / 2
    }
    CHECK(v.value()[0] == 6);
    CHECK(seek(x, x, 6.0 * metre / second).value().norm() == 0);
    CHECK((flee(x, metres(0, 0, 0), 6.0 * metre / second) + seek(x, metres(0, 0, 0), 6.0 * metre / second))
              .value()
              .norm() == 0);
}

TEMPLATE_TEST_CASE("who pursues meets, and nobody meets sooner", "[steering]", (Space<double, 2>), (Space<double, 3>),
                   (Space<float, 3>)) {
    using S = TestType;
    using Scalar = typename S::Scalar;
    const double eps = std::numeric_limits<Scalar>::epsilon();
    Dice<S> dice;
    int met = 0, never = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto r = dice.template vector<unit::Length>(10);
        const auto w = dice.template vector<unit::Velocity>(3);
        const auto c = dice.template number<unit::Velocity>(0.5, 8);
        const auto gap = [&](double t) { // how far the other is beyond what the walker can reach by then
            double sum = 0;
            for (int k = 0; k < S::dimension; ++k) sum += std::pow(double(r.value()[k]) + t * double(w.value()[k]), 2);
            return std::sqrt(sum) - double(c.value()) * t;
        };
        const auto t = meeting_time(r, w, c);
        if (t) {
            ++met;
            const double time = double(t->value());
            CHECK(std::abs(gap(time)) <= 1e3 * eps * (double(norm(r).value()) + double(c.value()) * time));
            for (double share = 0; share < 0.99; share += 0.01) CHECK(gap(share * time) > 0);
        } else {
            ++never;
            for (double later = 0; later < 1000; later += 0.5) CHECK(gap(later) > 0);
        }
    }
    CHECK(met > 100);
    CHECK(never > 20);
}

TEMPLATE_TEST_CASE("separation keeps momentum to the bit, and comes of a potential", "[steering]", (Space<double, 2>),
                   (Space<double, 3>), (Space<float, 2>)) {
    using S = TestType;
    using Scalar = typename S::Scalar;
    Dice<S> dice;
    const auto reach = S::Length::from_value(Scalar(2));
    const auto strength = S::template ScalarOf<unit::Force>::from_value(Scalar(5));
    int pushed = 0;
    for (int i = 0; i < 500; ++i) {
        const auto a = dice.template vector<unit::Length>(2), b = dice.template vector<unit::Length>(2);
        const auto f = separation(a, b, reach, strength), g = separation(b, a, reach, strength);
        CHECK((f + g).value().squaredNorm() == 0);
        const double d = double(norm(a - b).value());
        CHECK((norm(f).value() > 0) == (d < 2));
        if (!(d < 1.9) || d < 0.1) continue;
        ++pushed;
        // Its work over a little way along the line is what the potential F (r - d)^2 / 2r loses.
        const auto potential = [&](double x) { return 5 * (2 - x) * (2 - x) / 4; };
        CHECK(double(norm(f).value()) == Approx((potential(d - 1e-3) - potential(d + 1e-3)) / 2e-3).epsilon(1e-5));
        CHECK(dot(f, a - b).value() > 0);
    }
    CHECK(pushed > 50);
    const auto here = dice.template vector<unit::Length>(2);
    CHECK(separation(here, here, reach, strength).value().squaredNorm() == 0);
}
