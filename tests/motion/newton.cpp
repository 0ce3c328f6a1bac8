// SPDX-License-Identifier: BSL-1.0

// Newton's laws as functions, notes 1.1 to 1.3: each test is one of the laws, or what follows from it.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <ansatz/motion/newton.hpp>
#include <ansatz/motion/suvat.hpp>
#include <ansatz/units/print.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <string>
#include <type_traits>

using namespace ansatz;
using namespace ansatz::mechanics;
using ansatz::test::refusal;

TEST_CASE("Newton: F = m a, along a line and in space", "[motion][newton]") {
    CHECK(force(2 * kilogram, 3 * metre_per_second_squared) == 6 * newton);
    CHECK(acceleration(6 * newton, 2 * kilogram) == 3 * metre_per_second_squared);
    const auto weight = force(2 * kilogram, metres_per_second_squared(0, -9.81, 0));
    CHECK(in(weight, newton) == Eigen::Vector3d(0, -19.62, 0));
    CHECK(in(acceleration(weight, 2 * kilogram), metre_per_second_squared) == Eigen::Vector3d(0, -9.81, 0));
    static_assert(std::is_same_v<decltype(weight), const VectorQuantity<unit::Force>>);
}

TEST_CASE("Newton: half the mass is twice the acceleration, twice the force too", "[motion][newton]") {
    const auto push = newtons(3, -1, 2);
    const auto a = acceleration(push, 0.7 * kilogram);
    CHECK(in(acceleration(push, 0.35 * kilogram), metre_per_second_squared) == in(2.0 * a, metre_per_second_squared));
    CHECK(in(acceleration(2.0 * push, 0.7 * kilogram), metre_per_second_squared) ==
          in(2.0 * a, metre_per_second_squared));
}

TEST_CASE("Newton: forces act together as their vector sum", "[motion][newton]") {
    const auto sum = resultant(newtons(3, 0, 0), newtons(0, 4, 0), newtons(0, 0, 12));
    CHECK(in(sum, newton) == Eigen::Vector3d(3, 4, 12));
    CHECK(norm(sum) == 13 * newton); // not 19 N, the sum of the magnitudes
    CHECK(resultant(3 * newton, -4 * newton) == -1 * newton);
    CHECK(in(resultant(newtons(1, 2)), newton) == Eigen::Vector2d(1, 2)); // of one force: itself
    // Each force gives the acceleration that it would give alone.
    const auto a = acceleration(sum, 2 * kilogram);
    const auto one_by_one = acceleration(newtons(3, 0, 0), 2 * kilogram) +
                            acceleration(newtons(0, 4, 0), 2 * kilogram) +
                            acceleration(newtons(0, 0, 12), 2 * kilogram);
    CHECK(in(a, metre_per_second_squared) == in(one_by_one, metre_per_second_squared));
}

TEST_CASE("Newton: no resultant, no acceleration: the velocity stays", "[motion][newton]") {
    const auto a = acceleration(resultant(newtons(0, -19.62, 0), newtons(0, 19.62, 0)), 2 * kilogram);
    CHECK(in(a, metre_per_second_squared) == Eigen::Vector3d(0, 0, 0));
    const auto later = suvat::solve(suvat::initial_velocity(5 * metre_per_second), suvat::acceleration(y(a)),
                                    suvat::time(1e9 * second));
    CHECK(later.front().v == 5 * metre_per_second);
}

TEST_CASE("Newton: equilibrium is a sum of zero up to its own rounding", "[motion][newton]") {
    CHECK(in_equilibrium(0.1 * newton, 0.2 * newton, -0.3 * newton)); // whose sum in doubles is 5.6e-17 N
    CHECK(0.1 * newton + 0.2 * newton - 0.3 * newton != 0 * newton);
    CHECK_FALSE(in_equilibrium(0.1 * newton, 0.2 * newton, -0.300000000001 * newton));
    CHECK(in_equilibrium(newtons(0, 0, 0)));
    CHECK_FALSE(in_equilibrium(newtons(0, 1e-30, 0))); // however small: nothing balances it
    // Three ropes at 120 degrees.
    const auto rope = [](double angle) { return newtons(7 * std::cos(angle), 7 * std::sin(angle)); };
    const double third = 2 * 3.14159265358979323846 / 3;
    CHECK(in_equilibrium(rope(0.3), rope(0.3 + third), rope(0.3 - third)));
    CHECK_FALSE(in_equilibrium(rope(0.3), rope(0.3 + third), rope(0.3001 - third)));
    // In float, and whatever the unit of force is.
    CHECK(in_equilibrium(0.1f * newton, 0.2f * newton, -0.3f * newton));
    for (const double scale : {1e-100, 1e100}) {
        CHECK(in_equilibrium(scale * 0.1 * newton, scale * 0.2 * newton, -(scale * (0.1 + 0.2)) * newton));
        CHECK_FALSE(in_equilibrium(scale * 0.1 * newton, scale * 0.2 * newton, scale * -0.300001 * newton));
    }
    CHECK_FALSE(in_equilibrium(std::nan("") * newton, 1 * newton));
}

TEST_CASE("Newton: action and reaction sum to nothing, to the bit", "[motion][newton]") {
    const auto action = newtons(0.1, -1e-300, 3e15);
    CHECK(in(resultant(action, reaction(action)), newton) == Eigen::Vector3d(0, 0, 0));
    CHECK(in(reaction(reaction(action)), newton) == in(action, newton));
    // They act on two bodies: the accelerations are as the inverse masses, and opposite.
    const auto stone = acceleration(action, 2 * kilogram), earth = acceleration(reaction(action), 8 * kilogram);
    CHECK(in(stone, metre_per_second_squared) == in(-4.0 * earth, metre_per_second_squared));
}

TEST_CASE("Newton: parameters, floats and high-precision scalars are taken", "[motion][newton]") {
    const Parameter<unit::Mass> load = 4 * kilogram;
    const VectorParameter<unit::Force> push = newtons(8, 0, 0);
    CHECK(in(acceleration(push, load), metre_per_second_squared) == Eigen::Vector3d(2, 0, 0));
    CHECK(in(resultant(push, newtons(1, 1, 1)), newton) == Eigen::Vector3d(9, 1, 1));
    CHECK(in(reaction(push), newton) == Eigen::Vector3d(-8, 0, 0));
    static_assert(
        std::is_same_v<decltype(force(2.f * kilogram, 3.f * metre_per_second_squared)), Quantity<unit::Force, float>>);
    using Fifty =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
    const auto third = acceleration(Fifty(1) * newton, Fifty(3) * kilogram);
    CHECK(abs(in(third, metre_per_second_squared) * 3 - 1) < Fifty("1e-49"));
    CHECK(in_equilibrium(Fifty("0.1") * newton, Fifty("0.2") * newton, Fifty("-0.3") * newton));
}

TEST_CASE("Newton: a mass is finite and greater than zero", "[motion][newton]") {
    const auto push = newtons(1, 0, 0);
    CHECK(refusal([&] { acceleration(push, 0 * kilogram); }) ==
          "mechanics::acceleration: mass is 0 kg; it must be finite and greater than zero");
    CHECK(refusal([&] { acceleration(push, -3 * kilogram); }).find("-3 kg") != std::string::npos);
    CHECK(refusal([&] { acceleration(push, std::nan("") * kilogram); }).find("nan kg") != std::string::npos);
    CHECK(refusal([&] { force(HUGE_VAL * kilogram, 1 * metre_per_second_squared); }) ==
          "mechanics::force: mass is inf kg; it must be finite and greater than zero");
}
