// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a machine does beside its transitions: what happens to unhandled events, and what its watchers are told.
///
/// `Machine<GuardNpc, Switch, CountUnhandled, Recorded<>>`: options stand in any order after the representation, and
/// what is not listed costs nothing. An event for which no active state has a transition whose guard holds is
/// *unhandled*:
///
/// | option             | an unhandled event                                          |
/// |--------------------|-------------------------------------------------------------|
/// | `IgnoreUnhandled`  | is forgotten (the default)                                  |
/// | `CountUnhandled`   | is counted                                                  |
/// | `LogUnhandled<N>`  | is counted, and the last N are kept with state and time     |
/// | `RefuseUnhandled`  | throws std::invalid_argument; the machine is as it was      |
///
/// A *watcher* is any struct with `void operator()(const Happening&)`; read it by `machine.get<Recorded<>>()`. It is a
/// part of the machine and copied with it. Watchers see; nothing that they do reaches the machine.

#include <ansatz/core/error.hpp>
#include <ansatz/states/ids.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ansatz {

/// What happened in a machine.
struct Happening {
    /// What it was.
    enum class What : std::uint8_t { exited, took, entered, unhandled };
    What what;                     ///< tells which of the others have a value
    StateId state = StateId::none; ///< that was left or entered; of a transition, its source; of an event, the
                                   ///< innermost active state
    TransitionId transition = TransitionId::none; ///< that was taken
    EventId event = EventId::none;                ///< that was not handled
    Quantity<unit::Time> time{};                  ///< of the machine, since its start

    /// The same thing happened, at whatever time.
    friend bool operator==(const Happening& a, const Happening& b) {
        return a.what == b.what && a.state == b.state && a.transition == b.transition && a.event == b.event;
    }
};

namespace states {
/// Whether T is an option that says what happens to unhandled events.
template <class T>
concept UnhandledPolicy = requires { T::unhandled_policy; };
/// Whether T is an option that says what happens to compound states without an active child.
template <class T>
concept ChildlessPolicy = requires { T::childless_policy; };
/// Whether T watches a machine.
template <class T>
concept Watcher = requires(T& watcher, const Happening& happening) { watcher(happening); };
} // namespace states

/// A state may be active without any of the states in it, where it says `no_initial()`. Without this option, such a
/// machine is refused: a compound state without an active child is most often one whose author forgot where it begins.
struct AllowChildless {
    static constexpr bool childless_policy = true; ///< it says what happens to compound states without an active child
};

/// Unhandled events are forgotten.
struct IgnoreUnhandled {
    static constexpr bool unhandled_policy = true; ///< it says what happens to unhandled events
};

/// Unhandled events are counted.
struct CountUnhandled {
    static constexpr bool unhandled_policy = true; ///< it says what happens to unhandled events
    std::uint64_t count = 0;                       ///< since the machine was made
    void operator()(const Happening& h) { count += h.what == Happening::What::unhandled; } ///< counts
};

/// Unhandled events are counted, and the last N are kept.
template <std::size_t N = 16> struct LogUnhandled {
    static_assert(N > 0, "Ansatz: LogUnhandled<N> keeps at least one event");
    static constexpr bool unhandled_policy = true; ///< it says what happens to unhandled events
    std::uint64_t count = 0;                       ///< since the machine was made
    std::array<Happening, N> kept{};               ///< a ring: the next one takes the place of the oldest
    /// Keeps it.
    void operator()(const Happening& h) {
        if (h.what == Happening::What::unhandled) kept[std::size_t(count++ % N)] = h;
    }
    /// How many are kept.
    std::size_t size() const { return std::size_t(count < N ? count : N); }
    /// The i-th of those that are kept, the oldest first.
    const Happening& operator[](std::size_t i) const { return kept[std::size_t((count - size() + i) % N)]; }
};

/// An unhandled event is refused with a sentence that names it and the state.
struct RefuseUnhandled {
    static constexpr bool unhandled_policy = true; ///< it says what happens to unhandled events
};

/// Keeps the last N things that happened.
template <std::size_t N = 64> struct Recorded {
    static_assert(N > 0, "Ansatz: Recorded<N> keeps at least one");
    std::uint64_t count = 0;         ///< since the machine was made
    std::array<Happening, N> kept{}; ///< a ring: the next one takes the place of the oldest
    void operator()(const Happening& h) { kept[std::size_t(count++ % N)] = h; } ///< keeps
    /// How many are kept.
    std::size_t size() const { return std::size_t(count < N ? count : N); }
    /// The i-th of those that are kept, the oldest first.
    const Happening& operator[](std::size_t i) const { return kept[std::size_t((count - size() + i) % N)]; }
    /// Forgets them.
    void clear() { count = 0; }
};

namespace states {

/// The options of one machine, as its members.
template <class... O> struct Options : O... {
    static_assert(((UnhandledPolicy<O> || Watcher<O> || ChildlessPolicy<O>)&&...),
                  "Ansatz: the options of a Machine are IgnoreUnhandled, CountUnhandled, LogUnhandled<>, "
                  "RefuseUnhandled, AllowChildless, and watchers: structs with void operator()(const Happening&)");
    static_assert((std::size_t(UnhandledPolicy<O>) + ... + 0) <= 1,
                  "Ansatz: a machine has one way to treat unhandled events");
    static constexpr bool watched = (Watcher<O> || ...);           ///< whether anyone wants to be told
    static constexpr bool childless = (ChildlessPolicy<O> || ...); ///< whether a compound state may be active alone
    static constexpr bool refuses = (std::is_same_v<O, RefuseUnhandled> || ...); ///< whether an unhandled event throws

    constexpr Options() = default; ///< each as it is by default
    /// With these values to begin with, in the order of the type.
    constexpr explicit Options(O... o)
        requires(sizeof...(O) > 0)
        : O(o)... {}

    /// Tells the watchers.
    constexpr void tell([[maybe_unused]] const Happening& h) {
        (
            [&] {
                if constexpr (Watcher<O>) static_cast<O&>(*this)(h);
            }(),
            ...);
    }
};

/// Throws std::invalid_argument: no transition handles an event in a state; both by name.
/// \param event  as the caller gave it; none if it was a number that has no name of its own
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_event(std::optional<std::string_view> event,
                                                                std::string_view state) {
    refuse(Refusal::invalid_argument,
           "Machine::handle: nobody handles " +
               (event ? "the event \"" + std::string(*event) + "\""
                      : std::string("an event that no transition of the machine names,")) +
               " in the state \"" + std::string(state) +
               "\"; add a transition, or choose IgnoreUnhandled, CountUnhandled or LogUnhandled<>");
}
/// Throws std::invalid_argument: the machine was not started.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_not_started() {
    refuse(Refusal::invalid_argument, "Machine: it is in no state yet; call start(context) before handle and update");
}
/// Throws std::invalid_argument: the time of an update, s, is negative or not finite.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_dt(Quantity<unit::Time> dt) {
    refuse_value("Machine::update", "dt", dt, "the time of an update is finite and not negative");
}

} // namespace states
} // namespace ansatz
