// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The types that carry a unit: scalar, vector and matrix quantities. Boost.Units supplies the
/// checking, Eigen the storage; this header makes the two fit. Use these types wherever a reader of
/// a public interface or of a law of physics looks. Do not use them for bulk storage: the columns
/// of a world are lanes of raw SI numbers, and a quantity is what one body's values become while a
/// law reads them.

#include <ansatz/core/compiler_flags.hpp>

#include <Eigen/Core>

#include <boost/units/quantity.hpp>

#include <type_traits>
#include <utility>

namespace ansatz {

/// A number with a unit, e.g. `Quantity<unit::Length>`. A default-constructed one is zero.
/// \tparam Unit   an SI unit of namespace ansatz::unit (or any unit of Boost.Units)
/// \tparam Value  the scalar: float, double, a Boost.Multiprecision number without expression
///                templates; or a fixed-size Eigen matrix
template <class Unit, class Value = double> using Quantity = boost::units::quantity<Unit, Value>;

/// A plain vector without a unit; `Vector<double, 3>` is `Eigen::Vector3d`. Not zeroed by default.
template <class Scalar, int Dim> using Vector = Eigen::Matrix<Scalar, Dim, 1>;

/// A vector with a unit, e.g. `VectorQuantity<unit::Velocity, 2, float>`. %Zero by default, like a
/// scalar quantity and unlike Eigen's vectors.
template <class Unit, int Dim = 3, class Scalar = double> using VectorQuantity = Quantity<Unit, Vector<Scalar, Dim>>;

/// A square matrix with one unit for all its entries, e.g. a Jacobian in 1/s^2. %Zero by default.
template <class Unit, int Dim = 3, class Scalar = double>
using MatrixQuantity = Quantity<Unit, Eigen::Matrix<Scalar, Dim, Dim>>;

namespace detail {

/// A fixed-size Eigen matrix spelled so that its parts can be deduced.
template <class Scalar, int Rows, int Cols, int Options>
using Dense = Eigen::Matrix<Scalar, Rows, Cols, Options, Rows, Cols>;

template <class T> inline constexpr bool is_matrix = false;
template <class S, int R, int C, int O, int MR, int MC>
inline constexpr bool is_matrix<Eigen::Matrix<S, R, C, O, MR, MC>> = true;

template <class Unit> inline constexpr bool is_dimensionless_unit = false;
template <class System>
inline constexpr bool is_dimensionless_unit<boost::units::unit<boost::units::dimensionless_type, System>> = true;

/// A plain number that the compiler knows: what a literal is.
template <class T>
concept Builtin = std::is_arithmetic_v<T>;

/// What may stand as the scalar of a quantity. Says only what it is not (a matrix, a unit, a
/// quantity or something derived from one), since a class scalar promises nothing that could be
/// asked for cheaply.
template <class T>
concept ScalarValue =
    std::is_arithmetic_v<T> || (std::is_class_v<T> && !is_matrix<T> && !requires { typename T::unit_type; });

/// Always false, but only once T is known: for a static_assert in a template that must not be used.
template <class...> inline constexpr bool never = false;

/// Raises the one sentence for arithmetic between different scalars. Called from the body of an
/// operator, so that asking whether the expression exists does not raise it.
template <class A, class B> [[gnu::always_inline]] constexpr void refuse_mixed_scalars() {
    constexpr bool builtin = std::is_arithmetic_v<A> && std::is_arithmetic_v<B>;
    constexpr bool one_builtin_scalar = !builtin || std::is_same_v<A, B>; // by name: compilers print the condition
    constexpr bool one_scalar = builtin || std::is_same_v<A, B>;
    static_assert(one_builtin_scalar,
                  "Ansatz units: float and double are mixed in one expression; convert one side with "
                  "scalar_cast<double>(q)");
    static_assert(one_scalar, "Ansatz units: two scalar types are mixed in one expression; convert one side with "
                              "scalar_cast<Scalar>(q)");
}

/// The coefficients of two matrices combined one by one. Eigen would do the same with its
/// expression templates, but for Vector2d and Vector4f it would issue SIMD packets of its own, and
/// a loop over bodies that holds those is not vectorised any more.
template <class Operation, class Matrix, std::size_t... I>
[[gnu::always_inline]] inline Matrix zip(const Matrix& a, const Matrix& b, std::index_sequence<I...>) {
    Matrix result;
    const auto* pa = a.data();
    const auto* pb = b.data();
    auto* pr = result.data();
    ((pr[I] = Operation::of(pa[I], pb[I])), ...);
    return result;
}

/// Every coefficient of a matrix combined with the same number; see zip().
template <class Operation, class Matrix, std::size_t... I>
[[gnu::always_inline]] inline Matrix each(const Matrix& a, const typename Matrix::Scalar& s,
                                          std::index_sequence<I...>) {
    Matrix result;
    const auto* pa = a.data();
    auto* pr = result.data();
    ((pr[I] = Operation::of(pa[I], s)), ...);
    return result;
}

struct Plus {
    template <class S> [[gnu::always_inline]] static constexpr S of(const S& a, const S& b) { return a + b; }
};
struct Minus {
    template <class S> [[gnu::always_inline]] static constexpr S of(const S& a, const S& b) { return a - b; }
};
struct Times {
    template <class S> [[gnu::always_inline]] static constexpr S of(const S& a, const S& b) { return a * b; }
};
struct Negate {
    template <class S> [[gnu::always_inline]] static constexpr S of(const S& a, const S&) { return -a; }
};
struct Over {
    template <class S> [[gnu::always_inline]] static constexpr S of(const S& a, const S& b) { return a / b; }
};

template <class M> using Indices = std::make_index_sequence<static_cast<std::size_t>(M::SizeAtCompileTime)>;

template <class Operation, class M> [[gnu::always_inline]] inline M combine(const M& a, const M& b) {
    return zip<Operation>(a, b, Indices<M>{});
}

template <class Operation, class M> [[gnu::always_inline]] inline M scaled(const M& a, const typename M::Scalar& s) {
    return each<Operation>(a, s, Indices<M>{});
}

template <class M> [[gnu::always_inline]] inline M negated(const M& a) {
    return each<Negate>(a, a.data()[0], Indices<M>{});
}

template <class M, std::size_t... I>
[[gnu::always_inline]] inline void fill(M& m, const typename M::Scalar& s, std::index_sequence<I...>) {
    ((m.data()[I] = s), ...);
}

/// What a quantity with a matrix as its value stores and how it is changed in place.
template <class Self, class Matrix> class MatrixStorage {
public:
    using value_type = Matrix;
    using Scalar = typename Matrix::Scalar;

    /// The plain matrix, in SI units.
    [[gnu::always_inline]] const Matrix& value() const { return value_; }

    /// Adds a quantity of the same unit.
    [[gnu::always_inline]] Self& operator+=(const Self& other) {
        value_ = combine<Plus>(value_, other.value());
        return self();
    }
    /// Subtracts a quantity of the same unit.
    [[gnu::always_inline]] Self& operator-=(const Self& other) {
        value_ = combine<Minus>(value_, other.value());
        return self();
    }
    /// Multiplies by a plain number, which takes this quantity's scalar.
    template <class Number>
        requires std::is_convertible_v<Number, Scalar>
    [[gnu::always_inline]] Self& operator*=(const Number& factor) {
        value_ = scaled<Times>(value_, static_cast<Scalar>(factor));
        return self();
    }
    /// Divides by a plain number, which takes this quantity's scalar.
    template <class Number>
        requires std::is_convertible_v<Number, Scalar>
    [[gnu::always_inline]] Self& operator/=(const Number& divisor) {
        value_ = scaled<Over>(value_, static_cast<Scalar>(divisor));
        return self();
    }

protected:
    [[gnu::always_inline]] MatrixStorage() { fill(value_, Scalar(0), Indices<Matrix>{}); }
    [[gnu::always_inline]] explicit MatrixStorage(const Matrix& value) { assign(value, Indices<Matrix>{}); }
    // Coefficient by coefficient: g++ does not take a block copy apart, and then does not vectorise the loop around it.
    [[gnu::always_inline]] MatrixStorage(const MatrixStorage& other) { assign(other.value_, Indices<Matrix>{}); }
    [[gnu::always_inline]] MatrixStorage& operator=(const MatrixStorage& other) {
        assign(other.value_, Indices<Matrix>{});
        return *this;
    }

private:
    template <std::size_t... I> [[gnu::always_inline]] void assign(const Matrix& other, std::index_sequence<I...>) {
        ((value_.data()[I] = other.data()[I]), ...);
    }
    [[gnu::always_inline]] Self& self() { return static_cast<Self&>(*this); }
    Matrix value_;
};

} // namespace detail
} // namespace ansatz

namespace boost::units {

/// A quantity whose value is a fixed-size Eigen matrix. Boost's own class would do for storage, but
/// its operator+= cannot be replaced by a better free function (the call would be ambiguous), its
/// default value is not zero, and its errors are longer.
template <class Unit, class S, int R, int C, int O>
class quantity<Unit, Eigen::Matrix<S, R, C, O, R, C>>
    : public ansatz::detail::MatrixStorage<quantity<Unit, Eigen::Matrix<S, R, C, O, R, C>>,
                                           Eigen::Matrix<S, R, C, O, R, C>> {
    using Storage = ansatz::detail::MatrixStorage<quantity, Eigen::Matrix<S, R, C, O, R, C>>;

public:
    using this_type = quantity;
    using unit_type = Unit;
    using value_type = Eigen::Matrix<S, R, C, O, R, C>;

    /// Zero.
    // NOLINTNEXTLINE(modernize-use-equals-default): or it would be zeroed
    [[gnu::always_inline]] quantity() {}

    /// The door for raw SI numbers; for makers and for the library's own lanes.
    [[gnu::always_inline]] static quantity from_value(const value_type& value) { return quantity(value, 0); }

private:
    [[gnu::always_inline]] quantity(const value_type& value, int) : Storage(value) {}
};

/// The same without a dimension: converts from and to the plain matrix, as Boost's scalars do.
template <class System, class S, int R, int C, int O>
class quantity<BOOST_UNITS_DIMENSIONLESS_UNIT(System), Eigen::Matrix<S, R, C, O, R, C>>
    : public ansatz::detail::MatrixStorage<quantity<unit<dimensionless_type, System>, Eigen::Matrix<S, R, C, O, R, C>>,
                                           Eigen::Matrix<S, R, C, O, R, C>> {
    using Storage = ansatz::detail::MatrixStorage<quantity, Eigen::Matrix<S, R, C, O, R, C>>;

public:
    using this_type = quantity;
    using unit_type = unit<dimensionless_type, System>;
    using value_type = Eigen::Matrix<S, R, C, O, R, C>;

    /// Zero.
    // NOLINTNEXTLINE(modernize-use-equals-default): or it would be zeroed
    [[gnu::always_inline]] quantity() {}
    /// From the plain matrix.
    // NOLINTNEXTLINE(google-explicit-constructor): a number without a unit
    [[gnu::always_inline]] quantity(const value_type& value) : Storage(value) {}
    /// From the plain matrix, as every quantity.
    [[gnu::always_inline]] static quantity from_value(const value_type& value) { return quantity(value); }
    /// To the plain matrix.
    // NOLINTNEXTLINE(google-explicit-constructor)
    [[gnu::always_inline]] operator value_type() const { return this->value(); }
};

} // namespace boost::units

namespace ansatz {

/// %Zero of a quantity type: `zero<VectorQuantity<unit::Length>>()`.
template <class Q> [[gnu::always_inline]] constexpr Q zero() { return Q(); }

namespace detail {

template <class T, class Value> struct ScalarCast {
    [[gnu::always_inline]] static constexpr T of(const Value& v) { return static_cast<T>(v); }
};
template <class T, class S, int R, int C, int O> struct ScalarCast<T, Dense<S, R, C, O>> {
    using Result = Dense<T, R, C, O>;
    template <std::size_t... I>
    [[gnu::always_inline]] static Result copy(const Dense<S, R, C, O>& m, std::index_sequence<I...>) {
        Result result;
        ((result.data()[I] = static_cast<T>(m.data()[I])), ...);
        return result;
    }
    [[gnu::always_inline]] static Result of(const Dense<S, R, C, O>& m) { return copy(m, Indices<Result>{}); }
};

} // namespace detail

/// The same quantity with another scalar: `scalar_cast<float>(metres(0, 10, 0))`. Scalars, vectors
/// and matrices. A narrowing one rounds; a value out of range becomes what static_cast makes of it.
template <class T, class Unit, class Value>
[[gnu::always_inline]] constexpr auto scalar_cast(const boost::units::quantity<Unit, Value>& q) {
    auto value = detail::ScalarCast<T, Value>::of(q.value());
    return boost::units::quantity<Unit, decltype(value)>::from_value(value);
}

} // namespace ansatz
