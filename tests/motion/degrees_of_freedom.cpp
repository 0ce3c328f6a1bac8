// SPDX-License-Identifier: BSL-1.0
// Degrees of freedom beside translation: in space, where a quaternion turns by a vector; run body by body and stage by
// stage; on platforms and on bodies that nothing moves; laws that read columns and the time.

#include <ansatz/motion/degrees_of_freedom.hpp>
#include <ansatz/motion/integrators/compensated.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>

using namespace ansatz;

namespace {

/// A unit quaternion, turned by a rotation vector in the frame of the world.
template <class Scalar> struct Turned {
    Eigen::Quaternion<Scalar> q = Eigen::Quaternion<Scalar>::Identity();
    using Turn = VectorQuantity<unit::Dimensionless, 3, Scalar>;
    static Turned from_lanes(const Scalar* raw) { return {Eigen::Quaternion<Scalar>(raw[0], raw[1], raw[2], raw[3])}; }
    void to_lanes(Scalar* raw) const { raw[0] = q.w(), raw[1] = q.x(), raw[2] = q.y(), raw[3] = q.z(); }
    friend Turned operator+(const Turned& from, const Turn& by) {
        const Eigen::Matrix<Scalar, 3, 1> v(by.value()[0], by.value()[1], by.value()[2]);
        const Scalar half = v.norm() / 2, part = half > Scalar(1e-4) ? std::sin(half) / (2 * half) : Scalar(0.5);
        const Eigen::Quaternion<Scalar> turn(std::cos(half), part * v.x(), part * v.y(), part * v.z());
        return {(turn * from.q).normalized()};
    }
    Turned& operator+=(const Turn& by) { return *this = *this + by; }
};
struct InSpace {
    template <class S, class> using Value = Turned<typename S::Scalar>;
    static constexpr std::size_t lanes(int) { return 4; }
};
struct Attitude {
    using Unit = unit::Dimensionless;
    static constexpr InSpace shape{};
    static constexpr std::string_view name = "attitude";
};
struct AngularVelocity {
    using Unit = unit::Frequency;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "angular velocity";
};
struct Slowing {
    using Unit = unit::Frequency;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "slowing";
};
struct Turning {
    using role = roles::DegreeOfFreedom;
    using position = Attitude;
    using velocity = AngularVelocity;
    using reads = Columns<Slowing>;
    template <class S> struct In {
        explicit In(const Turning&) {}
        auto acceleration(const auto&, const auto& w, const auto& slowing, const auto&) const { return -slowing * w; }
    };
};
/// A second one beside it, pushed by the time.
struct Charge {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "charge";
};
struct Current {
    using Unit = unit::Velocity;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "current";
};
struct Charging {
    using role = roles::DegreeOfFreedom;
    using position = Charge;
    using velocity = Current;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const Charging&) {}
        auto acceleration(const auto&, const auto&, const auto& context) const {
            using A = typename S::template ScalarOf<unit::Acceleration>;
            return A::from_value(typename S::Scalar(context.time().value())); // x''' = 1 m/s^3
        }
    };
};

template <class I, class... More> auto turning(const More&... more) {
    World world{I{}, Turning{}, Charging{}, Gravity{}, more...};
    const auto body = [&](const auto&... how) {
        return world.add(with<AngularVelocity>(radians_per_second(1.0, 2.0, -2.0)), with<Slowing>(0.5 / second),
                         how...);
    };
    const auto free = [&] {
        if constexpr (sizeof...(More) > 0) return body(mass(2.0 * kilogram));
        else return body();
    }();
    const auto platform = body(moving), ground = body(fixed);
    return std::tuple(world, free, platform, ground);
}
/// By how much a body has turned about (1, 2, -2)/3; NaN if it was about another axis.
double turned(const auto& world, Handle body) {
    const auto q = world.template read<Attitude>(body).q;
    const Eigen::Vector3d axis(1 / 3.0, 2 / 3.0, -2 / 3.0), v = q.vec();
    const double along = v.dot(axis);
    if ((v - along * axis).norm() > 1e-12) return std::nan("");
    return 2 * std::atan2(along, q.w());
}
template <class I> double error(int steps) {
    auto [world, free, platform, ground] = turning<I>();
    for (int i = 0; i < steps; ++i) world.step(1.0 / steps * second);
    return turned(world, free) - 3 * (1 - std::exp(-0.5)) / 0.5;
}

} // namespace

TEST_CASE("A body turns about its axis as far as its spin says, to the order of its integrator", "[degrees]") {
    CHECK(error<SemiImplicitEuler>(200) / error<SemiImplicitEuler>(400) == Approx(2).epsilon(0.01));
    CHECK(error<VelocityVerlet>(50) / error<VelocityVerlet>(100) == Approx(4).epsilon(0.05));
    CHECK(error<RungeKutta4>(10) / error<RungeKutta4>(20) == Approx(16).epsilon(0.1));
}
TEMPLATE_TEST_CASE("Stage by stage it is what it is body by body, to the bit", "[degrees]", ExplicitEuler,
                   SemiImplicitEuler, VelocityVerlet, RungeKutta4) {
    auto [alone, a, pa, ga] = turning<TestType>();
    auto [coupled, b, pb, gb] = turning<TestType>(Springs{});
    for (int i = 0; i < 50; ++i) {
        alone.step(1.0 / 60 * second);
        coupled.step(1.0 / 60 * second);
        CHECK(alone.template read<Attitude>(a).q.coeffs() == coupled.template read<Attitude>(b).q.coeffs());
        CHECK(alone.template read<Charge>(a) == coupled.template read<Charge>(b));
        CHECK(alone.position(a) == coupled.position(b));
        CHECK(alone.template read<Attitude>(pa).q.coeffs() == coupled.template read<Attitude>(pb).q.coeffs());
    }
}
TEMPLATE_TEST_CASE("A platform goes on turning as it does, and nothing turns what is fixed", "[degrees]",
                   SemiImplicitEuler, RungeKutta4) {
    auto [world, free, platform, ground] = turning<TestType>();
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    CHECK(turned(world, platform) == Approx(3.0).epsilon(1e-12)); // rad, in a second, with 3 rad/s
    CHECK(world.template read<AngularVelocity>(platform) == radians_per_second(1.0, 2.0, -2.0));
    CHECK(turned(world, ground) == 0);
    CHECK(world.template read<Charge>(platform).value() == 0);
}
TEST_CASE("A law is asked at the time of its stage", "[degrees]") {
    auto [world, free, platform, ground] = turning<RungeKutta4>();
    for (int i = 0; i < 10; ++i) world.step(0.1 * second);
    CHECK(world.read<Charge>(free).value() == Approx(1.0 / 6).epsilon(1e-14)); // exact for what grows as t^3
}
TEST_CASE("Compensated leaves what is not a position to the lines of the inner integrator, to the bit", "[degrees]") {
    const auto compare = []<class I>(const auto&... more) {
        auto [with, body, platform, ground] = turning<Compensated<I>>(more...);
        auto without = std::get<0>(turning<I>(more...));
        for (int i = 0; i < 50; ++i) {
            with.step(0.02 * second);
            without.step(0.02 * second);
        }
        for (const auto one : {body, platform, ground}) {
            CHECK(with.template read<Attitude>(one).q.coeffs() == without.template read<Attitude>(one).q.coeffs());
            CHECK(with.template read<Charge>(one) == without.template read<Charge>(one));
        }
    };
    compare.operator()<SemiImplicitEuler>();
    compare.operator()<RungeKutta4>();
    compare.operator()<RungeKutta4>(Springs{});
}
