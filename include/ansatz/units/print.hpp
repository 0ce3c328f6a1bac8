// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Printing of quantities to streams: `std::cout << ball_position` writes "(0, 9.5, 0) m". The
/// stream's precision, format and width are honoured; a width applies to every number, so that
/// vectors stand in columns. For text without a stream use describe().

// not in the umbrella: programs that never print should not pay for <ostream>

#include <ansatz/units/quantity.hpp>
#include <ansatz/units/symbol.hpp>

#include <ostream>

namespace ansatz::detail {

template <class Char, class Traits, class S>
void print_value(std::basic_ostream<Char, Traits>& out, std::streamsize width, const S& value) {
    out.width(width);
    out << value;
}
template <class Char, class Traits, class S, int R, int C, int O>
void print_value(std::basic_ostream<Char, Traits>& out, std::streamsize width, const Dense<S, R, C, O>& m) {
    for (int i = 0; i < R; ++i) {
        out << (i == 0 ? "(" : ", ");
        if constexpr (C != 1) out << '(';
        for (int j = 0; j < C; ++j) {
            out << (j == 0 ? "" : ", ");
            print_value(out, width, m.coeff(i, j));
        }
        if constexpr (C != 1) out << ')';
    }
    out << ')';
}

} // namespace ansatz::detail

namespace boost::units {

/// Writes value and unit symbol. Takes precedence over Boost's own printing, should that be
/// included too.
template <class Char, class Traits, class Unit, class Y>
    requires(sizeof(Y) > 0)
std::basic_ostream<Char, Traits>& operator<<(std::basic_ostream<Char, Traits>& out, const quantity<Unit, Y>& q) {
    const auto width = out.width(0);
    ansatz::detail::print_value(out, width, q.value());
    if (constexpr auto text = ansatz::symbol<Unit>(); !text.empty()) {
        out << ' ';
        for (char c : text) out << c;
    }
    return out;
}

} // namespace boost::units
