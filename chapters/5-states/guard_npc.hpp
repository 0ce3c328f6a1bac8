// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the programs of 5.1 share: a guard in a corridor, the machine that decides for him, and an evening of his work.
///
/// The intruder keeps to a script, so that every representation sees the same evening: he comes, stands, runs, is gone.

#include <ansatz/states.hpp>
#include <ansatz/units/print.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace guard {

using namespace ansatz;
using namespace ansatz::states;
using Length = Quantity<unit::Length>;
using Time = Quantity<unit::Time>;
using Speed = Quantity<unit::Velocity>;

/// What the machine decides about: the context.
struct Npc {
    Length place{}; ///< along the corridor
    Length intruder = 30.0 * metre;
    int blows = 0, shouts = 0;
    Length distance() const { return abs(intruder - place); }
    /// Goes towards a place, and no further.
    void walk(Length to, Speed speed, Time dt) { place += std::clamp(to - place, -speed * dt, speed * dt); }
};

/// Where the intruder is.
inline Length intruder_at(Time t) {
    const auto from = 30.0 * metre, stands = 14.0 * metre;
    if (t < 20.0 * second) return max(stands, from - 2.0 * metre_per_second * max(t - 4.0 * second, 0.0 * second));
    return stands + 3.0 * metre_per_second * (t - 20.0 * second);
}
/// When something falls over in the dark.
inline bool noise_at(int step) { return step == 60 || step == 35 * 60; }

//! [walk]
/// The class of the state patrol: walks from post to post. Which post is next is nobody else's business.
struct Walk {
    Length post = 10.0 * metre;
    int legs = 0;
    void update(Npc& npc, Time dt) {
        npc.walk(post, 1.0 * metre_per_second, dt);
        if (npc.place == post) post = 10.0 * metre - post, ++legs; // walk() ends exactly there
    }
};
//! [walk]
/// The class of the state chase.
struct Chase {
    void enter(Npc& npc) { ++npc.shouts; }
    void update(Npc& npc, Time dt) { npc.walk(npc.intruder, 2.0 * metre_per_second, dt); }
};
inline void strike(Npc& npc) { ++npc.blows; }

//! [machine]
/// The machine, once, for every representation.
struct GuardNpc {
    using Context = Npc;
    static constexpr auto distance = value("distance", &Npc::distance);
    static constexpr auto sight = band(distance, 8.0 * metre, 1.0 * metre); // seen below 7 m, lost above 9 m
    static constexpr auto machine = states::machine(
        state("patrol", behaves<Walk>("Walk"), transition(on("noise"), to("search")),
              transition(when("sees", sight.below()), to("chase"))),
        state("search", transition(when("sees", sight.below()), to("chase")),
              transition(when("tired", after(3.0 * second)), to("patrol"))),
        state("chase", behaves<Chase>("Chase"), transition(when("near", distance < 1.0 * metre), to("strike")),
              transition(when("lost", sight.above()), to("search"))),
        state("strike", on_entry("strike", strike), transition(when("rested", after(2.0 * second)), to("chase"))));
};
//! [machine]

/// A line of the trace: when a state began.
struct Began {
    int step;
    std::string state;
    friend bool operator==(const Began&, const Began&) = default;
};
using Trace = std::vector<Began>;

/// One evening, 45 s at 60 steps a second. `start(npc)` begins, `noise(npc)` tells of a noise, `update(npc, dt)` is a
/// step and `name()` says which state is active.
inline Trace evening(Npc& npc, auto&& start, auto&& noise, auto&& update, auto&& name) {
    Trace trace;
    auto note = [&](int step) {
        if (trace.empty() || trace.back().state != name()) trace.push_back({step, std::string(name())});
    };
    start(npc);
    note(0);
    for (int step = 1; step <= 45 * 60; ++step) {
        npc.intruder = intruder_at(step / 60.0 * second);
        if (noise_at(step)) noise(npc), note(step);
        update(npc, 1.0 / 60 * second);
        note(step);
    }
    return trace;
}
//! [evening]
/// The same with a machine of the library.
template <class Machine_> Trace evening(Npc& npc, Machine_& machine) {
    const EventId noise = machine.event("noise");
    return evening(
        npc, [&](Npc& n) { machine.start(n); }, [&](Npc& n) { machine.handle(n, noise); },
        [&](Npc& n, Time dt) { machine.update(n, dt); }, [&] { return machine.active_name(); });
}
//! [evening]

inline void print(const Trace& trace) {
    for (const auto& [step, state] : trace) std::cout << std::setw(9) << step / 60.0 << " s  " << state << '\n';
}

} // namespace guard
