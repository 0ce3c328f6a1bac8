// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A quantity as text for error sentences and labels: "-3 kg", "(0, 9.5, 0) m". Numbers are the
/// shortest that read back as the same value; no streams, no locale. For output with a chosen
/// precision use print.hpp. Text is appended by one function of std::string, since every program compiles what it
/// takes.

#include <ansatz/core/error.hpp>
#include <ansatz/units/quantity.hpp>
#include <ansatz/units/symbol.hpp>

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace ansatz {
namespace detail {

template <class S> [[gnu::cold]] inline void append_number(std::string& text, const S& value) {
    if constexpr (std::is_arithmetic_v<S>) {
        if constexpr (std::is_floating_point_v<S>)
            // NOLINTNEXTLINE(misc-redundant-expression): true for what is no number
            if (value != value) { // to_chars shows the sign of a NaN, which means nothing to a reader
                text.append("nan", 3);
                return;
            }
        char buffer[128];
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
        text.append(buffer, std::size_t(end - buffer));
    } else text += value.str(); // a Boost.Multiprecision number
}

template <class S, int R, int C, int O>
[[gnu::cold]] inline void append_number(std::string& text, const Dense<S, R, C, O>& m) {
    for (int i = 0; i < R; ++i) {
        if (i == 0) text.append("(", 1);
        else text.append(", ", 2);
        if constexpr (C != 1) text.append("(", 1);
        for (int j = 0; j < C; ++j) {
            if (j != 0) text.append(", ", 2);
            append_number(text, m.coeff(i, j));
        }
        if constexpr (C != 1) text.append(")", 1);
    }
    text.append(")", 1);
}

} // namespace detail

/// Text of a quantity: value and symbol, "2 kg", "(0, 9.5, 0) m"; a dimensionless one is its number.
template <class Unit, class Value> [[gnu::cold]] std::string describe(const boost::units::quantity<Unit, Value>& q) {
    std::string text;
    detail::append_number(text, q.value());
    if (constexpr auto unit_symbol = symbol<Unit>(); !unit_symbol.empty()) {
        text.append(" ", 1);
        text.append(unit_symbol.data(), unit_symbol.size());
    }
    return text;
}
/// Text of a plain number, "0.5", "nan", "inf".
template <detail::Builtin Number> [[gnu::cold]] std::string describe(const Number& value) {
    std::string text;
    detail::append_number(text, value);
    return text;
}
/// Text of a plain vector, "(0, 1, 0)".
template <class S, int R, int C, int O> [[gnu::cold]] std::string describe(const detail::Dense<S, R, C, O>& value) {
    std::string text;
    detail::append_number(text, value);
    return text;
}

/// The sentence about a value, of the value itself: what makes the text of it stands in no function that is not
/// refused.
template <class Value>
    requires(!std::convertible_to<const Value&, std::string_view>)
[[noreturn, gnu::cold, gnu::noinline]] void refuse_value(std::string_view where, std::string_view what,
                                                         const Value& value, std::string_view accepted) {
    refuse_value(where, what, std::string_view(describe(value)), accepted);
}

} // namespace ansatz
