// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: a machine is built as data and is sent the event, and LogUnhandled<4>
// keeps what nobody handled.
#include <ansatz/states.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace exercise {

struct Transition {
    int source;
    std::string event;
    bool holds;
    int target;
};
struct Chart {
    std::vector<int> parents;
    std::vector<Transition> transitions;
};
struct Unhandled {
    int state;
    std::string event;
    bool operator==(const Unhandled&) const = default;
};

struct Nothing {};
inline std::string name_of(int state) { return "s" + std::to_string(state); }

inline bool handled(const Chart& chart, int innermost, const std::string& event) {
    ansatz::Outline outline;
    ansatz::Bindings<Nothing> names;
    names.guard("holds", [](const Nothing&) { return true; });
    names.guard("does not hold", [](const Nothing&) { return false; });
    outline.states.resize(chart.parents.size());
    for (std::size_t s = 1; s < chart.parents.size(); ++s) {
        outline.states[s].name = name_of(int(s));
        outline.states[s].parent = std::size_t(chart.parents[s]);
    }
    outline.states[0].initial = {name_of(innermost)};
    for (std::size_t s = 0; s < chart.parents.size(); ++s) // the transitions of a state stand together
        for (const Transition& t : chart.transitions) {
            if (t.source != int(s)) continue;
            ansatz::Outline::Transition transition;
            transition.source = s;
            transition.events = t.event;
            transition.guard = t.holds ? "holds" : "does not hold";
            if (t.target >= 0) transition.targets = {name_of(t.target)};
            outline.transitions.push_back(transition);
        }
    Nothing nothing;
    ansatz::Machine<ansatz::InFile<Nothing>, ansatz::Interpreted> machine(make_chart(outline, names));
    machine.start(nothing);
    return machine.handle(nothing, event);
}
/// With guards that all hold, what is not handled in a state never is.
inline std::vector<Unhandled> never_handled(const Chart& chart, const std::vector<std::string>& events) {
    Chart open = chart;
    for (Transition& t : open.transitions) t.holds = true;
    std::vector<Unhandled> all;
    for (int s = 0; s < int(chart.parents.size()); ++s)
        for (const std::string& event : events)
            if (std::count(chart.parents.begin(), chart.parents.end(), s) == 0 && !handled(open, s, event))
                all.push_back({s, event});
    return all;
}

struct Log : ansatz::LogUnhandled<4> {
    std::vector<std::string> names; ///< of the events, by their numbers
};
inline void note(Log& log, const Unhandled& one) {
    ansatz::Happening happening{ansatz::Happening::What::unhandled};
    happening.state = ansatz::StateId(one.state), happening.event = ansatz::EventId(log.names.size());
    log.names.push_back(one.event);
    log(happening);
}
inline std::vector<Unhandled> last(const Log& log) {
    std::vector<Unhandled> all;
    for (std::size_t i = 0; i < log.size(); ++i)
        all.push_back({int(ansatz::index(log[i].state)), log.names[ansatz::index(log[i].event)]});
    return all;
}

} // namespace exercise
