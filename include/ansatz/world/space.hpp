// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Space<Scalar, Dim>`: the number type and the dimension of a world, and the quantity types that follow from them.
///
/// A world without a Space policy lives in `Space<double, 3>`; this is the one silent default of the library. Use
/// `Space<float, 2>` for a plane game on lanes half as wide, and a Boost.Multiprecision number as the reference that
/// accuracy is measured against. Policies know no Space: their parameters are double quantities in three components,
/// and the world converts them here, once, when it is made.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>
#include <ansatz/world/roles.hpp>

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace ansatz {

/// \tparam ScalarT float, double, or a class scalar such as boost::multiprecision::cpp_bin_float (without expression
///                 templates)
/// \tparam Dim     2 or 3
template <class ScalarT = double, int Dim = 3> struct Space {
    static_assert(Dim == 2 || Dim == 3,
                  "Ansatz: a Space has 2 or 3 dimensions, e.g. Space<double, 3> or Space<float, 2>");
    static_assert(
        !std::is_integral_v<ScalarT>,
        "Ansatz: the scalar of a Space is a real number type, e.g. Space<double, 3>; integers cannot integrate");

    using role = roles::Space;
    using Scalar = ScalarT;
    static constexpr int dimension = Dim; ///< 2 or 3

    /// The type of the clock: at least double, because a float that counts seconds freezes after six days.
    using ClockScalar = std::conditional_t<std::is_same_v<Scalar, float>, double, Scalar>;

    template <class Unit> using ScalarOf = Quantity<Unit, Scalar>; ///< a number with a unit
    /// A vector with a unit.
    template <class Unit> using VectorOf = VectorQuantity<Unit, Dim, Scalar>;
    /// A matrix with a unit.
    template <class Unit> using MatrixOf = MatrixQuantity<Unit, Dim, Scalar>;

    using Length = ScalarOf<unit::Length>; ///< m
    using Time = ScalarOf<unit::Time>;     ///< s
    /// s, with the digits that a long run needs: at least double's.
    using ClockTime = ansatz::Quantity<unit::Time, ClockScalar>;
    using Mass = ScalarOf<unit::Mass>;                 ///< kg
    using InverseMass = ScalarOf<unit::InverseMass>;   ///< 1/kg
    using Speed = ScalarOf<unit::Velocity>;            ///< m/s
    using Energy = ScalarOf<unit::Energy>;             ///< J
    using Position = VectorOf<unit::Length>;           ///< m
    using Velocity = VectorOf<unit::Velocity>;         ///< m/s
    using Acceleration = VectorOf<unit::Acceleration>; ///< m/s^2
    using Force = VectorOf<unit::Force>;               ///< N
    using Momentum = VectorOf<unit::Momentum>;         ///< kg m/s

    /// A scalar parameter of a policy, in this space's number type.
    template <class Unit, detail::ScalarValue From>
    static constexpr ScalarOf<Unit> convert(const ansatz::Quantity<Unit, From>& q) {
        return convert("a parameter", q);
    }
    /// \param what the parameter's name for the sentence
    template <class Unit, detail::ScalarValue From>
    static constexpr ScalarOf<Unit> convert(std::string_view what, const ansatz::Quantity<Unit, From>& q) {
        const auto converted = ScalarOf<Unit>::from_value(static_cast<Scalar>(q.value()));
        if (is_finite(q) && !is_finite(converted)) refuse_value("World", what, q, "the world's scalar can hold it");
        return converted;
    }

    /// A three-component parameter of a policy, in this space's number type and dimension.
    /// \param what the parameter's name for the sentence, e.g. "Gravity::acceleration"
    /// \throws std::invalid_argument if a component that this space does not have is not zero
    template <class Unit, class From>
    static VectorOf<Unit> convert(std::string_view what, const VectorQuantity<Unit, 3, From>& q) {
        if constexpr (Dim == 2)
            if (!(q.value()[2] == From(0)))
                refuse_value("World", what, q, "this world has two dimensions, so its third component must be 0");
        Vector<Scalar, Dim> v;
        for (int i = 0; i < Dim; ++i) v[i] = static_cast<Scalar>(q.value()[i]);
        const auto converted = VectorOf<Unit>::from_value(v);
        if (is_finite(q) && !is_finite(converted)) refuse_value("World", what, q, "the world's scalar can hold it");
        return converted; // NOLINT(performance-no-automatic-move): its numbers are copied either way
    }
    /// A vector in the scalar of the space.
    template <class Unit, class From> static VectorOf<Unit> convert(const VectorQuantity<Unit, 3, From>& q) {
        return convert("a vector parameter", q);
    }

    /// A vector of zeros.
    template <class Unit> static VectorOf<Unit> zero_vector() {
        Vector<Scalar, Dim> v;
        for (int i = 0; i < Dim; ++i) v[i] = Scalar(0);
        return VectorOf<Unit>::from_value(v);
    }
};

namespace detail {
template <class... P> struct SpaceOf {
    using type = Space<>;
};
template <class First, class... Rest> struct SpaceOf<First, Rest...> {
    using type = typename SpaceOf<Rest...>::type;
};
template <PlaysRole<roles::Space> First, class... Rest> struct SpaceOf<First, Rest...> {
    using type = First;
};
} // namespace detail

/// The Space among the policies, or `Space<double, 3>`.
template <class... P> using space_of = typename detail::SpaceOf<P...>::type;

} // namespace ansatz
