// SPDX-License-Identifier: BSL-1.0
// The types: what a quantity stores, how it starts, what converts into it and what does not.

#include <ansatz/units/quantity.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

using namespace ansatz;
using namespace ansatz::test;

static_assert(same<Quantity<unit::Length>, boost::units::quantity<unit::Length, double>>);
static_assert(same<Vector<double, 3>, Eigen::Vector3d> && same<Vector<float, 2>, Eigen::Vector2f>);
static_assert(same<VectorQuantity<unit::Length>, Quantity<unit::Length, Eigen::Vector3d>>);
static_assert(same<MatrixQuantity<unit::Stiffness, 2, float>, Quantity<unit::Stiffness, Eigen::Matrix2f>>);

// A quantity costs what its number costs.
static_assert(sizeof(Quantity<unit::Length, float>) == sizeof(float));
static_assert(sizeof(VectorQuantity<unit::Length>) == sizeof(Eigen::Vector3d));
static_assert(alignof(VectorQuantity<unit::Length, 2>) == alignof(Eigen::Vector2d));
static_assert(sizeof(MatrixQuantity<unit::Length>) == sizeof(Eigen::Matrix3d));

// Nothing without a unit becomes a quantity, and no quantity becomes a number.
static_assert(!std::is_convertible_v<double, Quantity<unit::Length>>);
static_assert(!std::is_constructible_v<Quantity<unit::Length>, double>);
static_assert(!std::is_convertible_v<Quantity<unit::Length>, double>);
static_assert(!std::is_convertible_v<Eigen::Vector3d, VectorQuantity<unit::Length>>);
static_assert(!std::is_constructible_v<VectorQuantity<unit::Length>, Eigen::Vector3d>);
static_assert(!std::is_convertible_v<VectorQuantity<unit::Length>, Eigen::Vector3d>);
static_assert(!std::is_convertible_v<Quantity<unit::Time>, Quantity<unit::Length>>);
static_assert(!std::is_convertible_v<VectorQuantity<unit::Velocity>, VectorQuantity<unit::Length>>);
static_assert(!std::is_convertible_v<VectorQuantity<unit::Length, 2>, VectorQuantity<unit::Length, 3>>);
static_assert(!std::is_convertible_v<Quantity<unit::Length>, VectorQuantity<unit::Length>>);
// A vector of another precision is converted by scalar_cast only; a double never silently becomes a float.
static_assert(!std::is_convertible_v<VectorQuantity<unit::Length, 3, float>, VectorQuantity<unit::Length>>);
static_assert(!std::is_convertible_v<VectorQuantity<unit::Length>, VectorQuantity<unit::Length, 3, float>>);
static_assert(!std::is_convertible_v<Quantity<unit::Length>, Quantity<unit::Length, float>>);
// Without a dimension a quantity is its value.
static_assert(std::is_convertible_v<Quantity<unit::Dimensionless>, double>);
static_assert(std::is_convertible_v<double, Quantity<unit::Dimensionless>>);
static_assert(std::is_convertible_v<VectorQuantity<unit::Dimensionless>, Eigen::Vector3d>);
static_assert(std::is_convertible_v<Eigen::Vector3d, VectorQuantity<unit::Dimensionless>>);

// A policy's default arguments are constants.
static_assert((0.5 * metre).value() == 0.5);
static_assert(scalar_cast<float>(0.1 * metre).value() == 0.1f);

TEMPLATE_TEST_CASE("a quantity starts at zero", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    // Memory that was not zero before, so that luck does not pass.
    alignas(64) unsigned char memory[4096];
    for (auto& byte : memory) byte = 0xa5;
    auto* v = new (memory) VectorQuantity<unit::Length, D, S>;
    CHECK(v->value() == Vector<S, D>(Vector<S, D>::Zero()));
    auto* m = new (memory + 2048) MatrixQuantity<unit::Stiffness, D, S>;
    CHECK(m->value() == Eigen::Matrix<S, D, D>(Eigen::Matrix<S, D, D>::Zero()));
    CHECK(VectorQuantity<unit::Dimensionless, D, S>().value() == Vector<S, D>(Vector<S, D>::Zero()));
    CHECK(Quantity<unit::Length, S>().value() == S(0));
    CHECK((zero<VectorQuantity<unit::Length, D, S>>().value() == Vector<S, D>(Vector<S, D>::Zero())));
    CHECK((zero<Quantity<unit::Length, S>>().value() == S(0)));
}

TEMPLATE_TEST_CASE("from_value and value are inverse", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    for (int n = 0; n < 20; ++n) {
        const auto v = some.plain<S, D>();
        const auto q = VectorQuantity<unit::Length, D, S>::from_value(v);
        CHECK(q.value() == v);
        const auto copy = q;
        CHECK(copy == q);
        VectorQuantity<unit::Length, D, S> other;
        other = q;
        CHECK(other.value() == v);
    }
}

TEMPLATE_TEST_CASE("scalar_cast changes the scalar and nothing else", "[units]", ANSATZ_TEST_SPACES) {
    using S = typename TestType::Scalar;
    constexpr int D = TestType::dim;
    Numbers some;
    const auto v = some.vector<unit::Velocity, S, D>();
    const auto narrow = scalar_cast<float>(v);
    static_assert(same<std::remove_const_t<decltype(narrow)>, VectorQuantity<unit::Velocity, D, float>>);
    CHECK(scalar_cast<S>(narrow) == v); // these numbers are exact in a float
    const auto wide = scalar_cast<Precise>(v);
    static_assert(same<std::remove_const_t<decltype(wide)>, VectorQuantity<unit::Velocity, D, Precise>>);
    CHECK(scalar_cast<S>(wide) == v);
    const auto m = some.matrix<unit::Stiffness, S, D>();
    CHECK(scalar_cast<S>(scalar_cast<double>(m)) == m);
    const auto s = some.scalar<unit::Mass, S>();
    CHECK(scalar_cast<S>(scalar_cast<double>(s)) == s);
    // The sign of a zero and what is not finite survive.
    CHECK(std::signbit(scalar_cast<float>(-0.0 * metre).value()));
    CHECK(std::isinf(scalar_cast<float>(1e300 * metre).value()));
}
