// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Restitution` and `Friction`: what bodies are made of, as columns that exist only where a response reads them.

#include <ansatz/core/error.hpp>
#include <ansatz/world/column_range.hpp>
#include <ansatz/world/columns.hpp>
#include <ansatz/world/properties.hpp>

#include <string_view>
#include <type_traits>

namespace ansatz {

/// The coefficient of restitution, the notes' coefficient of elasticity: how much of the approach is given back.
struct Restitution {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "restitution";
    /// From 0, where two stay together, to 1, where no kinetic energy is lost.
    static constexpr double least = 0;
    static constexpr double most = 1; ///< no kinetic energy is lost
    /// Which policies read it.
    template <bool Stored> struct Needs {
        static_assert(Stored, "Ansatz: none of this world's responses reads a restitution, so it stores none; leave "
                              "restitution(...) out, or add a response "
                              "that does, e.g. Impulse{} or SoftSubsteps{}");
    };
};
/// The coefficient of friction mu of Coulomb's law.
struct Friction {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "friction";
    static constexpr double least = 0; ///< none
    /// Which policies read it.
    template <bool Stored> struct Needs {
        static_assert(Stored, "Ansatz: none of this world's responses knows friction, so it stores none; ask for it, "
                              "e.g. Impulse<Friction>{} or "
                              "SoftSubsteps<Friction>{}, or leave friction(...) out");
    };
};

namespace detail {
/// A plain number from outside.
template <class C, class Number>
auto coefficient(const char* what, [[maybe_unused]] const char* symbol, const Number& given) {
    constexpr bool plain = std::is_convertible_v<Number, double>;
    static_assert(plain, "Ansatz: restitution and friction take a plain number, e.g. restitution(0.8), friction(0.3)");
    double value = 0;
    if constexpr (plain) value = static_cast<double>(given);
    if (!is_finite(value) || !in_range<C>(value)) refuse_value(what, symbol, value, "it is " + range_of<C>());
    return with<C>(Quantity<unit::Dimensionless>(value));
}
} // namespace detail

/// How much of the approach a body gives back, from 0 to 1; of two that meet the larger counts. 0 if it is not given.
/// \throws std::invalid_argument for another number
template <class Number> auto restitution(const Number& e) {
    return detail::coefficient<Restitution>("restitution", "e", e);
}
/// Coulomb's coefficient of a body, finite and not negative; of two that meet the geometric mean counts. 0 if it is not
/// given.
/// \throws std::invalid_argument for another number
template <class Number> auto friction(const Number& mu) { return detail::coefficient<Friction>("friction", "mu", mu); }

} // namespace ansatz
