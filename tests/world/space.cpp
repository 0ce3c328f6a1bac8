// SPDX-License-Identifier: BSL-1.0
// Spaces: float, double, two and three dimensions, and a number of fifty digits in the same world.

#include <ansatz/world/space.hpp>

#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace ansatz;
using namespace ansatz::test;

namespace {
using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Fifty = Space<Precise, 2>;
} // namespace

static_assert(std::same_as<Space<>, Space<double, 3>>);
static_assert(std::same_as<space_of<Gravity, SemiImplicitEuler>, Space<double, 3>>); // the one silent default
static_assert(std::same_as<space_of<Gravity, Space<float, 2>, SemiImplicitEuler>, Space<float, 2>>);
static_assert(std::same_as<Space<float, 2>::ClockScalar, double> &&
              std::same_as<Space<double, 2>::ClockScalar, double>);
static_assert(std::same_as<Fifty::ClockScalar, Precise>);
static_assert(std::same_as<Space<float, 2>::Position, VectorQuantity<unit::Length, 2, float>>);
static_assert(std::same_as<Space<float, 2>::Mass, Quantity<unit::Mass, float>>);

TEST_CASE("parameters are converted to a space's scalar and dimension, and refused where a component would be lost",
          "[world][space]") {
    const auto three = metres(1, 2, 0);
    CHECK(Space<float, 2>::convert("where", three).value() == Eigen::Vector2f(1, 2));
    CHECK(Space<float, 3>::convert("where", metres(1, 2, 3)).value() == Eigen::Vector3f(1, 2, 3));
    CHECK(Space<float, 2>::convert(0.1 * second).value() == 0.1f);
    CHECK(Space<double, 2>::zero_vector<unit::Velocity>().value() == Eigen::Vector2d::Zero());
    const auto text = sentence<std::invalid_argument>(
        [] { Space<double, 2>::convert("Wind::velocity", metres_per_second(0, 0, 4)); });
    CHECK(text ==
          "World: Wind::velocity is (0, 0, 4) m/s; this world has two dimensions, so its third component must be 0");
}

TEST_CASE("fifty digits step as the closed form of the scheme says", "[world][space]") {
    World world{Fifty{}, Verlet{}, Gravity{metres_per_second_squared(0, -8, 0)}};
    const auto body = world.add(position(metres(1, 2)), velocity(metres_per_second(3, 4)));
    const Precise third = Precise(1) / 3; // no binary fraction: what double could not do to fifty digits
    const auto dt = Quantity<unit::Time, Precise>::from_value(third);
    const int n = 30;
    for (int i = 0; i < n; ++i) world.step(dt);
    const Precise t = n * third;
    const Precise tolerance("1e-45"); // a few hundred roundings of numbers near 400
    CHECK(abs(world.position(body).value()[0] - (1 + 3 * t)) < tolerance);
    CHECK(abs(world.position(body).value()[1] - (2 + 4 * t - 4 * t * t)) < tolerance);
    CHECK(abs(world.velocity(body).value()[1] - (4 - 8 * t)) < tolerance);
    CHECK(abs(world.time().value() - t) < tolerance);
    CHECK(world.status().ok());
    auto copy = world;
    copy.step(dt);
    world.step(dt);
    CHECK(copy.hash() == world.hash());
    CHECK(copy.position(body).value() == world.position(body).value());
}

TEST_CASE("fifty digits solve, damp, rest and are refused like two dozen bits", "[world][space]") {
    World world{Fifty{}, ImplicitEuler{}, ToOrigin{}, Drag{0.5 / second}, Rest{}};
    const auto body = world.add(position(metres(1, 0)));
    world.step(1.0 / 4 * second);
    // x1 = x0 + h v1, v1 = v0 - h x1: x1 = x0 / (1 + h^2), v1 = -h x1, then damped by exp(-h / 2).
    const Precise x1 = 1 / (1 + Precise(1) / 16);
    CHECK(abs(world.position(body).value()[0] - x1) < Precise("1e-47"));
    CHECK(abs(world.velocity(body).value()[0] + x1 / 4 * exp(-Precise(1) / 8)) < Precise("1e-47"));
    const auto before = world.hash();
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(sentence<std::invalid_argument>([&] { world.step(nan * second); }).find("World::step: dt is nan s; ") == 0);
    CHECK(sentence<std::invalid_argument>([&] {
              world.set_position(body, metres(nan, 0));
          }).find("World::set_position: position is (nan") == 0);
    CHECK(world.hash() == before);
}

TEST_CASE("fifty digits survive a file, to the last", "[world][space][save]") {
    World world{Fifty{}, Verlet{}, Gravity{metres_per_second_squared(0, -8, 0)}};
    const Precise third = Precise(1) / 3;
    const auto body = world.add(position(metres(third, -sqrt(Precise(2)) * Precise("1e-30"))));
    world.step(Quantity<unit::Time, Precise>::from_value(third));
    std::stringstream file;
    save(world, file);
    World loaded{Fifty{}, Verlet{}, Gravity{metres_per_second_squared(0, -8, 0)}};
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    CHECK(loaded.position(body).value() == world.position(body).value());
    CHECK(loaded.time() == world.time());
    World narrow{Space<double, 2>{}, SemiImplicitEuler{}};
    std::istringstream again(file.str());
    CHECK(sentence<std::invalid_argument>([&] {
              load(narrow, again, "game");
          }).find("game: scalar is \"class\"; expected \"double\"") == 0);
}
