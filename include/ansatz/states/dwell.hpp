// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Guards of time: `after(2.0 * second)` in the state, `held_for(guard, 0.5 * second)` (notes 5.2, state oscillations).
///
/// Both count the machine's own time, the sum of its updates, so that a game at 30, 60 and 240 updates a second decides
/// at the same time. A dwell time bounds how often a machine can turn, whatever the noise or the feedback does: at most
/// once in that time. A transition that comes with an event and has none of them ignores it.

#include <ansatz/states/guards.hpp>

#include <limits>

namespace ansatz::states {

namespace detail {
/// Whether a sum of steps has reached a time: 120 steps of 1/60 s have reached 2 s, whichever way the sum was rounded.
constexpr bool reached(Quantity<unit::Time> passed, Quantity<unit::Time> wanted) {
    return passed.value() >= wanted.value() * (1 - 1e-9);
}

constexpr void check_dwell(std::string_view where, Quantity<unit::Time> t) {
    if (!(t.value() >= 0 && t.value() <= std::numeric_limits<double>::max()))
        refuse_value(where, "the time", t, "a time to wait is finite and not negative");
}
} // namespace detail

/// Holds once the source of the transition has been active for a time.
struct After : GuardBase {
    static constexpr bool needs_time = true;                      ///< it reads `in_state`
    Quantity<unit::Time> time;                                    ///< to wait, s
    constexpr explicit After(Quantity<unit::Time> t) : time(t) {} ///< of a time, unchecked; see after()
    /// "after 2 s".
    std::string name() const { return "after " + describe(time); }
    /// The answer.
    constexpr bool ask(const auto& q, const NoMemory&) const { return detail::reached(q.in_state, time); }
};

/// The source of the transition has been active for this time, s; also with `&&`, as a dwell time beside another guard.
/// \throws std::invalid_argument for a negative or non-finite time (in a constant expression it does not compile)
constexpr After after(Parameter<unit::Time> time) {
    detail::check_dwell("after", time);
    return After(time);
}
/// Seconds without their unit.
template <class Number>
    requires(std::is_arithmetic_v<Number>)
constexpr After after(Number) {
    static_assert(ansatz::detail::never<Number>, "Ansatz: after takes a time; write e.g. after(2.0 * second)");
    return After({});
}

/// Holds while another guard has held at every update for a time, whichever state was active.
template <AnyGuard G> struct HeldFor : GuardBase {
    static constexpr bool needs_time = true; ///< it reads `dt`
    /// What it remembers between two updates.
    struct Memory {
        [[no_unique_address]] typename G::Memory inner{}; ///< the memory of the other guard
        Quantity<unit::Time> held{};                      ///< for how long it has held, s
        bool holds = false;                               ///< whether it held at the last update
        /// What it consists of.
        static void fields(auto& self, auto&& field) {
            field("inner", self.inner);
            field("held", self.held);
            field("holds", self.holds);
        }
    };
    G guard;                   ///< the other guard
    Quantity<unit::Time> time; ///< for which it has to hold, s
    /// Of a guard and a time, unchecked; see held_for().
    constexpr HeldFor(G g, Quantity<unit::Time> t) : guard(g), time(t) {}
    /// Whether the other compares a continuous value for equality.
    constexpr bool is_equality() const { return guard.is_equality(); }

    /// The first answer of the other guard; no time has passed.
    constexpr void begin(Memory& memory, const auto& q) const {
        memory = {};
        if constexpr (requires { guard.begin(memory.inner, q); }) guard.begin(memory.inner, q);
        memory.holds = guard.ask(q, memory.inner);
    }
    /// Asks the other guard, and adds the time of this update while it holds.
    constexpr void sample(Memory& memory, const auto& q) const {
        if constexpr (requires { guard.sample(memory.inner, q); }) guard.sample(memory.inner, q);
        const bool before = memory.holds;
        memory.holds = guard.ask(q, memory.inner);
        // Time between two updates at which it held; the first of them begins at nothing.
        memory.held = memory.holds && before ? memory.held + q.dt : Quantity<unit::Time>{};
    }
    /// "guard for 0.5 s".
    std::string name() const { return guard.name() + " for " + describe(time); }
    /// The answer.
    constexpr bool ask(const auto&, const Memory& memory) const {
        return memory.holds && detail::reached(memory.held, time);
    }
};

/// The guard has held at every update for this time, s.
/// \throws std::invalid_argument for a negative or non-finite time
template <AnyGuard G> constexpr HeldFor<G> held_for(G guard, Parameter<unit::Time> time) {
    detail::check_dwell("held_for", time);
    return {guard, time};
}

} // namespace ansatz::states
