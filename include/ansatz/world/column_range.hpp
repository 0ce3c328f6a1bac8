// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the numbers of a column may be, beside finite: a column that says so is held to it by every door of a world
/// (`add`, `write`, `load`).
///
/// A column names the bounds of its numbers, in its own unit, by `static constexpr double least` and `most`, and by
/// `static constexpr bool whole = true;` that they are whole ones. `Restitution` has 0 and 1. Zero, which a body is
/// given that is told nothing, should be within them.

#include <ansatz/units.hpp>
#include <ansatz/world/columns.hpp>

#include <cmath>
#include <string>

namespace ansatz::detail {

template <class C> inline constexpr bool has_least = requires { C::least; };
template <class C> inline constexpr bool has_most = requires { C::most; };
template <class C> inline constexpr bool is_whole = requires { requires C::whole; };

/// Whether a finite number may stand in column C.
template <class C, class Scalar> bool in_range([[maybe_unused]] const Scalar& x) {
    using std::floor;
    if constexpr (has_least<C>)
        if (x < Scalar(C::least)) return false;
    if constexpr (has_most<C>)
        if (x > Scalar(C::most)) return false;
    if constexpr (is_whole<C>) return x == floor(x);
    return true;
}
/// Which may, in words.
template <class C> std::string range_of() {
    const auto bound = [](double value) { return describe(Quantity<typename C::Unit>::from_value(value)); };
    std::string words = is_whole<C> ? "a whole number" : "a number";
    if constexpr (has_least<C> && has_most<C>) words += " from " + bound(C::least) + " to " + bound(C::most);
    else if constexpr (has_least<C>) words += ", finite and at least " + bound(C::least);
    else if constexpr (has_most<C>) words += ", finite and at most " + bound(C::most);
    return words;
}

} // namespace ansatz::detail
