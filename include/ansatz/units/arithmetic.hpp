// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Arithmetic of quantities, written as in the notes: `x + v * dt`, `2.0 * k * d`, `-g`. Every
/// operator returns a plain object, so `auto` is safe; vectors are computed coefficient by
/// coefficient and inline completely, so that a loop over bodies vectorises. A plain number takes
/// the scalar of the quantity that it multiplies. A vector times a vector does not exist: use dot()
/// or cross(). The operators live in boost::units so that they are found by argument.

#include <ansatz/units/mistake.hpp>
#include <ansatz/units/quantity.hpp>
#include <ansatz/units/unit.hpp>

#include <compare>
#include <type_traits>

// A number of Boost.Multiprecision takes whatever converts to it for an operand, a dimensionless
// quantity of itself too, and then cannot compute with it. Told that quantities are no such thing,
// it leaves them to the operators below. (Declared here as Boost does, not included: most programs
// never see a multiprecision number.)
namespace boost::multiprecision {
template <class T, class Number> struct is_compatible_arithmetic_type;
template <class Unit, class Value, class Number>
struct is_compatible_arithmetic_type<boost::units::quantity<Unit, Value>, Number> : std::false_type {};
} // namespace boost::multiprecision

namespace ansatz::detail {

template <class Derived> std::true_type is_expression_of(const Eigen::MatrixBase<Derived>*);
std::false_type is_expression_of(const void*);

/// Any dense Eigen object: a matrix or an unevaluated expression.
template <class T>
concept Expression = decltype(is_expression_of(static_cast<const T*>(nullptr)))::value;

template <Expression E> using Plain = typename E::PlainObject;

/// A number that takes the scalar Y: any built-in one, or a Y.
template <class Y, class Number>
concept NumberFor = ScalarValue<Y> && (Builtin<Number> || std::is_same_v<Number, Y>);

template <class A, class B> using UnitProduct = typename boost::units::multiply_typeof_helper<A, B>::type;
template <class A, class B> using UnitQuotient = typename boost::units::divide_typeof_helper<A, B>::type;

/// Matrix product, written out: Eigen's would issue packets of its own (see zip()).
template <class S, int R, int K, int C, int O1, int O2>
[[gnu::always_inline]] inline auto product(const Dense<S, R, K, O1>& a, const Dense<S, K, C, O2>& b) {
    Eigen::Matrix<S, R, C> result;
    for (int i = 0; i < R; ++i)
        for (int j = 0; j < C; ++j) {
            S sum = a.coeff(i, 0) * b.coeff(0, j);
            for (int k = 1; k < K; ++k) sum += a.coeff(i, k) * b.coeff(k, j);
            result.coeffRef(i, j) = sum;
        }
    return result;
}

/// What rounding dropped from the sum `a + b`, exactly (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
template <class V> [[gnu::always_inline]] inline V dropped_from_sum(const V& a, const V& b, const V& sum) {
    const V of_b = sum - a;
    const V of_a = sum - of_b;
    return V(a - of_a) + V(b - of_b);
}

} // namespace ansatz::detail

namespace boost::units {

// --- what Boost's own operators see -------------------------------------------------------------
// Boost names the result of every candidate operator through these helpers, also of those that lose.
// Without the first group the result would be an Eigen expression that refers to dead temporaries;
// without the empty ones, asking whether vector * vector exists would be an error inside Eigen.

template <class S, int R, int C, int O> struct unary_plus_typeof_helper<Eigen::Matrix<S, R, C, O, R, C>> {
    using type = Eigen::Matrix<S, R, C, O, R, C>;
};
template <class S, int R, int C, int O> struct unary_minus_typeof_helper<Eigen::Matrix<S, R, C, O, R, C>> {
    using type = Eigen::Matrix<S, R, C, O, R, C>;
};

template <class Dim, class System, class X, class Y>
    requires(ansatz::detail::is_matrix<X> || ansatz::detail::is_matrix<Y>)
struct add_typeof_helper<quantity<unit<Dim, System>, X>, quantity<unit<Dim, System>, Y>> {};
template <class Dim, class System, class X>
    requires ansatz::detail::is_matrix<X>
struct add_typeof_helper<quantity<unit<Dim, System>, X>, quantity<unit<Dim, System>, X>> {
    using type = quantity<unit<Dim, System>, X>;
};
template <class Dim, class System, class X, class Y>
    requires(ansatz::detail::is_matrix<X> || ansatz::detail::is_matrix<Y>)
struct subtract_typeof_helper<quantity<unit<Dim, System>, X>, quantity<unit<Dim, System>, Y>> {};
template <class Dim, class System, class X>
    requires ansatz::detail::is_matrix<X>
struct subtract_typeof_helper<quantity<unit<Dim, System>, X>, quantity<unit<Dim, System>, X>> {
    using type = quantity<unit<Dim, System>, X>;
};

template <class Unit1, class Unit2, class X, class Y>
    requires(ansatz::detail::is_matrix<X> || ansatz::detail::is_matrix<Y>)
struct multiply_typeof_helper<quantity<Unit1, X>, quantity<Unit2, Y>> {};
template <class Unit1, class Unit2, class S, int R, int C, int O>
struct multiply_typeof_helper<quantity<Unit1, Eigen::Matrix<S, R, C, O, R, C>>, quantity<Unit2, S>> {
    using type = quantity<typename multiply_typeof_helper<Unit1, Unit2>::type, Eigen::Matrix<S, R, C, O, R, C>>;
};
template <class Unit1, class Unit2, class S, int R, int C, int O>
struct multiply_typeof_helper<quantity<Unit1, S>, quantity<Unit2, Eigen::Matrix<S, R, C, O, R, C>>> {
    using type = quantity<typename multiply_typeof_helper<Unit1, Unit2>::type, Eigen::Matrix<S, R, C, O, R, C>>;
};
template <class Unit, class X, class Y>
    requires ansatz::detail::is_matrix<X>
struct multiply_typeof_helper<quantity<Unit, X>, Y> {};
template <class Unit, class X, class Y>
    requires ansatz::detail::is_matrix<Y>
struct multiply_typeof_helper<X, quantity<Unit, Y>> {};

template <class Unit1, class Unit2, class X, class Y>
    requires(ansatz::detail::is_matrix<X> || ansatz::detail::is_matrix<Y>)
struct divide_typeof_helper<quantity<Unit1, X>, quantity<Unit2, Y>> {};
template <class Unit1, class Unit2, class S, int R, int C, int O>
struct divide_typeof_helper<quantity<Unit1, Eigen::Matrix<S, R, C, O, R, C>>, quantity<Unit2, S>> {
    using type = quantity<typename divide_typeof_helper<Unit1, Unit2>::type, Eigen::Matrix<S, R, C, O, R, C>>;
};
template <class Unit, class X, class Y>
    requires ansatz::detail::is_matrix<X>
struct divide_typeof_helper<quantity<Unit, X>, Y> {};
template <class Unit, class X, class Y>
    requires ansatz::detail::is_matrix<Y>
struct divide_typeof_helper<X, quantity<Unit, Y>> {};
template <class Unit, class System, class Dim, class X>
    requires ansatz::detail::is_matrix<X>
struct divide_typeof_helper<unit<Dim, System>, quantity<Unit, X>> {};

// An Eigen expression times a unit is evaluated at once.
template <class System, class Dim, class X>
    requires(ansatz::detail::Expression<X> && !ansatz::detail::is_matrix<X>)
struct multiply_typeof_helper<X, unit<Dim, System>> {
    using type = quantity<unit<Dim, System>, ansatz::detail::Plain<X>>;
};
template <class System, class Dim, class X>
    requires(ansatz::detail::Expression<X> && !ansatz::detail::is_matrix<X>)
struct multiply_typeof_helper<unit<Dim, System>, X> {
    using type = quantity<unit<Dim, System>, ansatz::detail::Plain<X>>;
};
template <class System, class Dim, class X>
    requires(ansatz::detail::Expression<X> && !ansatz::detail::is_matrix<X>)
struct divide_typeof_helper<X, unit<Dim, System>> {
    using type =
        quantity<typename power_typeof_helper<unit<Dim, System>, static_rational<-1>>::type, ansatz::detail::Plain<X>>;
};
template <class System, class Dim, class X>
    requires ansatz::detail::Expression<X>
struct divide_typeof_helper<unit<Dim, System>, X> {};

// --- sum and difference of vectors --------------------------------------------------------------

/// A vector or matrix quantity itself.
template <class U, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator+(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& q) {
    return q;
}
/// The opposite vector or matrix.
template <class U, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator-(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& q) {
    return quantity<U, Eigen::Matrix<S, R, C, O, R, C>>::from_value(ansatz::detail::negated(q.value()));
}
/// Sum of two vectors or matrices of the same unit.
template <class U, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator+(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& a,
          const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& b) {
    return quantity<U, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::combine<ansatz::detail::Plus>(a.value(), b.value()));
}
/// Difference of two vectors or matrices of the same unit.
template <class U, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator-(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& a,
          const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& b) {
    return quantity<U, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::combine<ansatz::detail::Minus>(a.value(), b.value()));
}

// --- vectors and scalars ------------------------------------------------------------------------

/// A vector times a scalar quantity.
template <class U1, class U2, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<ansatz::detail::UnitProduct<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>
operator*(const quantity<U1, Eigen::Matrix<S, R, C, O, R, C>>& v, const quantity<U2, S>& s) {
    return quantity<ansatz::detail::UnitProduct<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::scaled<ansatz::detail::Times>(v.value(), s.value()));
}
/// A scalar quantity times a vector.
template <class U1, class U2, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<ansatz::detail::UnitProduct<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>
operator*(const quantity<U1, S>& s, const quantity<U2, Eigen::Matrix<S, R, C, O, R, C>>& v) {
    return quantity<ansatz::detail::UnitProduct<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::scaled<ansatz::detail::Times>(v.value(), s.value()));
}
/// A vector divided by a scalar quantity. Each coefficient is divided: no reciprocal is taken.
template <class U1, class U2, class S, int R, int C, int O>
[[gnu::always_inline]] inline quantity<ansatz::detail::UnitQuotient<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>
operator/(const quantity<U1, Eigen::Matrix<S, R, C, O, R, C>>& v, const quantity<U2, S>& s) {
    return quantity<ansatz::detail::UnitQuotient<U1, U2>, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::scaled<ansatz::detail::Over>(v.value(), s.value()));
}
/// A vector times a plain number.
template <class U, class S, int R, int C, int O, class Number>
    requires(ansatz::detail::Builtin<Number> || std::is_same_v<Number, S>)
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator*(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& v, const Number& s) {
    return quantity<U, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::scaled<ansatz::detail::Times>(v.value(), static_cast<S>(s)));
}
/// A plain number times a vector.
template <class U, class S, int R, int C, int O, class Number>
    requires(ansatz::detail::Builtin<Number> || std::is_same_v<Number, S>)
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator*(const Number& s, const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& v) {
    return v * s;
}
/// A vector divided by a plain number.
template <class U, class S, int R, int C, int O, class Number>
    requires(ansatz::detail::Builtin<Number> || std::is_same_v<Number, S>)
[[gnu::always_inline]] inline quantity<U, Eigen::Matrix<S, R, C, O, R, C>>
operator/(const quantity<U, Eigen::Matrix<S, R, C, O, R, C>>& v, const Number& s) {
    return quantity<U, Eigen::Matrix<S, R, C, O, R, C>>::from_value(
        ansatz::detail::scaled<ansatz::detail::Over>(v.value(), static_cast<S>(s)));
}

// --- plain Eigen vectors and scalar quantities --------------------------------------------------

/// A plain vector (a direction) times a scalar quantity (a speed).
template <ansatz::detail::Expression E, class U, class S>
    requires ansatz::detail::ScalarValue<S>
[[gnu::always_inline]] inline quantity<U, ansatz::detail::Plain<E>> operator*(const E& direction,
                                                                              const quantity<U, S>& s) {
    ansatz::detail::refuse_mixed_scalars<typename E::Scalar, S>();
    if constexpr (std::is_same_v<typename E::Scalar, S>) {
        const ansatz::detail::Plain<E>& v = direction; // an expression is evaluated here, a vector is not copied
        return quantity<U, ansatz::detail::Plain<E>>::from_value(
            ansatz::detail::scaled<ansatz::detail::Times>(v, s.value()));
    } else return {};
}
/// A scalar quantity times a plain vector.
template <ansatz::detail::Expression E, class U, class S>
    requires ansatz::detail::ScalarValue<S>
[[gnu::always_inline]] inline quantity<U, ansatz::detail::Plain<E>> operator*(const quantity<U, S>& s,
                                                                              const E& direction) {
    return direction * s;
}
/// A plain vector divided by a scalar quantity.
template <ansatz::detail::Expression E, class U, class S>
    requires ansatz::detail::ScalarValue<S>
[[gnu::always_inline]] inline auto operator/(const E& direction, const quantity<U, S>& s) {
    using Result = quantity<typename power_typeof_helper<U, static_rational<-1>>::type, ansatz::detail::Plain<E>>;
    ansatz::detail::refuse_mixed_scalars<typename E::Scalar, S>();
    if constexpr (std::is_same_v<typename E::Scalar, S>) {
        const ansatz::detail::Plain<E>& v = direction;
        return Result::from_value(ansatz::detail::scaled<ansatz::detail::Over>(v, s.value()));
    } else return Result();
}

// --- matrices and vectors -----------------------------------------------------------------------

/// A matrix quantity times a vector (or matrix) quantity. Shapes must fit; a column vector times a
/// column vector does not.
template <class U1, class U2, class S, int R, int K, int C, int O1, int O2>
    requires(R > 1 && K > 1)
[[gnu::always_inline]] inline auto operator*(const quantity<U1, Eigen::Matrix<S, R, K, O1, R, K>>& m,
                                             const quantity<U2, Eigen::Matrix<S, K, C, O2, K, C>>& v) {
    return quantity<ansatz::detail::UnitProduct<U1, U2>, Eigen::Matrix<S, R, C>>::from_value(
        ansatz::detail::product(m.value(), v.value()));
}
/// A plain matrix (a rotation, a projection) times a vector or matrix quantity.
template <ansatz::detail::Expression E, class U, class S, int K, int C, int O>
    requires(E::ColsAtCompileTime == K && E::RowsAtCompileTime > 1 && K > 1 && std::is_same_v<typename E::Scalar, S>)
[[gnu::always_inline]] inline auto operator*(const E& m, const quantity<U, Eigen::Matrix<S, K, C, O, K, C>>& v) {
    const ansatz::detail::Plain<E>& plain = m;
    return quantity<U, Eigen::Matrix<S, E::RowsAtCompileTime, C>>::from_value(
        ansatz::detail::product(plain, v.value()));
}
/// A matrix quantity times a plain vector or matrix.
template <ansatz::detail::Expression E, class U, class S, int R, int K, int O>
    requires(E::RowsAtCompileTime == K && R > 1 && K > 1 && std::is_same_v<typename E::Scalar, S>)
[[gnu::always_inline]] inline auto operator*(const quantity<U, Eigen::Matrix<S, R, K, O, R, K>>& m, const E& v) {
    const ansatz::detail::Plain<E>& plain = v;
    return quantity<U, Eigen::Matrix<S, R, E::ColsAtCompileTime>>::from_value(
        ansatz::detail::product(m.value(), plain));
}
/// A rotation (quaternion, angle-axis) of a vector quantity. Needs <Eigen/Geometry> where it is used.
template <class Rotation, class U, class S, int N, int O>
[[gnu::always_inline]] inline auto operator*(const Eigen::RotationBase<Rotation, N>& rotation,
                                             const quantity<U, Eigen::Matrix<S, N, 1, O, N, 1>>& v) {
    return quantity<U, Eigen::Matrix<S, N, 1, O, N, 1>>::from_value(rotation * v.value());
}

// --- scalar quantities and plain numbers of another type ----------------------------------------
// Boost has these only for a number of exactly the quantity's scalar.

/// A number times a scalar quantity: `2 * q`, `2.0 * q` for a q of float or of a class scalar.
template <class Unit, class Y, ansatz::detail::Builtin Number>
    requires(ansatz::detail::ScalarValue<Y> && !std::is_same_v<Number, Y>)
[[gnu::always_inline]] constexpr quantity<Unit, Y> operator*(const Number& s, const quantity<Unit, Y>& q) {
    return quantity<Unit, Y>::from_value(static_cast<Y>(s) * q.value());
}
/// A scalar quantity times a number.
template <class Unit, class Y, ansatz::detail::Builtin Number>
    requires(ansatz::detail::ScalarValue<Y> && !std::is_same_v<Number, Y>)
[[gnu::always_inline]] constexpr quantity<Unit, Y> operator*(const quantity<Unit, Y>& q, const Number& s) {
    return quantity<Unit, Y>::from_value(q.value() * static_cast<Y>(s));
}
/// A scalar quantity divided by a number.
template <class Unit, class Y, ansatz::detail::Builtin Number>
    requires(ansatz::detail::ScalarValue<Y> && !std::is_same_v<Number, Y>)
[[gnu::always_inline]] constexpr quantity<Unit, Y> operator/(const quantity<Unit, Y>& q, const Number& s) {
    return quantity<Unit, Y>::from_value(q.value() / static_cast<Y>(s));
}
/// A number divided by a scalar quantity.
template <class Unit, class Y, ansatz::detail::Builtin Number>
    requires(ansatz::detail::ScalarValue<Y> && !std::is_same_v<Number, Y>)
[[gnu::always_inline]] constexpr auto operator/(const Number& s, const quantity<Unit, Y>& q) {
    using Result = quantity<typename power_typeof_helper<Unit, static_rational<-1>>::type, Y>;
    return Result::from_value(static_cast<Y>(s) / q.value());
}
/// A number plus a dimensionless quantity, whose scalar it takes: `1.0 + rate * dt`.
template <class System, class Y, class Number>
    requires ansatz::detail::NumberFor<Y, Number>
[[gnu::always_inline]] constexpr auto operator+(const Number& s,
                                                const quantity<unit<dimensionless_type, System>, Y>& q) {
    return quantity<unit<dimensionless_type, System>, Y>::from_value(static_cast<Y>(s) + q.value());
}
/// A dimensionless quantity plus a number.
template <class System, class Y, class Number>
    requires ansatz::detail::NumberFor<Y, Number>
[[gnu::always_inline]] constexpr auto operator+(const quantity<unit<dimensionless_type, System>, Y>& q,
                                                const Number& s) {
    return quantity<unit<dimensionless_type, System>, Y>::from_value(q.value() + static_cast<Y>(s));
}
/// A number minus a dimensionless quantity: `1.0 - rate * dt`.
template <class System, class Y, class Number>
    requires ansatz::detail::NumberFor<Y, Number>
[[gnu::always_inline]] constexpr auto operator-(const Number& s,
                                                const quantity<unit<dimensionless_type, System>, Y>& q) {
    return quantity<unit<dimensionless_type, System>, Y>::from_value(static_cast<Y>(s) - q.value());
}
/// A dimensionless quantity minus a number.
template <class System, class Y, class Number>
    requires ansatz::detail::NumberFor<Y, Number>
[[gnu::always_inline]] constexpr auto operator-(const quantity<unit<dimensionless_type, System>, Y>& q,
                                                const Number& s) {
    return quantity<unit<dimensionless_type, System>, Y>::from_value(q.value() - static_cast<Y>(s));
}

/// A dimensionless quantity of a class scalar against a number: ==, and by rewriting !=. Those of
/// built-in scalars convert and compare as numbers.
template <class System, class Y, class Number>
    requires(std::is_class_v<Y> && ansatz::detail::NumberFor<Y, Number>)
constexpr bool operator==(const quantity<unit<dimensionless_type, System>, Y>& q, const Number& s) {
    return q.value() == static_cast<Y>(s);
}
/// The same for <, <=, >, >= in either order.
template <class System, class Y, class Number>
    requires(std::is_class_v<Y> && ansatz::detail::NumberFor<Y, Number>)
constexpr std::partial_ordering operator<=>(const quantity<unit<dimensionless_type, System>, Y>& q, const Number& s) {
    const Y number = static_cast<Y>(s);
    if (q.value() < number) return std::partial_ordering::less;
    if (number < q.value()) return std::partial_ordering::greater;
    return q.value() == number ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

} // namespace boost::units
