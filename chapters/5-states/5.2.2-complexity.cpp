// SPDX-License-Identifier: BSL-1.0
// 5.2.2 Complexity: flat, a reason to leave is said once for every state; a parent says it once for all of its own

// Three behaviours of k states each, and every state must leave for each of the other behaviours when there is a
// reason: flat, that is a transition for every pair of a state and a behaviour. Put the states of a behaviour into a
// parent and each reason is said once. Both machines are built here as data, run by the interpreter on the same random
// events, and compared: the simpler one is not another machine, it is the same one. What an author still gets wrong,
// the checker finds.

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/states.hpp>

#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;

namespace {

struct Nothing {}; // the machines here only change their state
const std::string behaviours[] = {"patrol", "combat", "flee"};

//! [build]
/// Three behaviours of k states. The event "next" leads from state to state within one, the others to the first state
/// of theirs.
Outline machine_of(int k, bool hierarchical) {
    Outline outline;
    outline.origin = "machine_of";
    outline.states.emplace_back(); // the root
    auto add = [&](const std::string& name, std::size_t parent) {
        Outline::State state;
        state.name = name, state.parent = parent;
        outline.states.push_back(state);
        return outline.states.size() - 1;
    };
    auto lead = [&](std::size_t from, const std::string& event, const std::string& to) {
        Outline::Transition transition;
        transition.source = from, transition.events = event, transition.targets = {to};
        outline.transitions.push_back(transition);
    };
    auto leave = [&](std::size_t from, const std::string& mine) { // the reasons for another behaviour
        for (const auto& other : behaviours)
            if (other != mine) lead(from, other, other + " 0");
    };
    for (const auto& behaviour : behaviours) {
        const std::size_t parent = hierarchical ? add(behaviour, 0) : 0;
        if (hierarchical) leave(parent, behaviour);
        for (int i = 0; i < k; ++i) {
            const auto state = add(behaviour + " " + std::to_string(i), parent);
            lead(state, "next", behaviour + " " + std::to_string((i + 1) % k));
            if (!hierarchical) leave(state, behaviour);
        }
    }
    return outline;
}
//! [build]

/// Whether two machines are in the same innermost states after each of n random events.
bool same_trace(const Outline& a, const Outline& b, int n) {
    Nothing nothing;
    Machine<InFile<Nothing>, Interpreted> one(make_chart(a, Bindings<Nothing>{})),
        other(make_chart(b, Bindings<Nothing>{}));
    one.start(nothing), other.start(nothing);
    const std::string events[] = {"next", "next", "next", "patrol", "combat", "flee"};
    std::mt19937 random(5);
    for (int i = 0; i < n; ++i) {
        const auto& event = events[random() % 6];
        one.handle(nothing, event), other.handle(nothing, event);
        if (one.active_name() != other.active_name()) return false;
    }
    return true;
}

} // namespace

int main() {
    workbook::Claims claim;
    std::vector<int> states, flat, nested;
    bool same = true, counts = true;
    workbook::Columns table({"states", "transitions, flat", "with parents"});
    for (const int k : {1, 2, 4, 8, 16, 32}) {
        const Outline one = machine_of(k, false), other = machine_of(k, true);
        states.push_back(3 * k);
        flat.push_back(int(one.transitions.size()));
        nested.push_back(int(other.transitions.size()));
        table.row(states.back(), flat.back(), nested.back());
        same = same && same_trace(one, other, 2000);
        counts = counts && flat.back() == 3 * k * 3 && nested.back() == 3 * k + 6;
    }
    std::cout << table;
    claim("flat, every state needs a transition to each other behaviour: 3k (1 + 2)", counts);
    claim("the machine with parents does the same", same);

    // One transition forgotten among 288: a random test of ten events may not see it, and nothing in the text looks
    // wrong.
    Outline forgotten = machine_of(32, false);
    forgotten.transitions.erase(forgotten.transitions.begin() + 100);
    claim("one forgotten transition goes unseen for ten events, and comes out after ten thousand",
          same_trace(forgotten, machine_of(32, true), 10) && !same_trace(forgotten, machine_of(32, true), 10000));

    // And what the checker finds without running anything.
    //! [check]
    Outline wrong = machine_of(2, true);
    for (auto& transition : wrong.transitions)
        if (transition.targets[0] == "flee 0") transition.targets[0] = "combat 0"; // the wrong line was copied
    wrong.transitions.erase(wrong.transitions.begin());                            // and the first one deleted
    for (const auto& finding : check(wrong)) workbook::say() << finding.text << '\n';
    //! [check]
    claim("both states of flee are unreachable, and the checker says so",
          check(wrong).size() >= 2 && check(wrong)[0].what == Finding::What::unreachable);
    claim("about the right machines it is silent",
          check(machine_of(32, false)).empty() && check(machine_of(32, true)).empty());

    workbook::Plot plot("5.2.2",
                        "Three behaviours of k states: each reason said for every state, or once for the parent");
    plot.x("states")
        .y("transitions")
        .linked_points("flat", states, flat)
        .linked_points("with parents", states, nested)
        .write();
    return claim.result();
}
