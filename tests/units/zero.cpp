// SPDX-License-Identifier: BSL-1.0

// A zero that the compiler knows: sums with it leave every bit alone, -0 and NaN included, which v + 0.0 does not.

#include <ansatz/units/zero.hpp>

#include "tests/catch.hpp"
#include "tests/units/spaces.hpp"

#include <cmath>
#include <limits>

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a known zero leaves the other summand alone to the bit, -0 and NaN included", "[units][zero]",
                   ANSATZ_TEST_SPACES) {
    using Scalar = typename TestType::Scalar;
    using V = VectorQuantity<unit::Velocity, TestType::dim, Scalar>;
    const Zero<V> none{};
    auto plain = V().value();
    plain.fill(-Scalar(0));
    plain[1] = std::numeric_limits<Scalar>::quiet_NaN();
    const auto v = V::from_value(plain);
    auto untouched = [&](const V& q) {
        using std::isnan;
        using std::signbit;
        return signbit(q.value()[0]) && q.value()[0] == Scalar(0) && bool(isnan(q.value()[1]));
    };
    CHECK(untouched(v + none));
    CHECK(untouched(none + v));
    CHECK(untouched(v - none));
    V sum = v;
    sum += none;
    CHECK(untouched(sum));
    sum -= none;
    CHECK(untouched(sum));
    CHECK((none - V::from_value(plain)).value()[0] == Scalar(0));
    CHECK_FALSE(signbit((none - v).value()[0])); // 0 - (-0) is +0
}

TEMPLATE_TEST_CASE("products of a known zero are known zeros of the right unit", "[units][zero]", ANSATZ_TEST_SPACES) {
    using Scalar = typename TestType::Scalar;
    using A = VectorQuantity<unit::Acceleration, TestType::dim, Scalar>;
    using V = VectorQuantity<unit::Velocity, TestType::dim, Scalar>;
    const Zero<A> none{};
    const auto dt = Quantity<unit::Time, Scalar>::from_value(Scalar(0.5));
    static_assert(same<decltype(none * dt), Zero<V>>);
    static_assert(same<decltype(dt * none), Zero<V>>);
    static_assert(same<decltype(none * dt / dt), Zero<A>>);
    static_assert(same<decltype(0.5 * none), Zero<A>>);
    static_assert(same<decltype(-none + none * 2), Zero<A>>);
    static_assert(std::is_convertible_v<Zero<A>, A>);
    const A as_usual = none;
    CHECK(as_usual == A::from_value(A().value() * Scalar(0)));
    CHECK(V(none * dt).value() == (V().value() * Scalar(0)).eval());
}
