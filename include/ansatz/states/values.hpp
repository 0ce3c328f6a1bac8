// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Values in guards: `value("distance", &Npc::distance) < 5.0 * metre`.
///
/// A value is a name and how to read it from the context: a member, or a function. Compared with a quantity of its unit
/// it is a guard that knows its own name, "distance < 5 m", and of which the checker can tell what it is about. An
/// equality of a continuous value is the notes' missed transition (5.2): a body that moves 0.3 m in a step is never
/// *at* the door. It compiles, because the notes speak of it, and `check` reports it; write `crosses`, `rises_through`
/// or `falls_through`.

#include <ansatz/states/guards.hpp>

#include <functional>
#include <limits>

namespace ansatz::states {

/// How a value is compared.
enum class Comparison : std::uint8_t { less, less_equal, greater, greater_equal, equal, not_equal };

/// The sign of a comparison.
constexpr std::string_view sign(Comparison how) {
    constexpr std::string_view signs[] = {"<", "<=", ">", ">=", "==", "!="};
    return signs[std::size_t(how)];
}

namespace detail {

template <class V>
concept HasUnit = requires(const V& v) {
    typename V::unit_type;
    v.value();
};

/// The number in a value: that of a quantity, or itself.
template <class V> constexpr auto number_of(const V& v) {
    if constexpr (HasUnit<V>) return v.value();
    else return v;
}
template <class V> std::string text_of(const V& v) {
    if constexpr (HasUnit<V>) return describe(v);
    else if constexpr (std::is_arithmetic_v<V>) {
        std::string text;
        ansatz::detail::append_number(text, v);
        return text;
    } else return "a value";
}
/// Whether a value and a limit are of one unit, or both have none.
template <class V, class L>
concept Ordered = requires(const V& v, const L& l) { v < l; };
template <class V, class L>
inline constexpr bool comparable = [] {
    if constexpr (HasUnit<std::remove_cvref_t<V>> != HasUnit<L>) return false;
    else return Ordered<std::remove_cvref_t<V>, L>;
}();
/// Whether values lie so close together that one which changes is hardly ever equal to another: floating-point numbers
/// and quantities.
template <class V>
inline constexpr bool continuous =
    !std::is_integral_v<decltype(number_of(std::declval<const V&>()))> && !std::is_enum_v<V>;

} // namespace detail

/// A named value of the context.
/// \tparam Read  a pointer to a member, or a function of the context
template <class Read> struct Value {
    std::string_view called; ///< its name in files, pictures and reports
    Read read;               ///< how it is read from the context

    /// The value.
    constexpr decltype(auto) operator()(const auto& context) const { return std::invoke(read, context); }
};

/// A named value, to compare and to watch.
/// \param name  in files, pictures and reports
/// \param read  `&Npc::distance`, or a function of the context; its unit is that of what it is compared with
template <class Read> constexpr Value<Read> value(std::string_view name, Read read) { return {name, read}; }

/// A value compared with a limit.
template <class Read, class Limit> struct Compared : GuardBase {
    Value<Read> value; ///< what is compared
    Comparison how;    ///< by which operator
    Limit limit;       ///< with what, in the unit of the value
    /// Of a value, an operator and a limit.
    constexpr Compared(Value<Read> v, Comparison h, Limit l) : value(v), how(h), limit(l) {}

    /// Whether it compares a continuous value for equality, which motion steps over.
    constexpr bool is_equality() const { return detail::continuous<Limit> && how == Comparison::equal; }
    /// "distance < 5 m".
    std::string name() const {
        return std::string(value.called) + " " + std::string(sign(how)) + " " + detail::text_of(limit);
    }
    /// The answer; a value that is not a number answers no, to != too.
    constexpr bool ask(const auto& q, const NoMemory&) const {
        const auto now = value(std::as_const(q.context));
        constexpr bool one_unit = detail::comparable<decltype(now), Limit>;
        static_assert(one_unit, "Ansatz: a guard compares a value with a limit of another unit, or without one; write "
                                "e.g. value(\"distance\", &Npc::distance) < 5.0 * metre");
        if constexpr (one_unit) switch (how) {
            case Comparison::less: return now < limit;
            case Comparison::less_equal: return now <= limit;
            case Comparison::greater: return now > limit;
            case Comparison::greater_equal: return now >= limit;
            case Comparison::equal: return now == limit;
            case Comparison::not_equal: return now < limit || now > limit;
            }
        return false;
    }
};

/// A guard.
template <class R, class L> constexpr Compared<R, L> operator<(Value<R> v, L limit) {
    return {v, Comparison::less, limit};
}
/// A guard.
template <class R, class L> constexpr Compared<R, L> operator<=(Value<R> v, L limit) {
    return {v, Comparison::less_equal, limit};
}
/// A guard.
template <class R, class L> constexpr Compared<R, L> operator>(Value<R> v, L limit) {
    return {v, Comparison::greater, limit};
}
/// A guard.
template <class R, class L> constexpr Compared<R, L> operator>=(Value<R> v, L limit) {
    return {v, Comparison::greater_equal, limit};
}
/// A guard; see the notes' missed transitions.
template <class R, class L> constexpr Compared<R, L> operator==(Value<R> v, L limit) {
    return {v, Comparison::equal, limit};
}
/// A guard.
template <class R, class L> constexpr Compared<R, L> operator!=(Value<R> v, L limit) {
    return {v, Comparison::not_equal, limit};
}

} // namespace ansatz::states
