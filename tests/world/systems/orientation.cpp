// SPDX-License-Identifier: BSL-1.0
// A degree of freedom outside the library, against the public frame only: bodies that turn. Their orientation is a
// column of a shape of its own; the world's integrator advances it by the lines that it has for translation.

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <type_traits>

using namespace ansatz;

namespace {

//! [turning]
/// An orientation in a plane: the angle's cosine and sine, which a turn multiplies.
template <class Scalar> struct Rotation {
    Scalar c{1}, s{0};
    static Rotation from_lanes(const Scalar* raw) { return {raw[0], raw[1]}; }
    void to_lanes(Scalar* raw) const { raw[0] = c, raw[1] = s; }
    void check() const {
        if (!(std::abs(c * c + s * s - 1) < Scalar(1e-4)))
            refuse_value("Rotation", "its length", c * c + s * s, "it is 1");
    }
    friend Rotation operator+(const Rotation& r, const Quantity<unit::Dimensionless, Scalar>& by) {
        const Scalar cosine = std::cos(by.value()), sine = std::sin(by.value());
        return {r.c * cosine - r.s * sine, r.s * cosine + r.c * sine};
    }
    Rotation& operator+=(const Quantity<unit::Dimensionless, Scalar>& by) { return *this = *this + by; }
};
struct InPlane {
    template <class S, class> using Value = Rotation<typename S::Scalar>;
    static constexpr std::size_t lanes(int) { return 2; }
};
struct Orientation {
    using Unit = unit::Dimensionless;
    static constexpr InPlane shape{};
    static constexpr std::string_view name = "orientation";
};
struct Spin { // in a plane it is one number
    using Unit = unit::Frequency;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "spin";
};
/// Turned by a constant torque, and slowed in proportion to its spin.
struct Turning {
    using role = roles::DegreeOfFreedom;
    using position = Orientation;
    using velocity = Spin;
    Quantity<unit::FrequencySquared> push = 0.0 / (second * second); // torque over inertia
    Quantity<unit::Frequency> slow = 0.0 / second;

    template <class S> struct In {
        typename S::template ScalarOf<unit::FrequencySquared> push;
        typename S::template ScalarOf<unit::Frequency> slow;
        explicit In(const Turning& t) : push(S::convert("push", t.push)), slow(S::convert("slow", t.slow)) {}
        auto acceleration(const auto&, const auto& spin, const auto&) const { return push - slow * spin; }
    };
};
//! [turning]

template <class Scalar, class I, class... More> auto thrown(const I& integrator, const More&... more) {
    World world{Space<Scalar, 2>{}, integrator, Gravity{}, Drag{}, more...};
    const auto ball = world.add(position(metres(1, 2)), velocity(metres_per_second(3, 4)));
    return std::pair(world, ball);
}
/// The angle after a second with a spin of 2/s at the beginning, less the true one.
template <class I> double error(int steps, const Turning& turning) {
    auto [world, ball] = thrown<double>(I{}, turning);
    world.template write<Spin>(ball, 2.0 / second);
    for (int i = 0; i < steps; ++i) world.step(1.0 / steps * second);
    const auto r = world.template read<Orientation>(ball);
    const double p = turning.push.value(), k = turning.slow.value();
    const double angle = k > 0 ? p / k + (2 - p / k) * (1 - std::exp(-k)) / k : 2 + p / 2;
    return std::remainder(std::atan2(r.s, r.c) - angle, 2 * std::acos(-1.0));
}

} // namespace

TEST_CASE("A body turns as its integrator moves it", "[systems]") {
    CHECK(std::abs(error<SemiImplicitEuler>(10, {})) < 1e-14); // at a constant spin both are exact
    CHECK(std::abs(error<RungeKutta4>(10, {})) < 1e-14);
    const Turning pushed{.push = 3.0 / (second * second), .slow = 2.0 / second};
    CHECK(error<SemiImplicitEuler>(200, pushed) / error<SemiImplicitEuler>(400, pushed) == Approx(2).epsilon(0.02));
    CHECK(error<RungeKutta4>(20, pushed) / error<RungeKutta4>(40, pushed) == Approx(16).epsilon(0.1));
}
TEMPLATE_TEST_CASE("Its absence changes no bit", "[systems]", SemiImplicitEuler, RungeKutta4) {
    auto [without, a] = thrown<float>(TestType{});
    auto [with, b] = thrown<float>(TestType{}, Turning{.push = 1.0 / (second * second)});
    with.template write<Spin>(b, 5.0 / second);
    for (int i = 0; i < 200; ++i) {
        without.step(1.0 / 60 * second);
        with.step(1.0 / 60 * second);
        CHECK(without.position(a) == with.position(b));
        CHECK(without.velocity(a) == with.velocity(b));
    }
    static_assert(decltype(with)::composition::stored::size == decltype(without)::composition::stored::size + 2);
}
TEST_CASE("It is copied, hashed, saved and loaded", "[systems]") {
    auto [world, ball] = thrown<float>(RungeKutta4{}, Turning{.push = 1.0 / (second * second)});
    world.step(0.25 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto [loaded, other] = thrown<float>(RungeKutta4{}, Turning{.push = 1.0 / (second * second)});
    CHECK(loaded.hash() != world.hash());
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded}) one->step(0.25 * second);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK_THROWS_WITH(world.write<Orientation>(ball, Rotation<float>{2, 0}), Catch::Contains("length is 4"));
}
