// SPDX-License-Identifier: BSL-1.0
// Parameters of policies. What they refuse, with which sentence, is in tests/must_not_compile.

#include <ansatz/units/parameter.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

using namespace ansatz;
using namespace ansatz::test;

namespace {
struct Drag {
    Parameter<unit::Frequency> rate = 0.05 / second;
};
struct Gravity {
    VectorParameter<unit::Acceleration> acceleration = metres_per_second_squared(0, -9.81, 0);
};
struct Rest {
    Parameter<unit::Velocity> speed;
    Parameter<unit::Time> after = 0.5 * second;
    Parameter<unit::Dimensionless> share = 0.25;
};
} // namespace

// An aggregate of parameters is one for the compiler too, and costs what its numbers cost.
static_assert(std::is_aggregate_v<Drag> && std::is_aggregate_v<Rest>);
static_assert(sizeof(Parameter<unit::Length>) == sizeof(double) && sizeof(Rest) == 3 * sizeof(double));
static_assert(sizeof(VectorParameter<unit::Length>) == sizeof(Eigen::Vector3d));
constexpr Drag some_drag{0.1 / second};
static_assert(some_drag.rate.value() == 0.1);
static_assert(Drag{}.rate.value() == 0.05);
static_assert(Rest{}.speed.value() == 0.0 && Rest{.speed = {}, .after = {}, .share = 0.5}.share.value() == 0.5);

// It is a quantity in every expression.
static_assert(same<decltype(2.0 * some_drag.rate), Quantity<unit::Frequency>>);
static_assert(same<decltype(some_drag.rate * 2), Quantity<unit::Frequency>>);
static_assert(same<decltype(-some_drag.rate), Quantity<unit::Frequency>>);
static_assert(same<decltype(1 / some_drag.rate), Quantity<unit::Time>>);
static_assert(same<decltype(some_drag.rate + some_drag.rate), Quantity<unit::Frequency>>);
static_assert(same<decltype(some_drag.rate * some_drag.rate), Quantity<unit::FrequencySquared>>);
static_assert(same<decltype(some_drag.rate * metre), Quantity<unit::Velocity>>);
static_assert(same<decltype(metre * some_drag.rate), Quantity<unit::Velocity>>);
static_assert(same<decltype(some_drag.rate / hertz), Quantity<unit::Dimensionless>>);
static_assert(same<decltype(some_drag.rate * metres(1, 2, 3)), VectorQuantity<unit::Velocity>>);
static_assert(same<decltype(Eigen::Vector3d() * some_drag.rate), VectorQuantity<unit::Frequency>>);
static_assert(same<decltype(Gravity{}.acceleration * (1 * second)), VectorQuantity<unit::Velocity>>);
static_assert(same<decltype(2.0 * Gravity{}.acceleration), VectorQuantity<unit::Acceleration>>);
static_assert(same<decltype(-Gravity{}.acceleration), VectorQuantity<unit::Acceleration>>);
static_assert(same<decltype(Gravity{}.acceleration / metre), VectorQuantity<unit::FrequencySquared>>);
static_assert(same<decltype(scalar_cast<float>(Gravity{}.acceleration)), VectorQuantity<unit::Acceleration, 3, float>>);
static_assert(same<decltype(norm(Gravity{}.acceleration)), Quantity<unit::Acceleration>>);
static_assert(std::is_convertible_v<Parameter<unit::Length>, Quantity<unit::Length>>);

TEST_CASE("parameters take quantities", "[units]") {
    const Drag drag{0.1 / second};
    CHECK(drag.rate == 0.1 / second);
    const VectorParameter<unit::Dimensionless> normal = Eigen::Vector2d(3, 4), turned = -2 * Eigen::Vector2f(3, 4);
    CHECK(normal.value() == Eigen::Vector3d(3, 4, 0));
    CHECK(turned.value() == Eigen::Vector3d(-6, -8, 0));
    CHECK(Drag{2 / second}.rate == 2.0 / second);
    CHECK(Drag{2 * hertz}.rate == 2.0 / second);
    CHECK(Drag{0.5f / second}.rate == 0.5 / second); // a float widens
    CHECK(Gravity{metres_per_second_squared(1, 2, 3)}.acceleration == metres_per_second_squared(1, 2, 3));
    CHECK(Gravity{metres_per_second_squared(1, 2)}.acceleration ==
          metres_per_second_squared(1, 2, 0)); // the plane in space
    CHECK(Gravity{scalar_cast<float>(metres_per_second_squared(1, 2, 3))}.acceleration ==
          metres_per_second_squared(1, 2, 3));
    CHECK(Rest{.speed = 1 * metre_per_second}.after == 0.5 * second);
    const Rest rest{0.1 * metre_per_second, 2.0 * second, 1};
    CHECK(rest.share.value() == 1.0);
    CHECK(Parameter<unit::Length>(drag.rate / (1 / metre) * second).value() == 0.1);
}

TEST_CASE("parameters compute like quantities and can be changed", "[units]") {
    Gravity g;
    Drag drag{0.5 / second};
    const auto v = metres_per_second(2, 4, 6);
    CHECK(g.acceleration - drag.rate * v == metres_per_second_squared(-1, -11.81, -3));
    CHECK(v + g.acceleration * (1 * second) == metres_per_second(2, 4 - 9.81, 6));
    g.acceleration *= 2;
    CHECK(g.acceleration == metres_per_second_squared(0, -19.62, 0));
    g.acceleration = metres_per_second_squared(1, 0, 0);
    g.acceleration += metres_per_second_squared(0, 1, 0);
    CHECK(g.acceleration == metres_per_second_squared(1, 1, 0));
    drag.rate = 2 / second;
    drag.rate += drag.rate;
    CHECK(drag.rate == 4 / second);
    CHECK(drag.rate > 3 / second);
    CHECK(describe(drag.rate) == "4 1/s");
    CHECK(describe(g.acceleration) == "(1, 1, 0) m/s^2");
    const Drag copy = drag;
    CHECK(copy.rate == drag.rate);
    CHECK(is_finite(copy.rate));
    CHECK(max(copy.rate, 5 / second) == 5 / second);
}
