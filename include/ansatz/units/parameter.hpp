// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The type of a policy's parameters: a quantity that explains itself when it is given a bare
/// number. `struct Drag { Parameter<unit::Frequency> rate; };` makes `Drag{0.05 / second}` work and
/// `Drag{0.05}` one readable sentence. Use it for members of aggregates that a user fills; use
/// Quantity everywhere else.

#include <ansatz/units/arithmetic.hpp>
#include <ansatz/units/symbol.hpp>

#include <concepts>
#include <type_traits>

namespace ansatz {
namespace detail {

/// Raises the sentence for a wrong unit. The symbols are template arguments so that the compiler
/// prints them: Boost's types alone are a page each.
template <SymbolText Given, SymbolText Wanted> constexpr void refuse_unit() {
    constexpr bool units_agree = Given.size == Wanted.size + 129; // false, once the symbols are known
    static_assert(units_agree,
                  "Ansatz units: a quantity of another unit where this parameter's unit belongs; the compiler's "
                  "note names the unit given and the unit wanted");
}

/// A quantity's value in another, wider shape or scalar: float in double, two components in three.
template <class To, class From>
inline constexpr bool widens = std::conjunction_v<std::is_arithmetic<To>, std::is_arithmetic<From>>;
template <class S1, int N1, int O1, class S2, int N2, int O2>
inline constexpr bool widens<Dense<S1, N1, 1, O1>, Dense<S2, N2, 1, O2>> =
    N2 <= N1 && N2 >= 2 && (std::is_same_v<S1, S2> || widens<S1, S2>);

template <class T> inline constexpr bool vector_of_known_size = false;
template <class T>
    requires requires {
        typename T::PlainObject;
        requires T::RowsAtCompileTime > 0;
    }
inline constexpr bool vector_of_known_size<T> = true;

template <class To, class From> constexpr To widened(const From& from) {
    if constexpr (std::is_arithmetic_v<To>) return static_cast<To>(from);
    else {
        To to;
        for (int i = 0; i < To::RowsAtCompileTime; ++i)
            to.data()[i] =
                i < From::RowsAtCompileTime ? static_cast<typename To::Scalar>(from.data()[i]) : typename To::Scalar(0);
        return to;
    }
}

} // namespace detail

/// A quantity as the member of a policy. Converts from quantities of its unit, refuses bare numbers
/// and other units with a sentence, and is a Quantity in every other respect.
/// \tparam Unit   the unit that belongs here
/// \tparam Value  its scalar or vector
template <class Unit, class Value = double>
struct Parameter
    : Quantity<Unit, Value>
    , detail::ParameterTag {
    using Base = Quantity<Unit, Value>; ///< the quantity that it is

    /// Zero.
    constexpr Parameter() = default;
    // NOLINTBEGIN(google-explicit-constructor): it stands for a quantity in a list of parameters
    /// From a quantity of this unit.
    constexpr Parameter(const Base& q) : Base(q) {}
    /// From a quantity of this unit with another built-in scalar, or with two components where
    /// this has three: the third is zero.
    template <class Other>
        requires(!std::is_same_v<Other, Value>)
    constexpr Parameter(const boost::units::quantity<Unit, Other>& q) : Base(make(q)) {
        if constexpr (std::is_same_v<Unit, unit::Time>)
            detail::refuse_whole_numbers<boost::units::quantity<Unit, Other>>();
    }
    /// A time in whole numbers: a mistake, because `1 / 60 * second` is 0 s.
    template <class Q>
        requires(std::is_same_v<Q, detail::WholeSeconds> && std::is_same_v<Unit, unit::Time>)
    constexpr Parameter(const Q& q) : Base(q) {
        detail::refuse_whole_numbers<Q>();
    }
    /// A bare number: right where nothing has a dimension, a mistake elsewhere.
    template <class Number>
        requires(detail::Builtin<Number> || detail::Expression<Number>)
    constexpr Parameter(const Number& number) : Base(bare(number)) {}
    /// A quantity of another unit: a mistake.
    template <class Other, class V>
        requires(!std::is_same_v<Other, Unit>)
    constexpr Parameter(const boost::units::quantity<Other, V>&) {
        detail::refuse_unit<detail::symbol_of<typename Other::dimension_type>,
                            detail::symbol_of<typename Unit::dimension_type>>();
    }
    // NOLINTEND(google-explicit-constructor)

private:
    template <class Other> static constexpr Base make(const boost::units::quantity<Unit, Other>& q) {
        constexpr bool fits = detail::widens<Value, Other>; // by name: the compiler prints the condition
        constexpr bool wants_vector = requires { Value::RowsAtCompileTime; };
        constexpr bool gets_vector = requires { Other::RowsAtCompileTime; };
        constexpr bool one_number_for_a_vector = wants_vector && !gets_vector;
        constexpr bool a_vector_for_one_number = !wants_vector && gets_vector;
        static_assert(!one_number_for_a_vector,
                      "Ansatz units: one number where a vector belongs; give each of its components, e.g. "
                      "metres(0.5, 0.5, 0.5) instead of 0.5 * metre");
        static_assert(!a_vector_for_one_number,
                      "Ansatz units: a vector where one number belongs; give a single one with its unit, e.g. "
                      "0.5 * metre instead of metres(0.5, 0.5, 0.5)");
        static_assert(fits || one_number_for_a_vector || a_vector_for_one_number,
                      "Ansatz units: a quantity that this parameter cannot hold, because it has more components or "
                      "another scalar; scalar_cast<double>(q) makes it one of doubles");
        if constexpr (fits) return Base::from_value(detail::widened<Value>(q.value()));
        else return Base();
    }
    template <class Number> static constexpr Base bare(const Number& number) {
        constexpr bool needs_no_unit = detail::is_dimensionless_unit<Unit>;
        static_assert(
            needs_no_unit,
            "Ansatz units: a bare number where a quantity belongs; multiply it with its unit, e.g. 0.5 * metre "
            "or 0.05 / second");
        if constexpr (needs_no_unit && detail::vector_of_known_size<Value> && detail::vector_of_known_size<Number>) {
            constexpr bool fits = detail::widens<Value, typename Number::PlainObject>;
            static_assert(fits, "Ansatz units: a vector that this parameter cannot hold, because it has more "
                                "components or another scalar; v.cast<double>() makes it one of doubles");
            if constexpr (fits) return Base::from_value(detail::widened<Value>(typename Number::PlainObject(number)));
            else return Base();
        } else if constexpr (needs_no_unit && std::is_convertible_v<Number, Value>)
            return Base::from_value(static_cast<Value>(number));
        else return Base();
    }
};

/// A vector-valued parameter, e.g. `VectorParameter<unit::Acceleration>`; given two components, the
/// third is zero.
template <class Unit, int Dim = 3, class Scalar = double> using VectorParameter = Parameter<Unit, Vector<Scalar, Dim>>;

} // namespace ansatz
