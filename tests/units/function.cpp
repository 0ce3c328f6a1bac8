// SPDX-License-Identifier: BSL-1.0
// Functions of quantities: against the formula, the identities of vector algebra, and the ends of
// the range, where sums of squares vanish or overflow.

#include <ansatz/units/function.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include "tests/units/spaces.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace ansatz;
using namespace ansatz::test;

namespace {

template <class S, int D> constexpr bool result_types() {
    using Length = VectorQuantity<unit::Length, D, S>;
    using Force = VectorQuantity<unit::Force, D, S>;
    using Plain = Vector<S, D>;
    const Length* x = nullptr;
    const Force* f = nullptr;
    const Plain* p = nullptr;
    static_assert(same<decltype(dot(*x, *f)), Quantity<unit::Energy, S>>);
    static_assert(same<decltype(dot(*p, *f)), Quantity<unit::Force, S>>);
    static_assert(same<decltype(dot(*f, *p)), Quantity<unit::Force, S>>);
    static_assert(same<decltype(dot(*p, *p)), S>);
    static_assert(same<decltype(dot(-*p, *f)), Quantity<unit::Force, S>>);
    static_assert(same<decltype(squared_norm(*x)), Quantity<unit::Area, S>>);
    static_assert(same<decltype(norm(*x)), Quantity<unit::Length, S>>);
    static_assert(same<decltype(robust_norm(*x)), Quantity<unit::Length, S>>);
    static_assert(same<decltype(norm(*p)), S> && same<decltype(squared_norm(*p)), S>);
    static_assert(same<decltype(direction(*x)), Plain> && same<decltype(direction_or(*x, *p)), Plain>);
    static_assert(same<decltype(component(*x, 0)), Quantity<unit::Length, S>>);
    static_assert(same<decltype(x->value()), const Plain&>);
    static_assert(same<decltype(ansatz::x(*x)), Quantity<unit::Length, S>> &&
                  same<decltype(y(*x)), Quantity<unit::Length, S>>);
    static_assert(same<decltype(sqrt(squared_norm(*x))), Quantity<unit::Length, S>>);
    static_assert(same<decltype(abs(norm(*x))), Quantity<unit::Length, S>>);
    static_assert(same<decltype(in(*x, metre)), Plain> && same<decltype(in(norm(*x), metre)), S>);
    if constexpr (D == 2) {
        static_assert(same<decltype(cross(*x, *f)), Quantity<unit::Torque, S>>);
        static_assert(same<decltype(cross(*p, *f)), Quantity<unit::Force, S>> && same<decltype(cross(*p, *p)), S>);
    } else {
        static_assert(same<decltype(cross(*x, *f)), VectorQuantity<unit::Torque, 3, S>>);
        static_assert(same<decltype(cross(*p, *f)), Force> && same<decltype(cross(*f, *p)), Force>);
        static_assert(same<decltype(cross(*p, *p)), Plain>);
    }
    return true;
}
static_assert(result_types<float, 2>() && result_types<float, 3>() && result_types<double, 2>());
static_assert(result_types<double, 3>() && result_types<Precise, 2>() && result_types<Precise, 3>());

template <class Q>
concept HasThird = requires(Q q) { z(q); };
static_assert(HasThird<VectorQuantity<unit::Length, 3>> && !HasThird<VectorQuantity<unit::Length, 2>>);

template <class Q, class U>
concept Readable = requires(Q q, U u) { in(q, u); };
static_assert(Readable<Quantity<unit::Velocity>, unit::Velocity> && !Readable<Quantity<unit::Velocity>, unit::Length>);

template <class S> S distance(const S& a, const S& b) {
    using std::abs;
    return abs(S(a - b));
}

} // namespace

TEMPLATE_TEST_CASE("dot, cross and norm obey their identities", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    for (int n = 0; n < 50; ++n) {
        const auto a = some.vector<unit::Length, S, D>();
        const auto b = some.vector<unit::Length, S, D>();
        const auto c = some.vector<unit::Length, S, D>();
        S sum = 0;
        for (int i = 0; i < D; ++i) sum += a.value()[i] * b.value()[i];
        CHECK(dot(a, b).value() == sum);
        CHECK(dot(a.value(), b).value() == sum);
        CHECK(dot(a, b.value()).value() == sum);
        CHECK(dot(a.value(), b.value()) == sum);
        CHECK(dot(a, b) == dot(b, a));
        CHECK(dot(a, b + c) == dot(a, b) + dot(a, c));
        CHECK(squared_norm(a) == dot(a, a));
        CHECK(squared_norm(a.value()) == squared_norm(a).value());
        if constexpr (D == 3) {
            const auto n3 = cross(a, b);
            CHECK(dot(n3, a).value() == S(0)); // orthogonal, to the last bit: nothing is rounded here
            CHECK(dot(n3, b).value() == S(0));
            CHECK(n3 == -cross(b, a));
            CHECK(cross(a, a) == zero<VectorQuantity<unit::Area, 3, S>>());
            CHECK(cross(a, b + c) == cross(a, b) + cross(a, c));
            CHECK(squared_norm(n3) + dot(a, b) * dot(a, b) == squared_norm(a) * squared_norm(b)); // Lagrange
            CHECK(cross(a.value(), b).value() == n3.value());
            CHECK(cross(a, b.value()).value() == n3.value());
            CHECK(cross(a.value(), b.value()) == n3.value());
        } else {
            const auto n2 = cross(a, b);
            CHECK(n2 == -cross(b, a));
            CHECK(cross(a, a).value() == S(0));
            CHECK(n2 * n2 + dot(a, b) * dot(a, b) == squared_norm(a) * squared_norm(b));
            const auto a3 = vector_of(x(a), y(a), 0 * x(a));
            const auto b3 = vector_of(x(b), y(b), 0 * x(b));
            CHECK(z(cross(a3, b3)) == n2); // the third component of the product in the plane
        }
    }
    if constexpr (D == 3) // right-handed
        CHECK(cross(scalar_cast<S>(metres(1, 0, 0)), scalar_cast<S>(metres(0, 1, 0))) ==
              scalar_cast<S>(metres(0, 0, 1) * metre));
}

TEMPLATE_TEST_CASE("norm is a norm", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    using Length = VectorQuantity<unit::Length, D, S>;
    const S epsilon = std::numeric_limits<S>::epsilon();
    Vector<S, D> p = Vector<S, D>::Zero();
    p[0] = S(-3);
    p[D - 1] = S(4);
    CHECK(norm(Length::from_value(p)).value() == S(5));
    CHECK(norm(p) == S(5));
    CHECK(norm(Length()).value() == S(0));
    Numbers some;
    for (int n = 0; n < 50; ++n) {
        const auto a = some.vector<unit::Length, S, D>();
        const auto b = some.vector<unit::Length, S, D>();
        CHECK(norm(a) == norm(-a));
        // A power of two changes the exponent only.
        CHECK(norm(a * 1024) == norm(a) * 1024);
        CHECK(norm(a / 1024) == norm(a) / 1024);
        CHECK(norm(a + b).value() <= (norm(a) + norm(b)).value() * (S(1) + 4 * epsilon));
        CHECK(distance(S(norm(a).value() * norm(a).value()), squared_norm(a).value()) <=
              4 * epsilon * squared_norm(a).value());
        CHECK(robust_norm(a) == norm(a));
    }
}

TEMPLATE_TEST_CASE("robust_norm and direction reach over the whole range", "[units][hard]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    using Length = VectorQuantity<unit::Length, D, S>;
    using std::ldexp;
    using std::sqrt;
    const S epsilon = std::numeric_limits<S>::epsilon();
    const int lowest = std::is_same_v<S, float> ? -120 : std::is_same_v<S, double> ? -1000 : -2000;
    Numbers some;
    const Vector<S, D> nowhere = Vector<S, D>::Zero();
    for (int exponent = lowest; exponent <= -lowest; exponent += 8) {
        Vector<S, D> p = some.plain<S, D>();
        p[0] = S(1.5);
        Vector<S, D> q;
        for (int i = 0; i < D; ++i) q[i] = ldexp(p[i], exponent);
        const auto v = Length::from_value(q);
        const S length = norm(p);
        CHECK(distance(S(ldexp(robust_norm(v).value(), -exponent)), length) <= 4 * epsilon * length);
        const auto d = direction(v);
        CHECK(distance(norm(d), S(1)) <= 4 * epsilon);
        for (int i = 0; i < D; ++i) CHECK(distance(S(d[i] * length), p[i]) <= 8 * epsilon * length);
        CHECK(direction_or(v, nowhere) == d);
    }
    if constexpr (std::is_arithmetic_v<S>) {
        // The shortest vector of all: its square is zero.
        Vector<S, D> tiny = Vector<S, D>::Zero();
        tiny[1] = -std::numeric_limits<S>::denorm_min();
        Vector<S, D> down = Vector<S, D>::Zero();
        down[1] = S(-1);
        CHECK(direction(Length::from_value(tiny)) == down);
        Vector<S, D> huge = Vector<S, D>::Zero();
        huge[1] = -std::numeric_limits<S>::max();
        CHECK(direction(Length::from_value(huge)) == down);
        CHECK(robust_norm(Length::from_value(huge)).value() == std::numeric_limits<S>::max());
    }
}

TEMPLATE_TEST_CASE("what has no direction is refused, or falls back", "[units][hard]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    using Velocity = VectorQuantity<unit::Velocity, D, S>;
    Vector<S, D> up = Vector<S, D>::Zero();
    up[1] = S(1);
    CHECK(direction_or(Velocity(), up) == up);
    CHECK(refusal([] { return direction(Velocity()); }).find(D == 2 ? "(0, 0) m/s" : "(0, 0, 0) m/s") !=
          std::string::npos);
    for (const S& bad : {std::numeric_limits<S>::infinity(), S(-std::numeric_limits<S>::infinity()),
                         std::numeric_limits<S>::quiet_NaN()})
        for (int place = 0; place < D; ++place) {
            Vector<S, D> p = Vector<S, D>::Ones();
            p[place] = bad;
            const auto v = Velocity::from_value(p);
            CHECK(direction_or(v, up) == up);
            CHECK(refusal([&] { return direction(v); }).find("finite and not zero") != std::string::npos);
            CHECK(!is_finite(v));
            CHECK(!is_finite(p));
            CHECK(!is_finite(component(v, place)));
            CHECK(!(robust_norm(v).value() < S(0)));
            CHECK(!is_finite(robust_norm(v)));
        }
    CHECK(is_finite(Velocity()));
    CHECK(is_finite(Velocity::from_value(Vector<S, D>(Vector<S, D>::Constant(std::numeric_limits<S>::max())))));
    CHECK(is_finite(MatrixQuantity<unit::Stiffness, D, S>()));
    CHECK(is_finite(Quantity<unit::Mass, S>()));
    CHECK(is_finite(S(1)));
}

TEMPLATE_TEST_CASE("components", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    const auto v = some.vector<unit::Force, S, D>();
    for (int i = 0; i < D; ++i) CHECK(component(v, i).value() == v.value()[i]);
    CHECK(x(v) == component(v, 0));
    CHECK(y(v) == component(v, 1));
    if constexpr (D == 3) CHECK(z(v) == component(v, 2));
    CHECK(in(v, newton) == v.value());
    CHECK(in(x(v), newton) == v.value()[0]);
}

TEMPLATE_TEST_CASE("sqrt, abs, min, max", "[units]", float, double, Precise) {
    using S = TestType;
    const auto area = Quantity<unit::Area, S>::from_value(S(6.25));
    CHECK(sqrt(area) == Quantity<unit::Length, S>::from_value(S(2.5)));
    static_assert(same<decltype(sqrt(area)), Quantity<unit::Length, S>>);
    static_assert(same<decltype(sqrt(sqrt(area)) * sqrt(sqrt(area))), Quantity<unit::Length, S>>);
    const auto two = Quantity<unit::Time, S>::from_value(S(2));
    const auto three = Quantity<unit::Time, S>::from_value(S(3));
    CHECK(abs(-two) == two);
    CHECK(abs(two) == two);
    CHECK(min(two, three) == two);
    CHECK(min(three, two) == two);
    CHECK(max(two, three) == three);
    CHECK(max(three, two) == three);
    CHECK(min(two, two) == two);
    CHECK(max(two, two) == two);
}

TEST_CASE("plain numbers keep their functions beside the ones for quantities", "[units]") {
    using ansatz::abs;
    using ansatz::max;
    using ansatz::min;
    using ansatz::sqrt;
    CHECK(sqrt(6.25) == 2.5);
    CHECK(abs(-2.5) == 2.5);
    CHECK(min(1.0, 2.0) == 1.0);
    CHECK(max(1.0, 2.0) == 2.0);
}
