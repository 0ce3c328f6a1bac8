// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Guards: the conditions of transitions, and how they are combined (notes 5).
///
/// A guard is any function of the user's context that answers yes or no: `when("sees", [](const Npc& n) { … })`. The
/// library's own guards (`value(...) < 5.0 * metre`, `rises_through`, `after`, …) can be combined with `&&`, `||` and
/// `!`; a function of yours joins them as `asked("sees", sees) && after(2.0 * second)`. Some remember (the previous
/// value, since when they hold): their memory lies in the machine, so that a copied machine is a snapshot, and is
/// renewed **at every update, whichever state is active**. So a crossing is between the previous update and this one,
/// always.
///
/// Both sides of `&&` and `||` may be asked or not: a guard must not change anything.

#include <ansatz/states/ids.hpp>

#include <concepts>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace ansatz::states {

/// The memory of a guard that needs none.
struct NoMemory {};

/// What every guard of the library derives from.
struct GuardBase {
    using Memory = NoMemory;                             ///< what it remembers in the machine between updates: nothing
    static constexpr bool needs_time = false;            ///< whether it reads `in_state` or `dt`
    constexpr bool is_equality() const { return false; } ///< whether it compares a continuous value for equality
};

/// A guard as the machine sees it.
template <class G>
concept AnyGuard = std::derived_from<G, GuardBase> && std::is_trivially_copyable_v<typename G::Memory>;

namespace detail {

template <class F, class Context, class Own> constexpr bool call(const F& f, const Question<Context, Own>& q) {
    if constexpr (std::is_invocable_v<const F&, Context&>)
        return bool(std::invoke(f, q.context)); // also a member: &Npc::sees
    else {
        static_assert(
            std::is_invocable_v<const F&, Context&, const Own&>,
            "Ansatz: a guard is a function of the machine's Context, or of the Context and the class of the state that "
            "asks; "
            "it answers bool, e.g. when(\"sees\", [](const Npc& npc) { return npc.distance < 5.0 * metre; })");
        return bool(std::invoke(f, q.context, q.own));
    }
}

} // namespace detail

/// A function of the user's as a guard.
template <class F> struct Asked : GuardBase {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    F function;              ///< of the context, or of it and the class of the state that asks
    constexpr Asked(std::string_view n, F f) : called(n), function(f) {} ///< of that name; see asked()
    /// Its name.
    std::string name() const { return std::string(called); }
    /// The answer.
    constexpr bool ask(const auto& q, const NoMemory&) const { return detail::call(function, q); }
};

/// A function of the context as a guard that can be combined: `asked("sees", sees) && !asked("hurt", hurt)`.
template <class F> constexpr Asked<F> asked(std::string_view name, F function) { return {name, function}; }

namespace detail {

/// Two guards and their memories.
template <class A, class B> struct Pair : GuardBase {
    static constexpr bool remembers =
        !std::is_same_v<typename A::Memory, NoMemory> || !std::is_same_v<typename B::Memory, NoMemory>;
    struct Kept {
        typename A::Memory a{};
        typename B::Memory b{};
        static void fields(auto& self, auto&& field) {
            field("a", self.a);
            field("b", self.b);
        }
    };
    using Memory = std::conditional_t<remembers, Kept, NoMemory>;
    static constexpr bool needs_time = A::needs_time || B::needs_time;
    A a;
    B b;
    constexpr Pair(A first, B second) : a(first), b(second) {}
    constexpr bool is_equality() const { return a.is_equality() || b.is_equality(); }

    constexpr void begin(Memory& memory, const auto& q) const {
        each(memory, [&](const auto& g, auto& m) {
            if constexpr (requires { g.begin(m, q); }) g.begin(m, q);
        });
    }
    constexpr void sample(Memory& memory, const auto& q) const {
        each(memory, [&](const auto& g, auto& m) {
            if constexpr (requires { g.sample(m, q); }) g.sample(m, q);
        });
    }

protected:
    constexpr void each(Memory& memory, auto&& f) const {
        if constexpr (remembers) {
            f(a, memory.a);
            f(b, memory.b);
        }
    }
    constexpr bool ask_a(const auto& q, const Memory& memory) const {
        if constexpr (remembers) return a.ask(q, memory.a);
        else return a.ask(q, memory);
    }
    constexpr bool ask_b(const auto& q, const Memory& memory) const {
        if constexpr (remembers) return b.ask(q, memory.b);
        else return b.ask(q, memory);
    }
};

} // namespace detail

/// Both hold.
template <AnyGuard A, AnyGuard B> struct And : detail::Pair<A, B> {
    using detail::Pair<A, B>::Pair;
    /// "(a and b)".
    std::string name() const { return "(" + this->a.name() + " and " + this->b.name() + ")"; }
    /// The answer.
    constexpr bool ask(const auto& q, const typename detail::Pair<A, B>::Memory& m) const {
        return this->ask_a(q, m) && this->ask_b(q, m);
    }
};
/// At least one holds.
template <AnyGuard A, AnyGuard B> struct Or : detail::Pair<A, B> {
    using detail::Pair<A, B>::Pair;
    /// "(a or b)".
    std::string name() const { return "(" + this->a.name() + " or " + this->b.name() + ")"; }
    /// The answer.
    constexpr bool ask(const auto& q, const typename detail::Pair<A, B>::Memory& m) const {
        return this->ask_a(q, m) || this->ask_b(q, m);
    }
};
/// It does not hold.
template <AnyGuard A> struct Not : GuardBase {
    using Memory = typename A::Memory;                ///< that of the other guard
    static constexpr bool needs_time = A::needs_time; ///< whether the other reads `in_state` or `dt`
    A a;                                              ///< the other guard
    constexpr explicit Not(A guard) : a(guard) {}     ///< of that guard
    /// Whether the other compares a continuous value for equality.
    constexpr bool is_equality() const { return a.is_equality(); }
    /// Begins the memory of the other, if it has one.
    constexpr void begin(Memory& memory, const auto& q) const {
        if constexpr (requires { a.begin(memory, q); }) a.begin(memory, q);
    }
    /// Shows the other this update, if it remembers.
    constexpr void sample(Memory& memory, const auto& q) const {
        if constexpr (requires { a.sample(memory, q); }) a.sample(memory, q);
    }
    /// "not a".
    std::string name() const { return "not " + a.name(); }
    /// The answer.
    constexpr bool ask(const auto& q, const Memory& memory) const { return !a.ask(q, memory); }
};

/// Both hold.
template <AnyGuard A, AnyGuard B> constexpr And<A, B> operator&&(A a, B b) { return {a, b}; }
/// At least one holds.
template <AnyGuard A, AnyGuard B> constexpr Or<A, B> operator||(A a, B b) { return {a, b}; }
/// It does not hold.
template <AnyGuard A> constexpr Not<A> operator!(A a) { return Not<A>(a); }

} // namespace ansatz::states
