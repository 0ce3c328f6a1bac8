// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The SI units by name: types in namespace ansatz::unit, constants in the singular. Multiply or
/// divide a number by a constant to make a quantity: `0.5 * metre`, `0.05 / second`. Vectors are
/// made by the plural functions of vector.hpp. Angles are a dimension of their own here, as in
/// Boost.Units; an angular velocity is written in 1/s, or omega x r would not be a velocity.

#include <ansatz/units/quantity.hpp>

#include <boost/units/systems/si/base.hpp>

#include <type_traits>

namespace ansatz {
namespace detail {

// The dimension list in Boost's canonical order, written down instead of computed: each of Boost's
// own typedefs sorts a list at compile time. tests/units holds these against Boost's.
template <class Base, int Exponent, class Rest> struct Prepend {
    using type = boost::units::list<boost::units::dim<Base, boost::units::static_rational<Exponent>>, Rest>;
};
template <class Base, class Rest> struct Prepend<Base, 0, Rest> {
    using type = Rest;
};

template <int Length, int Mass, int Time, int Angle = 0>
using Si = boost::units::unit<
    typename Prepend<
        boost::units::length_base_dimension, Length,
        typename Prepend<boost::units::mass_base_dimension, Mass,
                         typename Prepend<boost::units::time_base_dimension, Time,
                                          typename Prepend<boost::units::plane_angle_base_dimension, Angle,
                                                           boost::units::dimensionless_type>::type>::type>::type>::type,
    boost::units::si::system>;

} // namespace detail

/// SI units as types: `Quantity<unit::Length>`. The comment is the unit's symbol.
namespace unit {

using Dimensionless = detail::Si<0, 0, 0>;           ///< (none)
using Length = detail::Si<1, 0, 0>;                  ///< m
using Area = detail::Si<2, 0, 0>;                    ///< m^2
using Volume = detail::Si<3, 0, 0>;                  ///< m^3
using InverseLength = detail::Si<-1, 0, 0>;          ///< 1/m
using InverseArea = detail::Si<-2, 0, 0>;            ///< 1/m^2
using Time = detail::Si<0, 0, 1>;                    ///< s
using TimeSquared = detail::Si<0, 0, 2>;             ///< s^2
using Frequency = detail::Si<0, 0, -1>;              ///< 1/s, also angular velocity
using FrequencySquared = detail::Si<0, 0, -2>;       ///< 1/s^2, also angular acceleration
using Mass = detail::Si<0, 1, 0>;                    ///< kg
using InverseMass = detail::Si<0, -1, 0>;            ///< 1/kg
using Velocity = detail::Si<1, 0, -1>;               ///< m/s
using Acceleration = detail::Si<1, 0, -2>;           ///< m/s^2
using Jerk = detail::Si<1, 0, -3>;                   ///< m/s^3
using Force = detail::Si<1, 1, -2>;                  ///< N
using Energy = detail::Si<2, 1, -2>;                 ///< J
using Torque = detail::Si<2, 1, -2>;                 ///< N m, the same unit as Energy
using SpecificEnergy = detail::Si<2, 0, -2>;         ///< m^2/s^2
using Power = detail::Si<2, 1, -3>;                  ///< W
using Momentum = detail::Si<1, 1, -1>;               ///< kg m/s = N s
using Impulse = detail::Si<1, 1, -1>;                ///< N s, the same unit as Momentum
using AngularMomentum = detail::Si<2, 1, -1>;        ///< kg m^2/s
using Inertia = detail::Si<2, 1, 0>;                 ///< kg m^2, of rotation
using InverseInertia = detail::Si<-2, -1, 0>;        ///< 1/(kg m^2)
using Pressure = detail::Si<-1, 1, -2>;              ///< Pa
using Density = detail::Si<-3, 1, 0>;                ///< kg/m^3
using AreaDensity = detail::Si<-2, 1, 0>;            ///< kg/m^2
using LineDensity = detail::Si<-1, 1, 0>;            ///< kg/m
using Stiffness = detail::Si<0, 1, -2>;              ///< N/m
using Compliance = detail::Si<0, -1, 2>;             ///< m/N
using Damping = detail::Si<0, 1, -1>;                ///< N s/m = kg/s
using QuadraticDrag = detail::Si<-1, 1, 0>;          ///< kg/m: force per squared speed
using VolumeFlow = detail::Si<3, 0, -1>;             ///< m^3/s
using Diffusivity = detail::Si<2, 0, -1>;            ///< m^2/s, also kinematic viscosity
using Viscosity = detail::Si<-1, 1, -1>;             ///< Pa s, dynamic
using GravitationalConstant = detail::Si<3, -1, -2>; ///< m^3/(kg s^2)
using PlaneAngle = detail::Si<0, 0, 0, 1>;           ///< rad

} // namespace unit

/// \name Unit constants, in the singular
/// A number times (or divided by) one of them is a quantity; whole numbers become double.
///@{
inline constexpr unit::Length metre{}; ///< the unit of this name; its type says the dimension
inline constexpr unit::Area square_metre{};
inline constexpr unit::Volume cubic_metre{};
inline constexpr unit::Time second{};
inline constexpr unit::Frequency hertz{};
inline constexpr unit::Mass kilogram{};
inline constexpr unit::Velocity metre_per_second{};
inline constexpr unit::Acceleration metre_per_second_squared{};
inline constexpr unit::Force newton{};
inline constexpr unit::Energy joule{};
inline constexpr unit::Power watt{};
inline constexpr unit::Pressure pascal{};
inline constexpr unit::Momentum newton_second{};
inline constexpr unit::Momentum kilogram_metre_per_second{};
inline constexpr unit::Torque newton_metre{};
inline constexpr unit::Stiffness newton_per_metre{};
inline constexpr unit::Damping newton_second_per_metre{};
inline constexpr unit::Damping kilogram_per_second{};
inline constexpr unit::Density kilogram_per_cubic_metre{};
inline constexpr unit::Inertia kilogram_square_metre{};
inline constexpr unit::QuadraticDrag kilogram_per_metre{};
inline constexpr unit::Viscosity pascal_second{};
inline constexpr unit::PlaneAngle radian{};
///@}

namespace detail {

/// Marks a class derived from a quantity, for the operators that must see the quantity in it.
struct ParameterTag {};

template <class T>
concept AnyParameter = std::is_class_v<T> && std::is_base_of_v<ParameterTag, T>;

/// A whole number times `second`: `1 / 60 * second` is 0 s, because the division comes first. By this type a door that
/// takes a time knows it and refuses it in a sentence; in sums and products it is a quantity like any other.
struct WholeSeconds
    : Quantity<unit::Time>
    , ParameterTag {
    static constexpr WholeSeconds from_value(double seconds) {
        return WholeSeconds(Quantity<unit::Time>::from_value(seconds));
    }

private:
    constexpr explicit WholeSeconds(const Quantity<unit::Time>& q) : Quantity<unit::Time>(q) {}
};
template <class Unit> struct WholeNumberOf {
    using type = Quantity<Unit>;
};
template <> struct WholeNumberOf<unit::Time> {
    using type = WholeSeconds;
};

/// Whether a time was given in whole numbers: as `1 / 60 * second`, or as a quantity of integers.
template <class Q> inline constexpr bool in_whole_numbers = std::is_same_v<Q, WholeSeconds>;
template <class Unit, class Y>
inline constexpr bool in_whole_numbers<boost::units::quantity<Unit, Y>> = std::is_integral_v<Y>;

/// The sentence about it, in a place of its own: the same at every door.
template <class Q> constexpr void refuse_whole_numbers() {
    constexpr bool has_a_fraction = !in_whole_numbers<Q>;
    static_assert(has_a_fraction,
                  "Ansatz: a time as a whole number; 1 / 60 is 0 in whole numbers. Write a number with a point, e.g. "
                  "1.0 / 60 * second");
}

} // namespace detail
} // namespace ansatz

namespace boost::units {

// Boost takes anything that is not its quantity for a plain number, a class derived from it too:
// `parameter * metre` would be a quantity of parameters. Without a result type these drop out, and
// the operators for quantities take over.
template <class System, class Dim, class X>
    requires ansatz::detail::AnyParameter<X>
struct multiply_typeof_helper<X, unit<Dim, System>> {};
template <class System, class Dim, class X>
    requires ansatz::detail::AnyParameter<X>
struct multiply_typeof_helper<unit<Dim, System>, X> {};
template <class System, class Dim, class X>
    requires ansatz::detail::AnyParameter<X>
struct divide_typeof_helper<X, unit<Dim, System>> {};
template <class System, class Dim, class X>
    requires ansatz::detail::AnyParameter<X>
struct divide_typeof_helper<unit<Dim, System>, X> {};

// A whole number times a unit is a quantity of double: with Boost's own rule `1 * metre / 2` would
// be a truncating division. The parameter lists repeat Boost's order (System, Dim), because a
// specialisation that differs only by its constraint must otherwise be equal to the original.
template <class System, class Dim, class X>
    requires std::is_integral_v<X>
struct multiply_typeof_helper<X, unit<Dim, System>> {
    using type = typename ansatz::detail::WholeNumberOf<unit<Dim, System>>::type;
};
template <class System, class Dim, class X>
    requires std::is_integral_v<X>
struct multiply_typeof_helper<unit<Dim, System>, X> {
    using type = typename ansatz::detail::WholeNumberOf<unit<Dim, System>>::type;
};
template <class System, class Dim, class X>
    requires std::is_integral_v<X>
struct divide_typeof_helper<X, unit<Dim, System>> {
    using type = quantity<typename power_typeof_helper<unit<Dim, System>, static_rational<-1>>::type, double>;
};
// `metre / 2`: Boost's operator would compute 1/2 in whole numbers, so it is taken out and replaced.
template <class System, class Dim, class X>
    requires std::is_integral_v<X>
struct divide_typeof_helper<unit<Dim, System>, X> {};

/// Half a metre: `metre / 2`.
template <class System, class Dim, class X>
    requires std::is_integral_v<X>
constexpr quantity<unit<Dim, System>, double> operator/(const unit<Dim, System>&, X divisor) {
    return quantity<unit<Dim, System>, double>::from_value(1.0 / static_cast<double>(divisor));
}

} // namespace boost::units
