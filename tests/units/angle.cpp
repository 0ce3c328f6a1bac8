// SPDX-License-Identifier: BSL-1.0
// Angles: degrees only where they are spelled, radians everywhere else.

#include <ansatz/units/angle.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <cmath>

using namespace ansatz;
using namespace ansatz::test;

using Angle = Quantity<unit::PlaneAngle>;
static_assert(same<decltype(degrees(30)), Angle> && same<decltype(degrees(30.0)), Angle>);
static_assert(same<decltype(degrees(30.f)), Quantity<unit::PlaneAngle, float>>);
static_assert(same<decltype(degrees(Precise(30))), Quantity<unit::PlaneAngle, Precise>>);
static_assert(same<decltype(radians(1)), Angle> && same<decltype(1 * radian), Angle>);
static_assert(same<decltype(in_degrees(Angle())), double>);
static_assert(same<decltype(sin(Angle())), double>);
static_assert(same<decltype(atan2(1.0 * metre, 1.0 * metre)), Angle>);
// Nothing becomes an angle by itself, and an angle is no number.
static_assert(!std::is_convertible_v<double, Angle> && !std::is_convertible_v<Angle, double>);
static_assert(!std::is_convertible_v<Quantity<unit::Dimensionless>, Angle>);
template <class A, class B>
concept HasAtan2 = requires(A a, B b) { atan2(a, b); };
static_assert(HasAtan2<Quantity<unit::Length>, Quantity<unit::Length>>);
static_assert(!HasAtan2<Quantity<unit::Length>, Quantity<unit::Time>>);
template <class Q>
concept HasSine = requires(Q q) { ansatz::sin(q); };
static_assert(HasSine<Angle> && !HasSine<Quantity<unit::Length>> && !HasSine<Quantity<unit::Frequency>>);
static_assert(degrees(180).value() > 3.14159 && degrees(180).value() < 3.1416);

TEMPLATE_TEST_CASE("degrees and radians", "[units]", float, double, Precise) {
    using S = TestType;
    using std::abs;
    using std::acos;
    const S epsilon = std::numeric_limits<S>::epsilon();
    const S pi = acos(S(-1));
    CHECK(abs(S(degrees(S(180)).value() - pi)) <= 4 * epsilon);
    CHECK(abs(S(degrees(S(-90)).value() + pi / 2)) <= 4 * epsilon);
    for (int d = -720; d <= 720; d += 7) CHECK(abs(S(in_degrees(degrees(S(d))) - S(d))) <= 2 * epsilon * S(720));
    CHECK(radians(S(2)).value() == S(2));
}

TEMPLATE_TEST_CASE("trigonometry", "[units]", float, double, Precise) {
    using S = TestType;
    using std::abs;
    const S epsilon = std::numeric_limits<S>::epsilon();
    CHECK(abs(S(sin(degrees(S(30))) - S(0.5))) <= 2 * epsilon);
    CHECK(abs(S(cos(degrees(S(60))) - S(0.5))) <= 2 * epsilon);
    CHECK(abs(S(tan(degrees(S(45))) - S(1))) <= 2 * epsilon);
    for (int d = -175; d <= 175; d += 10) {
        const auto a = degrees(S(d));
        CHECK(abs(S(sin(a) * sin(a) + cos(a) * cos(a) - S(1))) <= 4 * epsilon);
        // atan2 is the inverse in all four quadrants, whatever the length and the unit.
        const auto r = Quantity<unit::Velocity, S>::from_value(S(3));
        CHECK(abs(S((atan2(r * sin(a), r * cos(a)) - a).value())) <= 8 * epsilon);
    }
}
