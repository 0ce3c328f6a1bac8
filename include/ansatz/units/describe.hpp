// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A quantity as text for error sentences and labels: "-3 kg", "(0, 9.5, 0) m". Numbers are the
/// shortest that read back as the same value; no streams, no locale. For output with a chosen
/// precision use print.hpp.

#include <ansatz/units/quantity.hpp>
#include <ansatz/units/symbol.hpp>

#include <charconv>
#include <string>

namespace ansatz {
namespace detail {

template <class S> [[gnu::cold]] inline void append_number(std::string& text, const S& value) {
    if constexpr (std::is_arithmetic_v<S>) {
        if constexpr (std::is_floating_point_v<S>)
            // NOLINTNEXTLINE(misc-redundant-expression): true for what is no number
            if (value != value) { // to_chars shows the sign of a NaN, which means nothing to a reader
                text += "nan";
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
        text += i == 0 ? "(" : ", ";
        if constexpr (C != 1) text += '(';
        for (int j = 0; j < C; ++j) {
            text += j == 0 ? "" : ", ";
            append_number(text, m.coeff(i, j));
        }
        if constexpr (C != 1) text += ')';
    }
    text += ')';
}

} // namespace detail

/// Text of a quantity: value and symbol, "2 kg", "(0, 9.5, 0) m"; a dimensionless one is its number.
template <class Unit, class Value> [[gnu::cold]] std::string describe(const boost::units::quantity<Unit, Value>& q) {
    std::string text;
    detail::append_number(text, q.value());
    if (constexpr auto unit_symbol = symbol<Unit>(); !unit_symbol.empty()) {
        text += ' ';
        text += unit_symbol;
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

} // namespace ansatz
