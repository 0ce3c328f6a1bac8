// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer: Table makes its rows while it is compiled. These come at run time, so the interpreter runs
// them, with a watcher that says which row it took.
#include <ansatz/states.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace exercise {

enum class State { locked, unlocked };
enum class Event { coin, push, kick };
struct Gate {
    int coins = 0, passed = 0, returned = 0;
};
struct Row {
    State from;
    Event event;
    bool (*guard)(const Gate&);
    void (*action)(Gate&);
    State to;
};
using Rows = std::vector<Row>;

/// A machine of these rows that begins in a state; `took` is the number of the row that it took, or -1.
struct Interpreter {
    ansatz::Machine<ansatz::InFile<Gate>, ansatz::Interpreted, ansatz::Recorded<>> machine;
    int took = -1;

    static std::string name(State s) { return s == State::locked ? "locked" : "unlocked"; }
    static auto chart(const Rows& rows, State begin) {
        ansatz::Outline outline;
        ansatz::Bindings<Gate> names;
        outline.states.resize(3);
        outline.states[0].initial = {name(begin)};
        outline.states[1].name = name(State::locked), outline.states[2].name = name(State::unlocked);
        // The transitions of a state stand together; the order of its rows stays.
        for (const State from : {State::locked, State::unlocked})
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (rows[i].from != from) continue;
                ansatz::Outline::Transition transition;
                transition.source = 1 + std::size_t(from);
                transition.events = event(rows[i].event);
                transition.targets = {name(rows[i].to)};
                if (rows[i].guard) names.guard(transition.guard = "guard " + std::to_string(i), rows[i].guard);
                if (rows[i].action) {
                    ansatz::Outline::Content content;
                    content.name = "action " + std::to_string(i);
                    names.action(content.name, rows[i].action);
                    transition.content.push_back(content);
                }
                outline.transitions.push_back(transition);
            }
        return make_chart(outline, names);
    }
    static const char* event(Event e) { return e == Event::coin ? "coin" : e == Event::push ? "push" : "kick"; }
    Interpreter(const Rows& rows, State begin, Event e, Gate& gate)
        : machine(chart(rows, begin), ansatz::Recorded<>{}) {
        machine.start(gate);
        machine.template get<ansatz::Recorded<>>().clear();
        machine.handle(gate, event(e));
        const auto& recorded = machine.template get<ansatz::Recorded<>>();
        std::vector<int> order;
        for (const State from : {State::locked, State::unlocked})
            for (std::size_t i = 0; i < rows.size(); ++i)
                if (rows[i].from == from) order.push_back(int(i));
        for (std::size_t i = 0; i < recorded.size(); ++i)
            if (recorded[i].what == ansatz::Happening::What::took) took = order[ansatz::index(recorded[i].transition)];
    }
};

inline int row_for(const Rows& rows, State state, Event event, const Gate& gate) {
    Gate copy = gate;
    return Interpreter(rows, state, event, copy).took;
}
inline State handle(const Rows& rows, State state, Event event, Gate& gate) {
    const Interpreter interpreter(rows, state, event, gate);
    return interpreter.machine.active_name() == "locked" ? State::locked : State::unlocked;
}

} // namespace exercise
