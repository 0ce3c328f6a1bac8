// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Makers of vector quantities: plural names, two or three components. `metres(0, 10, 0)` reads
/// better than any constructor and cannot be mistaken for a velocity. Built-in numbers make vectors
/// of double; where a component is a class scalar (Boost.Multiprecision) the vector keeps it. For
/// vectors of float convert with scalar_cast<float>(...).

#include <ansatz/units/arithmetic.hpp>

#include <type_traits>

namespace ansatz {
namespace detail {

/// double for built-in numbers, else the one class scalar among them.
template <class... Xs> struct Components {
    using type = double;
};
template <class X, class... Xs> struct Components<X, Xs...> {
    using type = typename Components<Xs...>::type;
};
template <class X, class... Xs>
    requires(!std::is_arithmetic_v<X>)
struct Components<X, Xs...> {
    using type = X;
};

template <class Unit, class... Xs> [[gnu::always_inline]] inline auto make_vector(const Xs&... xs) {
    constexpr bool two_or_three = sizeof...(Xs) == 2 || sizeof...(Xs) == 3;
    static_assert(two_or_three, "Ansatz units: a vector has 2 or 3 components");
    constexpr bool plain_numbers = (ScalarValue<Xs> && ...);
    static_assert(plain_numbers,
                  "Ansatz units: a maker of vectors takes plain numbers, since its name says the unit; write e.g. "
                  "metres(0, 10, 0), or vector_of(x, y, z) of quantities");
    if constexpr (two_or_three && plain_numbers) {
        using Scalar = typename Components<Xs...>::type;
        return VectorQuantity<Unit, static_cast<int>(sizeof...(Xs)), Scalar>::from_value(
            Vector<Scalar, static_cast<int>(sizeof...(Xs))>(static_cast<Scalar>(xs)...));
    } else return VectorQuantity<Unit>();
}

} // namespace detail

/// A vector quantity of any unit: `vector_of(newton_per_metre, 1, 2, 3)`.
/// \param xs two or three plain numbers, in that unit
template <class Dimension, class System, class... Xs>
    requires(detail::ScalarValue<Xs> && ...)
[[gnu::always_inline]] inline auto vector_of(const boost::units::unit<Dimension, System>&, const Xs&... xs) {
    return detail::make_vector<boost::units::unit<Dimension, System>>(xs...);
}

/// A vector quantity from two components of one unit and scalar.
template <class Unit, class S>
    requires detail::ScalarValue<S>
[[gnu::always_inline]] inline VectorQuantity<Unit, 2, S>
vector_of(const boost::units::quantity<Unit, S>& x, const std::type_identity_t<boost::units::quantity<Unit, S>>& y) {
    return VectorQuantity<Unit, 2, S>::from_value(Vector<S, 2>(x.value(), y.value()));
}
/// A vector quantity from three components of one unit and scalar.
template <class Unit, class S>
    requires detail::ScalarValue<S>
[[gnu::always_inline]] inline VectorQuantity<Unit, 3, S>
vector_of(const boost::units::quantity<Unit, S>& x, const std::type_identity_t<boost::units::quantity<Unit, S>>& y,
          const std::type_identity_t<boost::units::quantity<Unit, S>>& z) {
    return VectorQuantity<Unit, 3, S>::from_value(Vector<S, 3>(x.value(), y.value(), z.value()));
}

/// \name Makers by unit
/// Each takes two or three plain numbers.
///@{

/// A vector quantity of two or three components, in the unit of its name.
template <class... Xs> auto metres(const Xs&... xs) { return detail::make_vector<unit::Length>(xs...); }
template <class... Xs> auto metres_per_second(const Xs&... xs) { return detail::make_vector<unit::Velocity>(xs...); }
template <class... Xs> auto metres_per_second_squared(const Xs&... xs) {
    return detail::make_vector<unit::Acceleration>(xs...);
}
template <class... Xs> auto newtons(const Xs&... xs) { return detail::make_vector<unit::Force>(xs...); }
template <class... Xs> auto newton_metres(const Xs&... xs) { return detail::make_vector<unit::Torque>(xs...); }
template <class... Xs> auto newton_seconds(const Xs&... xs) { return detail::make_vector<unit::Impulse>(xs...); }
template <class... Xs> auto kilogram_metres_per_second(const Xs&... xs) {
    return detail::make_vector<unit::Momentum>(xs...);
}
template <class... Xs> auto radians_per_second(const Xs&... xs) { return detail::make_vector<unit::Frequency>(xs...); }
///@}

} // namespace ansatz
