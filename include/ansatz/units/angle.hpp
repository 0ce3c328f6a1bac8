// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Plane angles: a dimension of their own, stored in radians. Degrees exist only where they are
/// spelled, in degrees() and in_degrees(). Angular velocities are frequencies (1/s), see unit.hpp.

#include <ansatz/units/arithmetic.hpp>

#include <cmath>

namespace ansatz {

// Inside this namespace the overloads below would hide the ones for plain numbers.
using std::acos;
using std::asin;
using std::atan2;
using std::cos;
using std::sin;
using std::tan;

namespace detail {
/// Radians in a degree, with digits for every scalar that is likely to be used.
template <class S> [[gnu::always_inline]] constexpr S radians_per_degree() {
    if constexpr (std::is_arithmetic_v<S>) return static_cast<S>(0.0174532925199432957692369076848861271L);
    else return S("0.017453292519943295769236907684886127134428718885417254560971914401710091146034494436822415696345");
}
} // namespace detail

/// An angle given in degrees. Whole numbers become double.
template <detail::ScalarValue S> [[gnu::always_inline]] constexpr auto degrees(const S& value) {
    using Scalar = std::conditional_t<std::is_integral_v<S>, double, S>;
    return Quantity<unit::PlaneAngle, Scalar>::from_value(static_cast<Scalar>(value) *
                                                          detail::radians_per_degree<Scalar>());
}
/// An angle given in radians; the same as `value * radian`.
template <detail::ScalarValue S> [[gnu::always_inline]] constexpr auto radians(const S& value) {
    using Scalar = std::conditional_t<std::is_integral_v<S>, double, S>;
    return Quantity<unit::PlaneAngle, Scalar>::from_value(static_cast<Scalar>(value));
}
/// The plain number of degrees in an angle.
template <class S>
[[gnu::always_inline]] constexpr S in_degrees(const boost::units::quantity<unit::PlaneAngle, S>& angle) {
    return angle.value() / detail::radians_per_degree<S>();
}

/// Sine of an angle, a plain number.
template <class S> [[gnu::always_inline]] inline S sin(const boost::units::quantity<unit::PlaneAngle, S>& angle) {
    return sin(angle.value());
}
/// Cosine of an angle, a plain number.
template <class S> [[gnu::always_inline]] inline S cos(const boost::units::quantity<unit::PlaneAngle, S>& angle) {
    return cos(angle.value());
}
/// Tangent of an angle, a plain number.
template <class S> [[gnu::always_inline]] inline S tan(const boost::units::quantity<unit::PlaneAngle, S>& angle) {
    return tan(angle.value());
}

/// The angle of the direction (x, y), from -pi to pi, of two quantities of one unit. (0, 0) gives
/// what std::atan2 gives: zero or pi by the signs of the zeros.
template <class Unit, class S>
    requires detail::ScalarValue<S>
[[gnu::always_inline]] inline Quantity<unit::PlaneAngle, S> atan2(const boost::units::quantity<Unit, S>& y,
                                                                  const boost::units::quantity<Unit, S>& x) {
    return Quantity<unit::PlaneAngle, S>::from_value(atan2(y.value(), x.value()));
}

} // namespace ansatz
