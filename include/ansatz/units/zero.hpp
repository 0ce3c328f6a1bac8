// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Zero<Q>`: a vector quantity that is zero and known to be so when compiling, e.g. the acceleration of a body on
/// which nothing acts. A compiler may not leave out `v + 0.0` by itself, because it turns -0 into 0; with this type `v
/// += a * dt` is no instruction and the lane of v is not stored. It is a Q in every other respect, so that a formula
/// need not know of it. Do not use it for a value that merely happens to be zero: that is zero<Q>().

#include <ansatz/units/arithmetic.hpp>

#include <type_traits>

namespace ansatz {

/// \tparam Q a vector quantity
template <class Q> struct Zero : Q {
    using Unit = typename Q::unit_type;
    using Value = typename Q::value_type; ///< what a vector quantity holds: an Eigen vector
    using Scalar = typename Q::Scalar;

    /// \name Sums with it are the other summand, unchanged to the bit
    /// @{

    /// The other summand, or zero where both are.
    [[gnu::always_inline]] friend Q operator+(const Q& a, const Zero&) { return a; }
    [[gnu::always_inline]] friend Q operator+(const Zero&, const Q& b) { return b; }
    [[gnu::always_inline]] friend Zero operator+(const Zero&, const Zero&) { return {}; }
    [[gnu::always_inline]] friend Q operator-(const Q& a, const Zero&) { return a; }
    [[gnu::always_inline]] friend Q operator-(const Zero&, const Q& b) { return -b; }
    [[gnu::always_inline]] friend Zero operator-(const Zero&, const Zero&) { return {}; }
    [[gnu::always_inline]] friend Q& operator+=(Q& a, const Zero&) { return a; }
    [[gnu::always_inline]] friend Q& operator-=(Q& a, const Zero&) { return a; }
    /// @}

    /// \name Products and quotients of it are of its kind
    /// @{

    /// Zero, in the unit of the result.
    [[gnu::always_inline]] friend Zero operator+(const Zero&) { return {}; }
    [[gnu::always_inline]] friend Zero operator-(const Zero&) { return {}; }
    template <class Number>
        requires(detail::Builtin<Number> || std::is_same_v<Number, Scalar>)
    [[gnu::always_inline]] friend Zero operator*(const Zero&, const Number&) {
        return {};
    }
    template <class Number>
        requires(detail::Builtin<Number> || std::is_same_v<Number, Scalar>)
    [[gnu::always_inline]] friend Zero operator*(const Number&, const Zero&) {
        return {};
    }
    template <class Number>
        requires(detail::Builtin<Number> || std::is_same_v<Number, Scalar>)
    [[gnu::always_inline]] friend Zero operator/(const Zero&, const Number&) {
        return {};
    }
    template <class Other>
    [[gnu::always_inline]] friend auto operator*(const Zero&, const boost::units::quantity<Other, Scalar>&) {
        return Zero<boost::units::quantity<detail::UnitProduct<Unit, Other>, Value>>();
    }
    template <class Other>
    [[gnu::always_inline]] friend auto operator*(const boost::units::quantity<Other, Scalar>&, const Zero&) {
        return Zero<boost::units::quantity<detail::UnitProduct<Other, Unit>, Value>>();
    }
    template <class Other>
    [[gnu::always_inline]] friend auto operator/(const Zero&, const boost::units::quantity<Other, Scalar>&) {
        return Zero<boost::units::quantity<detail::UnitQuotient<Unit, Other>, Value>>();
    }
    /// @}
};

} // namespace ansatz
