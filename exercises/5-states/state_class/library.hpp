// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library has no guard of its own. It has machines, and a state's data may be one: each class here holds a small
// machine that makes the same decisions.
#include <ansatz/states.hpp>

namespace exercise {

struct Npc {
    ansatz::Quantity<ansatz::unit::Length> place{};
    int shouts = 0;
};

/// Between two posts: going there is a state, and coming back is another one.
struct Rounds {
    struct Walker {
        ansatz::Quantity<ansatz::unit::Length> place{}, step{};
    };
    using Context = Walker;
    static constexpr auto there = ansatz::states::value("place", &Walker::place);
    static constexpr auto machine = [] {
        using namespace ansatz;
        using namespace ansatz::states;
        constexpr auto walk = [](Walker& w) { w.place = max(0.0 * metre, min(10.0 * metre, w.place + w.step)); };
        constexpr auto back = [](Walker& w) { w.place = max(0.0 * metre, min(10.0 * metre, w.place - w.step)); };
        return states::machine(state("going", each_update(walk), transition(when(there >= 10.0 * metre), to("coming"))),
                               state("coming", each_update(back), transition(when(there <= 0.0 * metre), to("going"))));
    }();
};
struct Patrol {
    ansatz::Machine<Rounds> rounds{};
    void update(Npc& npc, ansatz::Quantity<ansatz::unit::Time> dt) {
        Rounds::Walker walker{npc.place, 1.0 * ansatz::metre_per_second * dt};
        if (!rounds.started()) rounds.start(walker);
        rounds.update(walker);
        npc.place = walker.place;
    }
};

struct Shouting {
    using Context = Npc;
    static constexpr auto machine = [] {
        using namespace ansatz;
        using namespace ansatz::states;
        constexpr auto shout = [](Npc& npc) { ++npc.shouts; };
        return states::machine(state("silent", on_entry(shout), transition(when(after(2.0 * second)), to("silent"))));
    }();
};
struct Alarm {
    ansatz::Machine<Shouting> shouting{};
    void enter(Npc& npc) { shouting = {}, shouting.start(npc); }
    void update(Npc& npc, ansatz::Quantity<ansatz::unit::Time> dt) { shouting.update(npc, dt); }
};

} // namespace exercise
