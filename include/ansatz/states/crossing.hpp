// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Crossing guards: they see the previous value and the present one (notes 5.2, missed transitions).
///
/// A body that moves 0.3 m in a step is never *at* the door, so `position == door` never holds and the transition is
/// missed. It was on one side of the door at the previous update and is on the other side now: that is what these
/// guards ask.
///
/// | guard                     | holds when the value               |
/// |---------------------------|------------------------------------|
/// | `rises_through(v, limit)` | was below, and is at or above now  |
/// | `falls_through(v, limit)` | was above, and is at or below now  |
/// | `crosses(v, limit)`       | either                             |
///
/// The previous value is that of the previous update (of `start` at the first), whichever state was active. A value
/// that is not a number is passed over: the last good one stays the previous one, so that a crossing is not lost in the
/// gap. A value that starts on the limit has not crossed it. What crosses twice within one step was never outside at an
/// update: no guard that is asked at updates can know; a shorter step can.

#include <ansatz/states/values.hpp>

namespace ansatz::states {

namespace detail {
/// In what a value is compared with its limit: in double, whole numbers are exact up to 2^53.
template <class Number>
using NumberOfCrossing = std::conditional_t<std::is_integral_v<Number> && sizeof(Number) <= 4, double, Number>;
} // namespace detail

/// In which direction a value goes through its limit.
enum class Direction : std::uint8_t { rising, falling, either };

/// Holds in the update in which a value goes through a limit.
template <class Read, class Limit> struct Crossing : GuardBase {
    static_assert(detail::continuous<Limit> || std::is_integral_v<Limit>,
                  "Ansatz: a crossing is of a number or a quantity");
    /// Of the value and the limit, without their unit. Beside a whole limit the value may have a fraction: cut off, it
    /// would be on the limit while it is on either side.
    using Number = detail::NumberOfCrossing<decltype(detail::number_of(std::declval<const Limit&>()))>;
    /// What it remembers between two updates.
    struct Memory {
        Number previous{};    ///< the last value that was a number
        bool known = false;   ///< whether there was a good value yet
        bool crossed = false; ///< whether the last update crossed
        /// What it consists of.
        static void fields(auto& self, auto&& field) {
            field("previous", self.previous);
            field("known", self.known);
            field("crossed", self.crossed);
        }
    };
    Value<Read> value;   ///< what crosses
    Limit limit;         ///< in the unit of the value
    Direction direction; ///< in which it counts
    /// Of a value, its limit and a direction.
    constexpr Crossing(Value<Read> v, Limit l, Direction d) : value(v), limit(l), direction(d) {}

    /// The first value.
    constexpr void begin(Memory& memory, const auto& q) const {
        memory = {};
        sample(memory, q);
        memory.crossed = false;
    }
    /// The value of this update.
    constexpr void sample(Memory& memory, const auto& q) const {
        const auto read = value(std::as_const(q.context));
        static_assert(detail::comparable<decltype(read), Limit>,
                      "Ansatz: a crossing guard's limit has another unit than its value, or none; write e.g. "
                      "rises_through(value(\"x\", &Npc::x), 5.0 * metre)");
        static_assert(!std::is_integral_v<Number> || std::is_integral_v<decltype(detail::number_of(read))>,
                      "Ansatz: a crossing guard's value has a fraction, and its limit is a whole number of 64 bits; "
                      "write a limit that has one too, e.g. rises_through(value(\"x\", &Npc::x), 5.0)");
        const Number now = Number(detail::number_of(read));
        const Number at = Number(detail::number_of(limit));
        memory.crossed = false;
        if (now != now) return;
        if (memory.known) {
            const bool rose = memory.previous < at && now >= at;
            const bool fell = memory.previous > at && now <= at;
            memory.crossed = (rose && direction != Direction::falling) || (fell && direction != Direction::rising);
        }
        memory.previous = now;
        memory.known = true;
    }
    /// "x rises through 5 m".
    std::string name() const {
        constexpr std::string_view verbs[] = {" rises through ", " falls through ", " crosses "};
        return std::string(value.called) + std::string(verbs[std::size_t(direction)]) + detail::text_of(limit);
    }
    /// Whether the last update crossed.
    constexpr bool ask(const auto&, const Memory& memory) const { return memory.crossed; }
};

/// Was below the limit at the previous update and is at or above it now.
template <class R, class L> constexpr Crossing<R, L> rises_through(Value<R> v, L limit) {
    return {v, limit, Direction::rising};
}
/// Was above the limit at the previous update and is at or below it now.
template <class R, class L> constexpr Crossing<R, L> falls_through(Value<R> v, L limit) {
    return {v, limit, Direction::falling};
}
/// Was on one side of the limit at the previous update and is on it or on the other side now.
template <class R, class L> constexpr Crossing<R, L> crosses(Value<R> v, L limit) {
    return {v, limit, Direction::either};
}

} // namespace ansatz::states
