// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The symbol of a unit as text, made at compile time: "m/s", "N", "kg m^2/s^3". Used by
/// describe.hpp for error sentences and by print.hpp. Only coherent SI units: a unit of another
/// system has no symbol here, and asking for it does not compile.

#include <ansatz/units/unit.hpp>

#include <boost/units/base_dimension.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace ansatz {
namespace detail {

/// Exponents of the base units in the order in which a symbol spells them.
struct Exponents {
    static constexpr int count = 9;
    long numerator[count]{};
    long denominator[count]{1, 1, 1, 1, 1, 1, 1, 1, 1};
};

inline constexpr std::array<std::string_view, Exponents::count> base_symbols{"kg",  "m",  "s",   "A", "K",
                                                                             "mol", "cd", "rad", "sr"};

template <class Base> inline constexpr int base_index = -1;
template <> inline constexpr int base_index<boost::units::mass_base_dimension> = 0;
template <> inline constexpr int base_index<boost::units::length_base_dimension> = 1;
template <> inline constexpr int base_index<boost::units::time_base_dimension> = 2;
template <> inline constexpr int base_index<boost::units::current_base_dimension> = 3;
template <> inline constexpr int base_index<boost::units::temperature_base_dimension> = 4;
template <> inline constexpr int base_index<boost::units::amount_base_dimension> = 5;
template <> inline constexpr int base_index<boost::units::luminous_intensity_base_dimension> = 6;
template <> inline constexpr int base_index<boost::units::plane_angle_base_dimension> = 7;
template <> inline constexpr int base_index<boost::units::solid_angle_base_dimension> = 8;

template <class Dimension> struct ExponentsOf;
template <> struct ExponentsOf<boost::units::dimensionless_type> {
    static constexpr void add(Exponents&) {}
};
template <class Base, long N, long D, class Rest>
struct ExponentsOf<boost::units::list<boost::units::dim<Base, boost::units::static_rational<N, D>>, Rest>> {
    static constexpr void add(Exponents& e) {
        static_assert(base_index<Base> >= 0, "Ansatz units: this unit has a base dimension that SI does not know");
        e.numerator[base_index<Base>] = N;
        e.denominator[base_index<Base>] = D;
        ExponentsOf<Rest>::add(e);
    }
};

/// A text of limited length that can be built at compile time.
struct SymbolText {
    char text[128]{};
    std::size_t size = 0;

    constexpr void add(std::string_view s) {
        for (char c : s) text[size++] = c;
    }
    constexpr void add(long n) {
        if (n >= 10) add(n / 10);
        text[size++] = static_cast<char>('0' + n % 10);
    }
    /// One base unit with a positive exponent n/d.
    constexpr void add(std::string_view base, long n, long d) {
        add(base);
        if (d != 1) {
            add("^(");
            add(n);
            add("/");
            add(d);
            add(")");
        } else if (n != 1) {
            add("^");
            add(n);
        }
    }
};

/// The unit's own name, where physics has one that a reader expects; else empty.
constexpr std::string_view named_symbol(const Exponents& e) {
    struct Named {
        std::string_view symbol;
        int mass, length, time;
    };
    constexpr Named names[] = {
        {"N", 1, 1, -2},   {"J", 1, 2, -2},   {"W", 1, 2, -3},     {"Pa", 1, -1, -2},
        {"N/m", 1, 0, -2}, {"m/N", -1, 0, 2}, {"Pa s", 1, -1, -1},
    };
    for (int i = 0; i < Exponents::count; ++i)
        if (e.denominator[i] != 1 || (i > 2 && e.numerator[i] != 0)) return {};
    for (const Named& n : names)
        if (e.numerator[0] == n.mass && e.numerator[1] == n.length && e.numerator[2] == n.time) return n.symbol;
    return {};
}

constexpr SymbolText symbol_text(const Exponents& e) {
    SymbolText result;
    if (const auto name = named_symbol(e); !name.empty()) {
        result.add(name);
        return result;
    }
    int above = 0;
    int below = 0;
    for (int i = 0; i < Exponents::count; ++i) {
        above += e.numerator[i] > 0;
        below += e.numerator[i] < 0;
    }
    bool first = true;
    for (int i = 0; i < Exponents::count; ++i)
        if (e.numerator[i] > 0) {
            result.add(first ? "" : " ");
            result.add(base_symbols[static_cast<std::size_t>(i)], e.numerator[i], e.denominator[i]);
            first = false;
        }
    if (below == 0) return result;
    result.add(above == 0 ? "1/" : "/");
    result.add(below > 1 ? "(" : "");
    first = true;
    for (int i = 0; i < Exponents::count; ++i)
        if (e.numerator[i] < 0) {
            result.add(first ? "" : " ");
            result.add(base_symbols[static_cast<std::size_t>(i)], -e.numerator[i], e.denominator[i]);
            first = false;
        }
    result.add(below > 1 ? ")" : "");
    return result;
}

template <class Dimension> constexpr SymbolText make_symbol() {
    Exponents e;
    ExponentsOf<Dimension>::add(e);
    return symbol_text(e);
}

template <class Dimension> inline constexpr SymbolText symbol_of = make_symbol<Dimension>();

} // namespace detail

/// The symbol of a unit: `symbol(metre_per_second)` is "m/s"; "" for a dimensionless one. A unit
/// without a name of its own is spelled by its base units, "kg m^2/s^3", "m^(1/2)", "m^3/(kg s^2)".
template <class Dimension>
constexpr std::string_view symbol(const boost::units::unit<Dimension, boost::units::si::system>&) {
    return {detail::symbol_of<Dimension>.text, detail::symbol_of<Dimension>.size};
}
/// The symbol of a unit type: `symbol<unit::Velocity>()`.
template <class Unit> constexpr std::string_view symbol() { return symbol(Unit{}); }

} // namespace ansatz
