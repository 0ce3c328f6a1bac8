// SPDX-License-Identifier: BSL-1.0
// The operators: result types, values against plain numbers, the laws of a vector space, and that
// nothing refers to a temporary that is gone (a sanitiser build gives that test its teeth).

#include <ansatz/units/arithmetic.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <Eigen/Geometry>

using namespace ansatz;
using namespace ansatz::test;

namespace {

template <class S, int D> constexpr bool result_types() {
    using Length = VectorQuantity<unit::Length, D, S>;
    using Velocity = VectorQuantity<unit::Velocity, D, S>;
    using Jacobian = MatrixQuantity<unit::FrequencySquared, D, S>;
    using Time = Quantity<unit::Time, S>;
    using Plain = Vector<S, D>;
    using Square = Eigen::Matrix<S, D, D>;
    const Length* x = nullptr;
    const Velocity* v = nullptr;
    const Jacobian* j = nullptr;
    const Time* t = nullptr;
    const Plain* p = nullptr;
    const Square* r = nullptr;
    const S* s = nullptr;
    static_assert(same<decltype(*x + *x), Length> && same<decltype(*x - *x), Length>);
    static_assert(same<decltype(+*x), Length> && same<decltype(-*x), Length>);
    static_assert(same<decltype(*v * *t), Length> && same<decltype(*t * *v), Length> &&
                  same<decltype(*x / *t), Velocity>);
    static_assert(same<decltype(*x + *v * *t), Length>);
    static_assert(same<decltype(2 * *x), Length> && same<decltype(*x * 2), Length> && same<decltype(*x / 2), Length>);
    static_assert(same<decltype(2.0 * *x), Length> && same<decltype(*x * 2.0), Length> &&
                  same<decltype(*x / 2.0), Length>);
    static_assert(same<decltype(2.f * *x), Length> && same<decltype(*s * *x), Length> &&
                  same<decltype(*x / *s), Length>);
    static_assert(same<decltype(*x / *x->value().data()), Length>);
    static_assert(same<decltype(2 * *t), Time> && same<decltype(*t * 2.0), Time> && same<decltype(*t / 2), Time>);
    static_assert(same<decltype(2 / *t), Quantity<unit::Frequency, S>>);
    static_assert(same<decltype(2.0 / *t), Quantity<unit::Frequency, S>>);
    static_assert(same<decltype(-*t), Time> && same<decltype(*t + *t), Time> &&
                  same<decltype(*t / *t), Quantity<unit::Dimensionless, S>>);
    static_assert(same<decltype(*p * *t), VectorQuantity<unit::Time, D, S>>);
    static_assert(same<decltype(*t * *p), VectorQuantity<unit::Time, D, S>>);
    static_assert(same<decltype(*p / *t), VectorQuantity<unit::Frequency, D, S>>);
    static_assert(same<decltype((*p + *p) * *t), VectorQuantity<unit::Time, D, S>>);
    static_assert(same<decltype(*t * (2 * *p)), VectorQuantity<unit::Time, D, S>> || !std::is_arithmetic_v<S>);
    static_assert(same<decltype(*p * metre), Length> && same<decltype(metre * *p), Length>);
    static_assert(same<decltype((*p + *p) * metre), Length> && same<decltype(metre * (-*p)), Length>);
    static_assert(same<decltype((*p - *p) / second), VectorQuantity<unit::Frequency, D, S>>);
    static_assert(same<decltype(*p / second), VectorQuantity<unit::Frequency, D, S>>);
    static_assert(same<decltype(*v * second), Length> && same<decltype(second * *v), Length> &&
                  same<decltype(*x / second), Velocity>);
    static_assert(same<decltype(*j * *x), VectorQuantity<unit::Acceleration, D, S>>);
    static_assert(same<decltype(*j * *p), VectorQuantity<unit::FrequencySquared, D, S>>);
    static_assert(same<decltype(*j + *j), Jacobian> && same<decltype(-*j), Jacobian> &&
                  same<decltype(2.0 * *j), Jacobian>);
    static_assert(same<decltype(*j * *t * *t), MatrixQuantity<unit::Dimensionless, D, S>>);
    static_assert(same<decltype(*r * *x), Length> && same<decltype(r->transpose() * *x), Length>);
    static_assert(same<decltype(*r * *t), MatrixQuantity<unit::Time, D, S>>);
    static_assert(same<decltype(*p * p->transpose() * *t), MatrixQuantity<unit::Time, D, S>>);
    static_assert(
        same<decltype(*j * *j), MatrixQuantity<decltype(unit::FrequencySquared{} * unit::FrequencySquared{}), D, S>>);
    static_assert(same<decltype(1.0 - *t / *t), Quantity<unit::Dimensionless, S>>);
    static_assert(same<decltype(*t / *t + 1), Quantity<unit::Dimensionless, S>>);
    static_assert(same<decltype((1 - *t / *t) * *x), Length>);
    return true;
}
static_assert(result_types<float, 2>() && result_types<float, 3>() && result_types<double, 2>());
static_assert(result_types<double, 3>() && result_types<Precise, 2>() && result_types<Precise, 3>());

// Generic code that asks Boost for a result type gets the one that the operator returns.
using Metres = VectorQuantity<unit::Length>;
using Seconds = Quantity<unit::Time>;
static_assert(same<boost::units::add_typeof_helper<Metres, Metres>::type, Metres>);
static_assert(same<boost::units::subtract_typeof_helper<Metres, Metres>::type, Metres>);
static_assert(same<boost::units::unary_minus_typeof_helper<Metres>::type, Metres>);
static_assert(same<boost::units::multiply_typeof_helper<VectorQuantity<unit::Velocity>, Seconds>::type, Metres>);
static_assert(same<boost::units::multiply_typeof_helper<Seconds, VectorQuantity<unit::Velocity>>::type, Metres>);
static_assert(same<boost::units::divide_typeof_helper<Metres, Seconds>::type, VectorQuantity<unit::Velocity>>);

} // namespace

TEMPLATE_TEST_CASE("operators compute what plain numbers would", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    for (int n = 0; n < 50; ++n) {
        const auto a = some.vector<unit::Length, S, D>();
        const auto b = some.vector<unit::Length, S, D>();
        const auto t = some.scalar<unit::Time, S>();
        const S s = some.not_zero<S>();
        const auto p = some.plain<S, D>();
        const auto j = some.matrix<unit::FrequencySquared, S, D>();
        for (int i = 0; i < D; ++i) {
            const S ai = a.value()[i];
            const S bi = b.value()[i];
            CHECK((a + b).value()[i] == ai + bi);
            CHECK((a - b).value()[i] == ai - bi);
            CHECK((-a).value()[i] == -ai);
            CHECK((+a).value()[i] == ai);
            CHECK((a * t).value()[i] == ai * t.value());
            CHECK((t * a).value()[i] == ai * t.value());
            CHECK((a / t).value()[i] == ai / t.value());
            CHECK((a * s).value()[i] == ai * s);
            CHECK((s * a).value()[i] == ai * s);
            CHECK((a / s).value()[i] == ai / s);
            CHECK((3 * a).value()[i] == ai * S(3));
            CHECK((a * 0.5).value()[i] == ai / S(2));
            CHECK((a / 3).value()[i] == ai / S(3));
            CHECK((p * t).value()[i] == p[i] * t.value());
            CHECK((t * p).value()[i] == p[i] * t.value());
            CHECK((p / t).value()[i] == p[i] / t.value());
            CHECK((p * second).value()[i] == p[i]);
            CHECK(((p + p) * second).value()[i] == p[i] + p[i]);
            CHECK((p / second).value()[i] == p[i]);
            CHECK((a * second).value()[i] == ai);
            S row = 0;
            S plain_row = 0;
            for (int k = 0; k < D; ++k) {
                row += j.value()(i, k) * a.value()[k];
                plain_row += j.value()(i, k) * p[k];
            }
            CHECK((j * a).value()[i] == row);
            CHECK((j.value() * a).value()[i] == row);
            CHECK((j * p).value()[i] == plain_row);
            for (int k = 0; k < D; ++k) {
                CHECK((j + j).value()(i, k) == j.value()(i, k) * S(2));
                CHECK((p * a.value().transpose() * t).value()(i, k) == p[i] * a.value()[k] * t.value());
            }
        }
        CHECK((j.value().transpose() * a).value() == Vector<S, D>(j.value().transpose() * a.value()));
        CHECK((j * j).value() == Eigen::Matrix<S, D, D>(j.value() * j.value()));
        CHECK((2 * t).value() == t.value() * S(2));
        CHECK((t * 0.5).value() == t.value() / S(2));
        CHECK((t / 4).value() == t.value() / S(4));
        CHECK((3 / t).value() == S(3) / t.value());
        CHECK(S(1 - t / t * s) == S(1) - s); // dimensionless: converts to a plain number
        CHECK(S(s * (t / t) - 1) == s - S(1));
        CHECK(S(s / (t / t)) == s);
        CHECK(S((t / t) / s) == S(1) / s);
        CHECK(S(s - t / t) == s - S(1));
        CHECK(S(t / t + s) == s + S(1));
        CHECK((t / t == 1 && 1 == t / t && !(t / t != 1.0)));
        CHECK((t / t < 2 && 0.5 < t / t && t / t <= S(1) && S(1) >= t / t && !(t / t > 1)));
        CHECK((1 + t / t).value() == S(2));
        CHECK((t / t + 1.0).value() == S(2));
    }
}

TEMPLATE_TEST_CASE("vector quantities form a vector space", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    for (int n = 0; n < 50; ++n) {
        const auto a = some.vector<unit::Velocity, S, D>();
        const auto b = some.vector<unit::Velocity, S, D>();
        const auto c = some.vector<unit::Velocity, S, D>();
        const auto s = some.scalar<unit::Mass, S>();
        const auto t = some.scalar<unit::Mass, S>();
        const auto j = some.matrix<unit::Damping, S, D>();
        // The numbers are chosen so that nothing is rounded: every law holds to the last bit.
        CHECK(a + b == b + a);
        CHECK((a + b) + c == a + (b + c));
        CHECK(a - b == -(b - a));
        CHECK(a - a == zero<VectorQuantity<unit::Velocity, D, S>>());
        CHECK(a + zero<VectorQuantity<unit::Velocity, D, S>>() == a);
        CHECK(-(-a) == a);
        CHECK(s * a == a * s);
        CHECK(s * (a + b) == s * a + s * b);
        CHECK((s + t) * a == s * a + t * a);
        CHECK(j * (a + b) == j * a + j * b);
        CHECK((j + j) * a == 2 * (j * a));
        CHECK(a + a == 2 * a);
        CHECK((a * s) / s == a);
    }
}

TEMPLATE_TEST_CASE("in place is the same as out of place", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    for (int n = 0; n < 20; ++n) {
        const auto a = some.vector<unit::Velocity, S, D>();
        const auto b = some.vector<unit::Velocity, S, D>();
        const S s = some.not_zero<S>();
        auto c = a;
        CHECK(((c += b) == a + b));
        c = a;
        CHECK(((c -= b) == a - b));
        c = a;
        CHECK(((c *= s) == a * s));
        c = a;
        CHECK(((c /= s) == a / s));
        c = a;
        CHECK(((c *= 2) == 2 * a));
        c = a;
        CHECK(((c *= 0.5) == a / 2));
        c = a;
        CHECK(((c /= 4.0) == a / 4));
        c = a;
        c += c; // the same object on both sides
        CHECK(c == 2 * a);
        c = a;
        const auto quotient = some.scalar<unit::Mass, S>() / (1 * Quantity<unit::Mass, S>::from_value(S(2)));
        c *= quotient;
        CHECK(c == a * quotient.value());
        auto j = some.matrix<unit::Damping, S, D>();
        const auto before = j;
        j += before;
        j -= before;
        j *= 2;
        j /= 2;
        CHECK(j == before);
        auto m = some.scalar<unit::Mass, S>();
        const auto was = m;
        m *= 2.0;
        CHECK(m == 2 * was);
        m /= 2.0;
        m += was;
        CHECK(m == 2 * was);
    }
}

namespace {
// In functions of their own, with results kept in `auto`: an expression template would refer to
// what these frames held.
template <class S, int D>
[[gnu::noinline]] auto advance(VectorQuantity<unit::Length, D, S> x, VectorQuantity<unit::Velocity, D, S> v,
                               VectorQuantity<unit::Acceleration, D, S> a, Quantity<unit::Time, S> dt) {
    auto next = x + v * dt + 0.5 * (a * dt) * dt;
    return next;
}
template <class S, int D> [[gnu::noinline]] auto along(Quantity<unit::Velocity, S> speed) {
    auto result = (Vector<S, D>::Ones() + Vector<S, D>::Ones()) * speed;
    return result;
}
[[gnu::noinline]] int overwrite_the_stack() {
    volatile char junk[2048];
    for (char i = 0; auto& c : junk) c = ++i;
    return junk[17];
}
} // namespace

TEMPLATE_TEST_CASE("a result kept in auto does not dangle", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    const auto x = some.vector<unit::Length, S, D>();
    const auto v = some.vector<unit::Velocity, S, D>();
    const auto a = some.vector<unit::Acceleration, S, D>();
    const auto dt = some.scalar<unit::Time, S>();
    const auto next = advance(x, v, a, dt);
    const auto twice = along<S, D>(Quantity<unit::Velocity, S>::from_value(S(3)));
    CHECK(overwrite_the_stack() != 0);
    for (int i = 0; i < D; ++i) {
        CHECK(next.value()[i] ==
              x.value()[i] + v.value()[i] * dt.value() + S(0.5) * a.value()[i] * dt.value() * dt.value());
        CHECK(twice.value()[i] == S(6));
    }
}

TEST_CASE("a number keeps the scalar of its quantity", "[units]") {
    const auto tenth = 0.1f * metre;
    CHECK((2.0 * tenth).value() == 0.2f);
    CHECK((tenth / 3.0).value() == 0.1f / 3.0f);
    const auto precise = Precise(1) / 3 * metre;
    CHECK((2.0 * precise).value() == Precise(2) / 3);
    CHECK((precise / 2).value() == Precise(1) / 6);
}

TEST_CASE("rotations turn vector quantities", "[units]") {
    const Eigen::Quaterniond quarter(Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ()));
    const auto turned = quarter * metres(1, 0, 2);
    static_assert(same<std::remove_const_t<decltype(turned)>, VectorQuantity<unit::Length>>);
    CHECK((turned.value() - Eigen::Vector3d(0, 1, 2)).cwiseAbs().maxCoeff() < 4e-16);
    const auto plane = Eigen::Rotation2Dd(EIGEN_PI / 2) * metres(1, 0);
    CHECK((plane.value() - Eigen::Vector2d(0, 1)).cwiseAbs().maxCoeff() < 4e-16);
}

TEST_CASE("a whole number of seconds is a quantity like any other in sums, products and comparisons", "[units]") {
    const auto two = 2 * second;
    static_assert(std::is_convertible_v<decltype(two), Quantity<unit::Time>>);
    static_assert(std::is_same_v<decltype(two * (3.0 * metre_per_second)), Quantity<unit::Length>>);
    static_assert(std::is_same_v<decltype(two / 60), Quantity<unit::Time>>); // 1/30 s
    static_assert(std::is_same_v<decltype(two + 0.5 * second), Quantity<unit::Time>>);
    static_assert(std::is_same_v<decltype(-two), Quantity<unit::Time>>);
    static_assert(std::is_same_v<decltype(2 * metre), Quantity<unit::Length>>);
    CHECK((1 * second / 60).value() == 1.0 / 60);
    CHECK((second * 1 / 60).value() == 1.0 / 60);
    CHECK((two * metre).value() == 2);
    CHECK((metre / two).value() == 0.5);
    CHECK((1 / two).value() == 0.5);
    CHECK((two * 3 - 1.0 * second).value() == 5);
    CHECK(two == 2.0 * second);
    CHECK(two > 1.5 * second);
    Quantity<unit::Time> sum = two;
    sum += two;
    CHECK(sum.value() == 4);
    CHECK((1 / 60 * second).value() == 0); // what every door refuses, because nobody means it
}
