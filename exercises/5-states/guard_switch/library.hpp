// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/states.hpp>

#include <array>
#include <string_view>

namespace exercise {

enum class State { patrol, search, chase, strike };

struct Seen {
    ansatz::Quantity<ansatz::unit::Length> distance;
};

/// The guard, beginning in a state of our choice.
template <State Begin> struct GuardNpc {
    using Context = Seen;
    static constexpr std::array<std::string_view, 4> names{"patrol", "search", "chase", "strike"};
    static constexpr auto machine = [] {
        using namespace ansatz;
        using namespace ansatz::states;
        constexpr auto distance = value("distance", &Seen::distance);
        constexpr auto sight = band(distance, 8.0 * metre, 1.0 * metre);
        return states::machine(
            initial(names[std::size_t(Begin)]),
            state("patrol", transition(on("noise"), to("search")), transition(when(sight.below()), to("chase"))),
            state("search", transition(when(sight.below()), to("chase")),
                  transition(when(after(3.0 * second)), to("patrol"))),
            state("chase", transition(when(distance < 1.0 * metre), to("strike")),
                  transition(when(sight.above()), to("search"))),
            state("strike", transition(when(after(2.0 * second)), to("chase"))));
    }();
};

/// A machine that begins in `now`, after whatever `happens(machine, seen)` does to it.
template <State Begin = State::patrol> State after_this(State now, Seen seen, auto&& happens) {
    if constexpr (Begin != State::strike)
        if (now != Begin) return after_this<static_cast<State>(static_cast<int>(Begin) + 1)>(now, seen, happens);
    ansatz::Machine<GuardNpc<Begin>, ansatz::Switch> machine;
    machine.start(seen);
    happens(machine, seen);
    return State(ansatz::index(machine.active()) - 1); // the root is 0
}
inline State next(State now, ansatz::Quantity<ansatz::unit::Length> distance,
                  ansatz::Quantity<ansatz::unit::Time> in_state) {
    return after_this(now, {distance}, [&](auto& machine, Seen& seen) { machine.update(seen, in_state); });
}
inline State heard(State now) {
    return after_this(now, {20.0 * ansatz::metre}, [](auto& machine, Seen& seen) { machine.handle(seen, "noise"); });
}

} // namespace exercise
