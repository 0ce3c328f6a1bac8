// SPDX-License-Identifier: BSL-1.0
// Laws: their sum, their derivatives, and how often they are asked.

#include <ansatz/motion/laws.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <cstdint>

using namespace ansatz;
using namespace ansatz::test;

namespace {

/// A law that counts how often it is asked, of the velocity if `Reads` says so.
template <class Reads = Columns<>> struct Counted {
    using role = roles::Force;
    using reads = Reads;
    std::uint64_t* asked;
    double pull = 1;
    template <class S> struct In {
        std::uint64_t* asked;
        double pull;
        explicit In(const Counted& counted) : asked(counted.asked), pull(counted.pull) {}
        typename S::Acceleration acceleration(const auto&... columns) const {
            static_assert(sizeof...(columns) == Reads::size + 1);
            ++*asked;
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = typename S::Scalar(pull);
            return S::Acceleration::from_value(a);
        }
    };
};

/// The same for a force between bodies: how often it is asked at all.
struct CountedCoupling {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    std::uint64_t* asked;
    template <class S> struct In {
        std::uint64_t* asked;
        explicit In(const CountedCoupling& counted) : asked(counted.asked) {}
        void couple(auto&, const auto&) const { ++*asked; }
    };
};

template <class I> constexpr unsigned evaluations = 1;
template <> inline constexpr unsigned evaluations<VelocityVerlet> = 2;
template <> inline constexpr unsigned evaluations<RungeKutta4> = 4;

template <class W> void populate(W& world, int awake) {
    auto some = [](double x) { return position(metres(x, 0, 0)); };
    auto add = [&](const auto&... property) {
        if constexpr (W::composition::has_mass) world.add(property..., mass(1.0 * kilogram));
        else world.add(property...);
    };
    for (int i = 0; i < awake; ++i) add(some(i));
    world.add(fixed);
    world.add(velocity(metres_per_second(1, 0, 0)), moving);
    if constexpr (W::composition::rests) add(resting);
}

} // namespace

TEMPLATE_TEST_CASE(
    "a law is asked once a stage for each awake body, and never for one that rests, is fixed or moves by itself",
    "[world][laws][N3]", ANSATZ_STAGED_INTEGRATORS) {
    std::uint64_t asked = 0;
    World world{TestType{}, Counted<>{&asked}, Rest{}};
    populate(world, 5);
    // The first step of an integrator of history asks once more: it needs the acceleration to make the history.
    world.step(1.0 / 60 * second);
    CHECK(asked == 5 * (evaluations<TestType> + (std::same_as<TestType, Verlet> ? 1 : 0)));
    asked = 0;
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60 * second);
    CHECK(asked == 10 * 5 * evaluations<TestType>);
    asked = 0;
    world.step(0.0 * second);
    CHECK(asked == 0);
}

TEST_CASE("Verlet asks once more only where a law reads the velocity", "[world][laws][N3]") {
    std::uint64_t of_position = 0, of_velocity = 0;
    World one{Verlet{}, Counted<>{&of_position}, Drag{}}; // Drag is an effect: it asks no law
    World two{Verlet{}, Counted<Columns<Velocity>>{&of_velocity}};
    populate(one, 3);
    populate(two, 3);
    one.step(1.0 / 60 * second);
    two.step(1.0 / 60 * second);
    of_position = of_velocity = 0;
    for (int i = 0; i < 10; ++i) {
        one.step(1.0 / 60 * second);
        two.step(1.0 / 60 * second);
    }
    CHECK(of_position == 10 * 3);
    CHECK(of_velocity == 10 * 3 * 2);
}

TEMPLATE_TEST_CASE("where bodies couple, law and coupling are asked once a stage as well", "[world][laws][N3]",
                   SemiImplicitEuler, Verlet, RungeKutta4) {
    std::uint64_t asked = 0, coupled = 0;
    World world{TestType{}, Counted<>{&asked}, CountedCoupling{&coupled}, Drag{}, Keep<Heat>{}};
    populate(world, 5);
    world.step(1.0 / 60 * second);
    asked = coupled = 0;
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60 * second);
    INFO("an effect that changes the velocity asks no law");
    CHECK(asked == 10 * 5 * evaluations<TestType>);
    CHECK(coupled == 10 * evaluations<TestType>);
}

TEST_CASE("a world without a law asks none, and a fixed body is asked about nothing", "[world][laws][N3]") {
    std::uint64_t asked = 0;
    World world{SemiImplicitEuler{}, Counted<>{&asked}};
    world.add(fixed);
    world.add(moving);
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60 * second);
    CHECK(asked == 0);
}

TEST_CASE("the laws of a world are summed as accelerations, and forces are divided by the mass once", "[world][laws]") {
    using S = Space<>;
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -10, 0)}, ToOrigin{2.0 / (second * second)},
                AppliedForces{}, QuadraticDrag{0.5 * kilogram_per_metre}};
    const auto body = world.add(position(metres(1, 2, 3)), velocity(metres_per_second(0, 0, 2)), mass(4.0 * kilogram));
    world.apply_force(body, newtons(8, 0, 0));
    // -2 x + g + F/m - k |v| v / m, each of them a binary fraction
    CHECK(world.acceleration(body) == metres_per_second_squared(-2 + 2, -4 - 10, -6 - 0.5 * 2 * 2 / 4));
    const Laws<S, Gravity> alone{Gravity{metres_per_second_squared(1, 2, 3)}}; // without any world
    const Context<S> now(0.0 * second, TimeStep<S>(0.1 * second, 0.1 * second));
    CHECK(S::Acceleration(alone.acceleration(Row<S, Columns<>>{}, now)) == metres_per_second_squared(1, 2, 3));
    const Laws<S> none;
    CHECK(S::Acceleration(none.acceleration(Row<S, Columns<>>{}, now)) == metres_per_second_squared(0, 0, 0));
}

TEST_CASE("the Jacobian of the laws is the derivative of their sum, of forces and accelerations alike",
          "[world][laws]") {
    using S = Space<>;
    const Laws<S, ToOrigin, QuadraticDrag, Gravity> laws{ToOrigin{3.0 / (second * second)},
                                                         QuadraticDrag{0.5 * kilogram_per_metre}, Gravity{}};
    const Context<S> now(0.0 * second, TimeStep<S>(0.1 * second, 0.1 * second));
    Row<S, Columns<Position, Velocity, InverseMass>> row;
    row.get<Position>() = metres(1, -2, 3);
    row.get<Velocity>() = metres_per_second(2, 1, -2);
    row.get<InverseMass>() = 0.25 / kilogram;
    const auto exact = laws.jacobian(row, now);
    const double h =
        1e-5; // the error of a central difference is of order h^2 times third derivatives near 1, plus 1e-16 / h
    for (int column = 0; column < 3; ++column) {
        auto difference = [&]<class C>(Columns<C>) {
            auto shifted = [&](double by) {
                auto moved = row;
                auto value = moved.get<C>().value();
                value[column] += by;
                moved.get<C>() = value_of<C, S>::from_value(value);
                return S::Acceleration(laws.acceleration(moved, now)).value();
            };
            return Eigen::Vector3d((shifted(h) - shifted(-h)) / (2 * h));
        };
        CHECK((difference(Columns<Position>{}) - exact.position.value().col(column)).norm() < 1e-9);
        CHECK((difference(Columns<Velocity>{}) - exact.velocity.value().col(column)).norm() < 1e-9);
    }
}

TEST_CASE("each stage asks the laws at its own time", "[world][laws]") {
    // a = 1 from t = 1/2 on: in the step from 0 to 1 RungeKutta4 sees it with weights 2/6, 2/6, 1/6 of its last three
    // stages.
    World world{RungeKutta4{}, Later{0.5 * second}};
    const auto body = world.add();
    world.step(1.0 * second);
    CHECK(world.velocity(body).value()[0] == Catch::Approx(5.0 / 6).epsilon(1e-15));
    World euler{SemiImplicitEuler{}, Later{0.5 * second}};
    const auto other = euler.add();
    euler.step(0.5 * second);
    CHECK(euler.velocity(other).value()[0] == 0);
    euler.step(0.5 * second);
    CHECK(euler.velocity(other).value()[0] == 0.5);
    World implicit{ImplicitEuler{}, Later{0.5 * second}};
    const auto third = implicit.add();
    implicit.step(0.5 * second); // asks at the end of the step
    CHECK(implicit.velocity(third).value()[0] == 0.5);
}
