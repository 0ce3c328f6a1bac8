// SPDX-License-Identifier: BSL-1.0
// 5.3 Hierarchical machines: states in states; what holds for all of a group is said once, and checked in every one

// "Divide groups of states that correspond to a single NPC behaviour into their own parent states. Transition
// conditions for each active state in the hierarchy must be checked." A guard who patrols, fights and flees, once with
// parents and once flat. The same evening gives the same states, update by update, from half as many transitions. Three
// things come with a hierarchy: inner states are asked before outer ones, the way from one state to another leaves and
// enters parents in order, and a history remembers where a parent was when it was left; the flat twin must keep that in
// a variable of its own.

#include "claims.hpp"
#include "graphviz.hpp"

#include <ansatz/states.hpp>
#include <ansatz/units/print.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Npc {
    Quantity<unit::Length> distance = 20.0 * metre; ///< to the intruder
    double health = 1;
    bool was_looking = false; ///< only the flat twin needs it
};

constexpr auto near = band(value("distance", &Npc::distance), 8.0 * metre, 1.0 * metre);
constexpr auto in_reach = value("distance", &Npc::distance) < 2.0 * metre;
constexpr auto hurt = value("health", &Npc::health) < 0.3;
constexpr auto healed = value("health", &Npc::health) > 0.9;
constexpr auto far = value("distance", &Npc::distance) > 15.0 * metre;

//! [hierarchy]
struct GuardNpc {
    using Context = Npc;
    static constexpr auto machine = states::machine(
        state("awake", transition(on("bell"), to("home")),
              state("on duty", transition(when(hurt), to("flee")),
                    state("patrol", transition(when(near.below()), to("combat")),
                          state("walk", transition(when(after(4.0 * second)), to("look"))),
                          state("look", transition(when(after(2.0 * second)), to("walk"))),
                          shallow_history("where he was", to("walk"))),
                    state("combat", transition(when(near.above()), to("where he was")),
                          state("approach", transition(when(in_reach), to("strike"))),
                          state("strike", transition(when(!in_reach), to("approach"))))),
              state("flee", transition(when(healed), to("patrol")), state("run", transition(when(far), to("hide"))),
                    state("hide", transition(when(!far), to("run"))))),
        final_state("home"));
};
//! [hierarchy]

inline void leave_walk(Npc& n) { n.was_looking = false; }
inline void leave_look(Npc& n) { n.was_looking = true; }

//! [flat]
/// The same without parents: what a parent says stands in each of its states, and the history is a variable.
struct FlatGuardNpc {
    using Context = Npc;
    static constexpr auto remembers = asked("was looking", [](const Npc& n) { return n.was_looking; });
    static constexpr auto machine =
        states::machine(state("walk", on_exit(leave_walk), transition(when(after(4.0 * second)), to("look")),
                              transition(when(near.below()), to("approach")), transition(when(hurt), to("run")),
                              transition(on("bell"), to("home"))),
                        state("look", on_exit(leave_look), transition(when(after(2.0 * second)), to("walk")),
                              transition(when(near.below()), to("approach")), transition(when(hurt), to("run")),
                              transition(on("bell"), to("home"))),
                        state("approach", transition(when(in_reach), to("strike")),
                              transition(when(near.above() && remembers), to("look")),
                              transition(when(near.above() && !remembers), to("walk")),
                              transition(when(hurt), to("run")), transition(on("bell"), to("home"))),
                        state("strike", transition(when(!in_reach), to("approach")),
                              transition(when(near.above() && remembers), to("look")),
                              transition(when(near.above() && !remembers), to("walk")),
                              transition(when(hurt), to("run")), transition(on("bell"), to("home"))),
                        state("run", transition(when(far), to("hide")), transition(when(healed), to("walk")),
                              transition(on("bell"), to("home"))),
                        state("hide", transition(when(!far), to("run")), transition(when(healed), to("walk")),
                              transition(on("bell"), to("home"))),
                        final_state("home"));
};
//! [flat]

/// The intruder comes twice; the second time he strikes back until the guard has run away. Wounds heal slowly.
void live(Npc& npc, int step) {
    const double t = step / 60.0;
    const double first =
        20 - 4 * std::clamp(t - 1.0, 0.0, 3.4) + 6 * std::clamp(t - 9.0, 0.0, 2.5); // comes to 6.4 m and goes
    const double second_time = first - 4 * std::clamp(t - 16.0, 0.0, 5.8) + 3 * std::clamp(t - 25.0, 0.0, 8.0);
    npc.distance = std::max(second_time, 1.0) * metre;
    if (t > 23 && t < 24) npc.health = std::max(0.0, npc.health - 0.8 / 60);
    if (t > 27) npc.health = std::min(1.0, npc.health + 0.1 / 60);
}

struct Began {
    int step;
    std::string state;
    friend bool operator==(const Began&, const Began&) = default;
};
template <class Machine_> std::vector<Began> evening(Machine_& machine) {
    Npc npc;
    std::vector<Began> trace;
    machine.start(npc);
    for (int step = 0; step <= 40 * 60; ++step) {
        live(npc, step);
        if (step == 38 * 60) machine.handle(npc, "bell");
        machine.update(npc, 1.0 / 60 * second);
        if (trace.empty() || trace.back().state != machine.active_name())
            trace.push_back({step, std::string(machine.active_name())});
    }
    return trace;
}

} // namespace

int main() {
    workbook::Claims claim;
    Machine<GuardNpc, Switch> guard;
    Machine<FlatGuardNpc, Switch> flat;
    const auto trace = evening(guard);
    for (const auto& [step, state] : trace) std::cout << std::setw(9) << step / 60.0 << " s  " << state << '\n';
    claim("the flat twin goes through the same states, update by update", trace == evening(flat));
    std::cout << guard.transition_count() << " transitions with parents, " << flat.transition_count() << " without\n";
    claim("with parents there are less than half as many", 2 * guard.transition_count() < flat.transition_count());
    {
        Machine<GuardNpc, StatePattern> classes;
        Machine<GuardNpc, Table> table;
        Machine<GuardNpc, Interpreted> interpreted;
        claim("every representation carries the hierarchy",
              trace == evening(classes) && trace == evening(table) && trace == evening(interpreted));
    }

    // The history: he was looking round when the intruder came, and goes on with that.
    const auto back =
        std::find_if(trace.begin(), trace.end(), [](const Began& b) { return b.state == "approach"; }) + 1;
    claim("after the first alarm he goes on where he was", (back - 2)->state == "look" && back->state == "look");

    // Who is left and entered on the way from the innermost state to another one's innermost state.
    //! [order]
    Npc npc;
    Machine<GuardNpc, Switch, Recorded<>> watched;
    watched.start(npc);
    npc.distance = 1.0 * metre;
    watched.update(npc, 1.0 / 60 * second); // patrol to combat
    npc.health = 0.1;
    watched.get<Recorded<>>().clear();
    watched.update(npc, 1.0 / 60 * second); // the innermost state is asked first, and has something to do
    watched.update(npc, 1.0 / 60 * second); // on duty to flee
    //! [order]
    std::string way;
    const auto& recorded = watched.get<Recorded<>>();
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        if (recorded[i].what == Happening::What::exited) way += " -" + std::string(watched.name(recorded[i].state));
        if (recorded[i].what == Happening::What::entered) way += " +" + std::string(watched.name(recorded[i].state));
    }
    std::cout << "left (-) and entered (+):" << way << '\n';
    claim("first the inner states ask, then their parents; children are left before parents, and entered after them",
          way == " -approach +strike -strike -combat -on duty +flee +run");
    claim("in every parent of an active state he is too",
          watched.is_in("run") && watched.is_in("flee") && watched.is_in("awake") && !watched.is_in("on duty"));

    // Both machines as pictures, at the same moment of the same evening.
    //! [pictures]
    Machine<FlatGuardNpc, Switch> flat_now;
    flat_now.start(npc, watched.active_name());
    workbook::draw_graph("5.3", to_dot(outline_of<GuardNpc>(), watched.active_names()));
    workbook::draw_graph("5.3-flat", to_dot(outline_of<FlatGuardNpc>(), flat_now.active_names()));
    //! [pictures]
    return claim.result();
}
