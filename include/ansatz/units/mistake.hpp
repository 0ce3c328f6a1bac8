// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Operators that exist only to say what is wrong: different scalars mixed in one expression, sums
/// of different units, a bare number added to a quantity, vector times vector. Nothing here is for
/// use. A mixture of scalars counts as an existing expression when a concept asks, since its
/// sentence is in the body; all the others do not.

#include <ansatz/units/quantity.hpp>

#include <type_traits>

namespace ansatz::detail {

/// The scalar of a value: its own type, or a matrix's coefficient.
template <class Value> struct ScalarOfValue {
    using type = Value;
};
template <class S, int R, int C, int O> struct ScalarOfValue<Dense<S, R, C, O>> {
    using type = S;
};
template <class Value> using ScalarOf = typename ScalarOfValue<Value>::type;

template <class X, class Y>
concept DifferentScalars = !std::is_same_v<ScalarOf<X>, ScalarOf<Y>>;

/// Same shape for a sum: both scalars, or matrices of equal rows and columns.
template <class X, class Y> inline constexpr bool same_shape = ScalarValue<X> && ScalarValue<Y>;
template <class S1, class S2, int R, int C, int O1, int O2>
inline constexpr bool same_shape<Dense<S1, R, C, O1>, Dense<S2, R, C, O2>> = true;

/// Not both matrices: then there is a scalar to multiply with.
template <class X, class Y>
concept Scales = !(is_matrix<X> && is_matrix<Y>);

template <class X, class Y> using Bigger = std::conditional_t<is_matrix<Y>, Y, X>;

} // namespace ansatz::detail

namespace boost::units {

template <class Unit, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::same_shape<X, Y>)
constexpr quantity<Unit, X> operator+(const quantity<Unit, X>& a, const quantity<Unit, Y>&) {
    ansatz::detail::refuse_mixed_scalars<ansatz::detail::ScalarOf<X>, ansatz::detail::ScalarOf<Y>>();
    return a;
}
template <class Unit, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::same_shape<X, Y>)
constexpr quantity<Unit, X> operator-(const quantity<Unit, X>& a, const quantity<Unit, Y>&) {
    ansatz::detail::refuse_mixed_scalars<ansatz::detail::ScalarOf<X>, ansatz::detail::ScalarOf<Y>>();
    return a;
}
template <class Unit1, class Unit2, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::Scales<X, Y>)
constexpr auto operator*(const quantity<Unit1, X>&, const quantity<Unit2, Y>&)
    -> quantity<typename multiply_typeof_helper<Unit1, Unit2>::type, ansatz::detail::Bigger<X, Y>> {
    ansatz::detail::refuse_mixed_scalars<ansatz::detail::ScalarOf<X>, ansatz::detail::ScalarOf<Y>>();
    return {};
}
template <class Unit1, class Unit2, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::ScalarValue<Y>)
constexpr auto operator/(const quantity<Unit1, X>&, const quantity<Unit2, Y>&)
    -> quantity<typename divide_typeof_helper<Unit1, Unit2>::type, X> {
    ansatz::detail::refuse_mixed_scalars<ansatz::detail::ScalarOf<X>, ansatz::detail::ScalarOf<Y>>();
    return {};
}

// --- refused by name ----------------------------------------------------------------------------
// A deleted function answers "no" when a concept asks, and the compiler prints its result type where
// it would otherwise print a page of candidates (clang shows the line of the declaration). C++20 has
// no better place for the sentence.

struct Ansatz_units_this_adds_or_compares_quantities_of_different_units {};
struct Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit {};
struct Ansatz_units_this_adds_a_vector_and_a_scalar_or_vectors_of_different_dimension {};
struct Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross {};
struct Ansatz_units_this_divides_by_a_vector {};
struct Ansatz_units_float_and_double_are_mixed_convert_one_side_with_scalar_cast {};

// clang shows the line of the operator, so that the sentence must stand in it.
// clang-format off
template <class Unit1, class Unit2, class X, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator+(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;
template <class Unit1, class Unit2, class X, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator-(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;
// These two also refuse !=, <, <=, > and >=, and both orders, as C++20 rewrites them.
template <class Unit1, class Unit2, class X, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator==(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;
template <class Unit1, class Unit2, class X, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator<=>(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;

template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator+(const quantity<Unit, X>&, const Number&) = delete;
template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator+(const Number&, const quantity<Unit, X>&) = delete;
template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator-(const quantity<Unit, X>&, const Number&) = delete;
template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator-(const Number&, const quantity<Unit, X>&) = delete;
template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator==(const quantity<Unit, X>&, const Number&) = delete;
template <class Unit, class X, ansatz::detail::Builtin Number>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator<=>(const quantity<Unit, X>&, const Number&) = delete;

template <class Unit, class X, class Y>
    requires(!ansatz::detail::same_shape<X, Y>)
Ansatz_units_this_adds_a_vector_and_a_scalar_or_vectors_of_different_dimension operator+(const quantity<Unit, X>&, const quantity<Unit, Y>&) = delete;
template <class Unit, class X, class Y>
    requires(!ansatz::detail::same_shape<X, Y>)
Ansatz_units_this_adds_a_vector_and_a_scalar_or_vectors_of_different_dimension operator-(const quantity<Unit, X>&, const quantity<Unit, Y>&) = delete;

template <class Unit1, class Unit2, class S1, int R1, int O1, class S2, int R2, int O2>
    requires(R1 > 1 && R2 > 1)
Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross operator*(const quantity<Unit1, Eigen::Matrix<S1, R1, 1, O1, R1, 1>>&,
          const quantity<Unit2, Eigen::Matrix<S2, R2, 1, O2, R2, 1>>&) = delete;
template <class Unit, class S1, int R1, int O1, class S2, int R2, int O2>
    requires(R1 > 1 && R2 > 1)
Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross operator*(const quantity<Unit, Eigen::Matrix<S1, R1, 1, O1, R1, 1>>&, const Eigen::Matrix<S2, R2, 1, O2, R2, 1>&) = delete;
template <class Unit, class S1, int R1, int O1, class S2, int R2, int O2>
    requires(R1 > 1 && R2 > 1)
Ansatz_units_vector_times_vector_does_not_exist_use_dot_or_cross operator*(const Eigen::Matrix<S1, R1, 1, O1, R1, 1>&, const quantity<Unit, Eigen::Matrix<S2, R2, 1, O2, R2, 1>>&) = delete;

template <class Unit1, class Unit2, class X, class S, int R, int C, int O>
Ansatz_units_this_divides_by_a_vector operator/(const quantity<Unit1, X>&, const quantity<Unit2, Eigen::Matrix<S, R, C, O, R, C>>&) = delete;

// A plain vector is a bare number too.
template <class Unit, class X, class S, int R, int C, int O>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator+(const quantity<Unit, X>&, const Eigen::Matrix<S, R, C, O, R, C>&) = delete;
template <class Unit, class X, class S, int R, int C, int O>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator+(const Eigen::Matrix<S, R, C, O, R, C>&, const quantity<Unit, X>&) = delete;
template <class Unit, class X, class S, int R, int C, int O>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator-(const quantity<Unit, X>&, const Eigen::Matrix<S, R, C, O, R, C>&) = delete;
template <class Unit, class X, class S, int R, int C, int O>
    requires(!ansatz::detail::is_dimensionless_unit<Unit>)
Ansatz_units_this_adds_or_compares_a_bare_number_and_a_quantity_multiply_it_with_its_unit operator-(const Eigen::Matrix<S, R, C, O, R, C>&, const quantity<Unit, X>&) = delete;

template <class Unit1, class Unit2, class S, int R, int C, int O, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator+=(quantity<Unit1, Eigen::Matrix<S, R, C, O, R, C>>&, const quantity<Unit2, Y>&) = delete;
template <class Unit1, class Unit2, class S, int R, int C, int O, class Y>
    requires(!std::is_same_v<Unit1, Unit2>)
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator-=(quantity<Unit1, Eigen::Matrix<S, R, C, O, R, C>>&, const quantity<Unit2, Y>&) = delete;

// A sum in place is a member of Boost's quantity, which would round a double into a float without a
// word. A free function cannot win against it, but it can make the call ambiguous.
template <class Unit, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::same_shape<X, Y>)
Ansatz_units_float_and_double_are_mixed_convert_one_side_with_scalar_cast operator+=(quantity<Unit, X>&, const quantity<Unit, Y>&) = delete;
template <class Unit, class X, class Y>
    requires(ansatz::detail::DifferentScalars<X, Y> && ansatz::detail::same_shape<X, Y>)
Ansatz_units_float_and_double_are_mixed_convert_one_side_with_scalar_cast operator-=(quantity<Unit, X>&, const quantity<Unit, Y>&) = delete;
// clang-format on

} // namespace boost::units
