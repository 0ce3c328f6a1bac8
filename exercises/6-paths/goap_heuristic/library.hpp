// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/goap/heuristics.hpp>
#include <ansatz/paths/goap/state_graph.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace exercise {

using State = std::uint64_t;

struct Goal {
    State value = 0, care = 0;
};
struct Action {
    State value = 0, care = 0;
    double cost = 1;
};

inline ansatz::goap::Condition<> condition(State value, State care) { return {{{value & care}}, {{care}}}; }

inline int unmet(State state, const Goal& goal) {
    return condition(goal.value, goal.care).unmet_in(ansatz::goap::State<>{{state}}).count();
}
/// The library's actions have facts with names, and its heuristic is bound to a goal before it is asked about states.
inline double estimate(State state, const Goal& goal, const std::vector<Action>& actions) {
    ansatz::goap::Domain<> domain;
    for (int bit = 0; bit < 64; ++bit) domain.fact("fact " + std::to_string(bit));
    for (std::size_t i = 0; i < actions.size(); ++i) {
        auto action = domain.action("action " + std::to_string(i), actions[i].cost);
        for (std::size_t bit = 0; bit < 64; ++bit)
            if (actions[i].care >> bit & 1) action.makes(ansatz::goap::Fact{bit, (actions[i].value >> bit & 1) != 0});
    }
    const ansatz::goap::StateGraph<> graph(domain);
    return ansatz::goap::Careful{}.bind<double>(graph,
                                                condition(goal.value, goal.care))(ansatz::goap::State<>{{state}});
}

} // namespace exercise
