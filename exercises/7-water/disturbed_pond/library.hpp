// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/states.hpp>
#include <ansatz/water/ripples.hpp>

#include <array>
#include <string_view>

namespace exercise {

enum class State { calm, stirred, settling };

struct Seen {
    bool somebody_wades = false;
    std::size_t rings = 0;
    bool somebody() const { return somebody_wades; }
    bool no_ring() const { return rings == 0; }
};

/// The machine of the chapter, beginning in a state of our choice.
template <State Begin> struct Pond {
    using Context = Seen;
    static constexpr std::array<std::string_view, 3> names{"calm", "stirred", "settling"};
    static constexpr auto machine = [] {
        using namespace ansatz::states;
        constexpr auto wades = asked("somebody wades", &Seen::somebody);
        return ansatz::states::machine(
            initial(names[std::size_t(Begin)]), state("calm", transition(when(wades), to("stirred"))),
            state("stirred", transition(when(!wades), to("settling"))),
            state("settling", transition(when(wades), to("stirred")),
                  transition(when(asked("the rings are gone", &Seen::no_ring)), to("calm"))));
    }();
};
template <State Begin> State after_update(Seen seen) {
    ansatz::Machine<Pond<Begin>, ansatz::Switch> machine;
    machine.start(seen);
    machine.update(seen, 0.1 * ansatz::second);
    return State(ansatz::index(machine.active()) - 1); // the root is 0
}
inline State next(State now, bool somebody_wades, std::size_t rings) {
    const Seen seen{somebody_wades, rings};
    if (now == State::calm) return after_update<State::calm>(seen);
    return now == State::stirred ? after_update<State::stirred>(seen) : after_update<State::settling>(seen);
}

/// Each stride that is over by now, and was not before.
inline int begun(ansatz::Quantity<ansatz::unit::Time> before, ansatz::Quantity<ansatz::unit::Time> now,
                 ansatz::Quantity<ansatz::unit::Time> stride) {
    int count = 0;
    for (int n = 1; double(n) * stride <= now; ++n) count += double(n) * stride > before;
    return count;
}

inline bool faded(ansatz::Quantity<ansatz::unit::Time> age, ansatz::Quantity<ansatz::unit::Frequency> damping) {
    using namespace ansatz;
    Ripples rings(1);
    rings.begin({.x = 0.0 * metre, .z = 0.0 * metre, .begun = 0.0 * second, .damping = damping});
    rings.forget_faded(age);
    return rings.size() == 0;
}

} // namespace exercise
