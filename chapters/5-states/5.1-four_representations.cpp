// SPDX-License-Identifier: BSL-1.0
// 5.1 Implementation methods: one description, four representations, the same evening

// The notes know three ways to build a machine: a switch, a class for each state, and a structure that is read from a
// file. A table is the fourth. They differ in what they cost and in who can change them, and in nothing else: here the
// same description of a guard becomes each of them, as a template parameter, and all four live through the same
// evening.

#include "claims.hpp"
#include "graphviz.hpp"
#include "guard_film.hpp"
#include "guard_npc.hpp"

#include <iostream>

using namespace guard;

int main() {
    workbook::Claims claim;

    //! [four]
    Npc one, two, three, four;
    Machine<GuardNpc, Switch> by_switch;
    Machine<GuardNpc, StatePattern> by_classes;
    Machine<GuardNpc, Table> by_table;
    Machine<GuardNpc, Interpreted> interpreted;
    const Trace trace = evening(one, by_switch);
    const bool same =
        trace == evening(two, by_classes) && trace == evening(three, by_table) && trace == evening(four, interpreted);
    //! [four]
    print(trace);
    claim("all four representations have this trace, state by state and step by step", same);
    claim("and leave the same guard behind",
          one.place == two.place && two.place == three.place && three.place == four.place && one.blows == four.blows);
    claim("also the data of a state class: the legs that he walked",
          by_switch.own<Walk>(by_switch.state("patrol")).legs ==
              interpreted.own<Walk>(interpreted.state("patrol")).legs);

    // The evening itself: the noise sends him to look; he sees at 7 m, strikes at 1 m, and rests two seconds after each
    // blow.
    claim("he heard the noise after a second, and looked for three",
          trace[1] == Began{60, "search"} && trace[2] == Began{60 + 179, "patrol"});
    claim("after each blow he rested for two seconds", [&] {
        for (std::size_t i = 0; i + 1 < trace.size(); ++i)
            if (trace[i].state == "strike" && trace[i + 1].step - trace[i].step != 120) return false;
        return true;
    }());

    // What differs is size and speed; `./workbook costs states` measures them. A machine is a value in all four.
    //! [value]
    auto snapshot = by_switch;
    Npc of_snapshot = one;
    by_switch.handle(one, "noise");
    //! [value]
    claim("a copy is a snapshot: it heard nothing of the noise that came later",
          snapshot.is_in("patrol") && by_switch.is_in("search") && of_snapshot.place == one.place);
    draw_evening();
    workbook::draw_graph("5.1", to_dot(outline_of<GuardNpc>(), by_switch.active_names()));
    return claim.result();
}
