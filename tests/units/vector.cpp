// SPDX-License-Identifier: BSL-1.0
// The makers of vector quantities.

#include <ansatz/units/vector.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

using namespace ansatz;
using namespace ansatz::test;

static_assert(same<decltype(metres(0, 10, 0)), VectorQuantity<unit::Length>>);
static_assert(same<decltype(metres(0, 10)), VectorQuantity<unit::Length, 2>>);
static_assert(same<decltype(metres(0.f, 10.f, 0.f)), VectorQuantity<unit::Length>>); // built-in numbers give double
static_assert(same<decltype(metres_per_second(1, 2.5, 3u)), VectorQuantity<unit::Velocity>>);
static_assert(same<decltype(metres_per_second_squared(0, -9.81, 0)), VectorQuantity<unit::Acceleration>>);
static_assert(same<decltype(newtons(1, 2)), VectorQuantity<unit::Force, 2>>);
static_assert(same<decltype(newton_metres(1, 2, 3)), VectorQuantity<unit::Torque>>);
static_assert(same<decltype(newton_seconds(1, 2, 3)), VectorQuantity<unit::Impulse>>);
static_assert(same<decltype(kilogram_metres_per_second(1, 2, 3)), VectorQuantity<unit::Momentum>>);
static_assert(same<decltype(radians_per_second(0, 0, 1)), VectorQuantity<unit::Frequency>>);
static_assert(same<decltype(vector_of(newton_per_metre, 1, 2, 3)), VectorQuantity<unit::Stiffness>>);
static_assert(same<decltype(metres(Precise(1), 2)), VectorQuantity<unit::Length, 2, Precise>>);
static_assert(same<decltype(metres(1, 2.0, Precise(3))), VectorQuantity<unit::Length, 3, Precise>>);
static_assert(same<decltype(vector_of(1 * metre, 2 * metre)), VectorQuantity<unit::Length, 2>>);
static_assert(same<decltype(vector_of(1.f * metre, 2.f * metre, 3.f * metre)), VectorQuantity<unit::Length, 3, float>>);

template <class... Args>
concept Makes = requires(Args... args) { vector_of(args...); };
static_assert(Makes<Quantity<unit::Length>, Quantity<unit::Length>>);
static_assert(!Makes<Quantity<unit::Length>, Quantity<unit::Time>>);
static_assert(!Makes<unit::Length, Quantity<unit::Length>, Quantity<unit::Length>>);

TEST_CASE("makers put every component in its place", "[units]") {
    CHECK(metres(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(metres(1, 2).value() == Eigen::Vector2d(1, 2));
    CHECK(metres_per_second(0.5, -2, 3).value() == Eigen::Vector3d(0.5, -2, 3));
    CHECK(metres_per_second_squared(0, -9.81).value() == Eigen::Vector2d(0, -9.81));
    CHECK(newtons(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(newton_metres(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(newton_seconds(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(kilogram_metres_per_second(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(radians_per_second(1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(vector_of(pascal, 1, 2, 3).value() == Eigen::Vector3d(1, 2, 3));
    CHECK(vector_of(1 * metre, 2 * metre).value() == Eigen::Vector2d(1, 2));
    CHECK(vector_of(1 * metre, 2 * metre, 3 * metre).value() == Eigen::Vector3d(1, 2, 3));
}

TEST_CASE("a maker keeps the digits of a class scalar", "[units]") {
    const Precise third = Precise(1) / 3;
    const auto v = metres(third, 0, 1);
    CHECK(v.value()[0] == third);
    CHECK(v.value()[0] != Precise(1.0 / 3));
}

TEMPLATE_TEST_CASE("components make the vector that they come from", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    const auto v = some.vector<unit::Force, S, D>();
    if constexpr (D == 2) CHECK(vector_of(x(v), y(v)) == v);
    else CHECK(vector_of(x(v), y(v), z(v)) == v);
}
