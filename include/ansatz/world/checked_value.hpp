// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Values from outside, checked and in the scalar of a world: what every door of `World` asks first.

#include <ansatz/world/check.hpp>
#include <ansatz/world/column_range.hpp>
#include <ansatz/world/properties.hpp>
#include <ansatz/world/row.hpp>

namespace ansatz {

namespace detail {

// Each of the following holds its sentences itself, and goes on only with a value that fits: g++ reads into a function
// that is called last of all, and whatever follows from the mistake would be read before the sentence.

template <class Unit, class Q>
inline constexpr bool fits_vector = has_unit<Unit, stripped<Q>> && vector_valued<stripped<Q>>;
template <class Unit, class Q>
inline constexpr bool fits_scalar = has_unit<Unit, stripped<Q>> && !vector_valued<stripped<Q>>;
template <class Q>
constexpr int dimension_of = [] {
    if constexpr (vector_valued<stripped<Q>>) return int(stripped<Q>::value_type::RowsAtCompileTime);
    return 1;
}();

/// A vector from outside, in the world's scalar.
template <class S, class Unit, class Q>
typename S::template VectorOf<Unit> finite_vector([[maybe_unused]] std::string_view where,
                                                  [[maybe_unused]] std::string_view what, const Q& q) {
    constexpr bool fits = fits_vector<Unit, Q>;
    static_assert(
        fits, "Ansatz: a vector quantity of another kind belongs here; e.g. a position is metres(0, 10, 0), a velocity "
              "metres_per_second(1, 0, 0), an impulse newton_seconds(0, 5, 0), a force newtons(0, 5, 0)");
    constexpr bool same_dimension = !fits || dimension_of<Q> == S::dimension;
    static_assert(same_dimension,
                  "Ansatz: a vector has another dimension than its world; a world of Space<Scalar, 2> takes "
                  "metres(x, y), one of three dimensions metres(x, y, z)");
    typename S::template VectorOf<Unit> result;
    if constexpr (fits && same_dimension) {
        result = scalar_cast<typename S::Scalar>(q);
        if (!is_finite(result))
            refuse_value(where, what, q, "every component is a finite number that the world's scalar can hold");
    }
    return result;
}

/// A scalar from outside, in the world's scalar.
template <class S, class Unit, class Q>
typename S::template ScalarOf<Unit> finite_scalar([[maybe_unused]] std::string_view where,
                                                  [[maybe_unused]] std::string_view what, const Q& q) {
    constexpr bool fits = fits_scalar<Unit, Q>;
    static_assert(fits, "Ansatz: a scalar quantity of another unit belongs here; multiply the number with its unit, "
                        "e.g. 1.0 / 60 * second");
    typename S::template ScalarOf<Unit> result{};
    if constexpr (fits) {
        result = scalar_cast<typename S::Scalar>(q);
        if (!is_finite(result)) refuse_value(where, what, q, "it is a finite number that the world's scalar can hold");
    }
    return result;
}

/// The same for a column of a shape of your own.
template <class S, class C, class Q>
value_of<C, S> own_value([[maybe_unused]] std::string_view where, [[maybe_unused]] const Q& q) {
    using V = value_of<C, S>;
    // Quantities of another scalar are brought to that of the world, as everywhere.
    constexpr auto cast = [](const auto& given) {
        if constexpr (has_own_lanes<C, S>) return given;
        else return scalar_cast<typename S::Scalar>(given);
    };
    constexpr bool fits = [] {
        if constexpr (has_own_lanes<C, S>) return std::constructible_from<V, const Q&>;
        else if constexpr (requires(const stripped<Q>& given) { scalar_cast<typename S::Scalar>(given); })
            return std::constructible_from<V, decltype(cast(std::declval<const stripped<Q>&>()))>;
        else return false;
    }();
    static_assert(fits, "Ansatz: a value of another type belongs into this column, whose shape is one of your own: the "
                        "Value<S, Unit> of its shape, or what that is made from");
    if constexpr (fits) {
        const V value(cast(q));
        typename S::Scalar raw[room_for<C, S>] = {};
        store<C, S>(value, raw);
        for (std::size_t k = 0; k < lanes_of<C>(S::dimension); ++k)
            if (!is_finite(raw[k]))
                refuse_value(where, joined({C::name, ", its number ", std::to_string(k)}), raw[k],
                             "it is a finite number that the world's scalar can hold");
        if constexpr (requires { value.check(); }) value.check();
        return value;
    } else return V();
}

/// A value from outside for a column, in the world's scalar and within the column's bounds.
template <class S, class C, class Q> value_of<C, S> value_for(std::string_view where, const Q& q) {
    if constexpr (own_shape<C>) return own_value<S, C>(where, q);
    else if constexpr (C::shape == Shape::vector) return finite_vector<S, typename C::Unit>(where, C::name, q);
    else {
        const auto value = finite_scalar<S, typename C::Unit>(where, C::name, q);
        if (!in_range<C>(value.value())) refuse_value(where, C::name, q, joined({"it is ", range_of<C>()}));
        return value;
    }
}

/// 1/m of a mass from outside.
template <class S, class Q>
typename S::InverseMass inverse_of_mass([[maybe_unused]] std::string_view where, const Q& m) {
    constexpr bool fits = fits_scalar<unit::Mass, Q>;
    static_assert(fits, "Ansatz: a mass belongs here; multiply the number with its unit, e.g. 2.0 * kilogram");
    typename S::InverseMass inverse{};
    if constexpr (fits) {
        using Scalar = typename S::Scalar;
        const auto given = scalar_cast<Scalar>(m);
        inverse = Scalar(1) / given;
        if (!is_finite(m) || !(m.value() > 0))
            refuse_value(where, "mass", m,
                         "a mass is finite and greater than 0 kg (a body that nothing moves is added as `fixed`, "
                         "without a mass)");
        if (!(given.value() > Scalar(0)) || !is_finite(given) || !is_finite(inverse) || !(inverse.value() > Scalar(0)))
            refuse_value(where, "mass", m,
                         "a mass is finite and greater than 0 kg in the world's scalar, and its inverse is a number (a "
                         "body that nothing moves is added as `fixed`, without a mass)");
    }
    return inverse;
}

} // namespace detail

} // namespace ansatz
