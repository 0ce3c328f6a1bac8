// SPDX-License-Identifier: BSL-1.0
#include <ansatz/motion/integrators/implicit_euler.hpp>

#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("implicit Euler moves with the rates of the next state, as its matrix says", "[motion][implicit_euler]") {
    check_closed_form<ImplicitEuler>([](long double w, long double h) {
        const long double d = 1 + w * w * h * h;
        return Amplification{1 / d, h / d, -w * w * h / d, 1 / d};
    });
}

TEST_CASE("implicit Euler solves its equation also where the force is not linear", "[motion][implicit_euler]") {
    // What was found must satisfy v1 = v0 + h a(x1, v1) and x1 = x0 + h v1, for quadratic drag by its closed form:
    // along a line u + h k/m u^2 = v has the root 2 v / (1 + sqrt(1 + 4 v h k/m)).
    for (const double h : {1e-3, 0.1, 10.0, 1e6})
        for (const double v : {1e-3, 1.0, 300.0}) {
            World world{Space<double, 2>{}, ImplicitEuler{}, QuadraticDrag{0.5 * kilogram_per_metre}};
            const auto body = world.add(velocity(metres_per_second(0.6 * v, -0.8 * v)), mass(2.0 * kilogram));
            world.step(h * second);
            const double expected = 2 * v / (1 + std::sqrt(1 + 4 * v * h * 0.25));
            const auto now = world.velocity(body).value();
            INFO("h = " << h << " s, v = " << v << " m/s: " << now.norm() << " m/s, should be " << expected);
            CHECK(world.status().ok());
            CHECK(std::abs(now[0] - 0.6 * expected) <= 1e-12 * v);
            CHECK(std::abs(now[1] + 0.8 * expected) <= 1e-12 * v);
            CHECK(std::abs(world.position(body).value()[0] - h * now[0]) <= 1e-13 * h * v);
        }
}

TEST_CASE("implicit Euler never makes an oscillator grow, at any step", "[motion][implicit_euler]") {
    for (const double h : {1e-6, 1e-2, 1.0, 1e2, 1e6}) {
        World world{Space<double, 2>{}, ImplicitEuler{}, Oscillator{100.0 / second}};
        const auto body = add_body(world, OnALine{1.0 * metre, 50.0 * metre_per_second});
        double energy = 100.0 * 100.0 + 50.0 * 50.0;
        for (int i = 0; i < 100; ++i) {
            world.step(h * second);
            const auto s = state(world, body);
            const double now = 1e4 * s[0] * s[0] + s[3] * s[3];
            REQUIRE(now <= energy * (1 + 1e-14));
            energy = now;
        }
        CHECK(world.status().ok());
    }
}

namespace {
/// A force without a zero of v - h a(v) - v0: Newton's method has nothing to find.
struct NoAnswer {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const NoAnswer&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = v.value()[0] * v.value()[0] + 1; // u - h (u^2 + 1) = 0 has no real root for h > 1/2
            return S::Acceleration::from_value(a);
        }
        Jacobian<S> jacobian(const typename S::Velocity& v, const auto&) const {
            Jacobian<S> j{};
            auto m = j.velocity.value();
            m(0, 0) = 2 * v.value()[0];
            j.velocity = decltype(j.velocity)::from_value(m);
            return j;
        }
    };
};
} // namespace

TEST_CASE("implicit Euler reports an equation that it could not solve", "[motion][implicit_euler]") {
    World world{Space<double, 2>{}, ImplicitEuler{}, NoAnswer{}};
    const auto body = world.add();
    world.step(0.4 * second); // u - 0.4 (u^2 + 1) = 0 has the root 0.5
    CHECK(world.status().ok());
    CHECK(std::abs(world.velocity(body).value()[0] - 0.5) <= 1e-14);
    world.step(1.0 * second);
    CHECK_FALSE(world.status().ok());
    CHECK(is_finite(world.velocity(body)));
}
