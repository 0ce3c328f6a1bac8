// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Outline`: a machine as data, with names instead of functions. It is what a file holds, what a picture is drawn from
/// and what the checker reads. `outline_of<GuardNpc>()` makes one of a description; guards and actions without a name
/// get one that says where they stand ("patrol: guard 1").

#include <ansatz/states/core.hpp>
#include <ansatz/states/names.hpp>

#include <string>
#include <vector>

namespace ansatz {

/// A machine as data.
struct Outline {
    /// Something that is done.
    struct Content {
        /// What is done: a bound function, raising an event, or writing a text.
        enum class What : std::uint8_t { action, raise, log };
        What what = What::action; ///< which of them
        std::string name;         ///< of the action or the event; the text of a log
        long line = 0;            ///< in its file
        /// The same, in whatever line.
        friend bool operator==(const Content& a, const Content& b) { return a.what == b.what && a.name == b.name; }
    };
    /// A state. The first of an outline is the machine itself, and the others follow depth first.
    struct State {
        std::string name;                        ///< unique in the machine; empty for the machine itself
        states::Kind kind = states::Kind::state; ///< a place to be, final, parallel, or a history
        std::size_t parent = 0; ///< the place in `states` of the one that it is in; the machine, 0, is its own
        std::vector<std::string> initial; ///< states that are entered with it; of a history, where it goes the first
                                          ///< time; empty: the first inside
        std::vector<Content> initial_content; ///< done between its own entry and that of its initial state
        std::vector<Content> entry,           ///< done when it is entered
            exit,                             ///< done when it is left
            each;                             ///< done at every update
        std::string behaviour;                ///< the name of its class
        bool childless = false;               ///< it is entered without any of the states in it
        long line = 0;                        ///< in its file
        /// The same, in whatever line.
        friend bool operator==(const State& a, const State& b) {
            return a.name == b.name && a.kind == b.kind && a.parent == b.parent && a.initial == b.initial &&
                   a.initial_content == b.initial_content && a.entry == b.entry && a.exit == b.exit &&
                   a.each == b.each && a.behaviour == b.behaviour && a.childless == b.childless;
        }
    };
    /// A transition. They are in the order of their sources.
    struct Transition {
        std::size_t source = 0;           ///< the place in `states` of the one that it stands in
        std::string events;               ///< empty: a condition, or at once where there is no guard either
        std::vector<std::string> targets; ///< empty: nothing is left or entered
        std::string guard;                ///< its name; empty: none
        std::vector<Content> content;     ///< done when it is taken
        bool internal = false;            ///< to a state inside its source it does not leave that
        bool equality = false;            ///< its guard compares a continuous value for equality
        bool added = false;               ///< to a machine that runs (additions.hpp); no part of its description
        long line = 0;                    ///< in its file
        /// The same, in whatever line.
        friend bool operator==(const Transition& a, const Transition& b) {
            return a.source == b.source && a.events == b.events && a.targets == b.targets && a.guard == b.guard &&
                   a.content == b.content && a.internal == b.internal;
        }
    };

    std::string name;                    ///< of the machine
    std::string origin;                  ///< the path of its file, or what it was made from; for sentences
    std::vector<State> states;           ///< depth first; the machine itself is the first
    std::vector<Transition> transitions; ///< in the order of their sources

    /// The same machine, wherever it came from.
    friend bool operator==(const Outline& a, const Outline& b) {
        return a.name == b.name && a.states == b.states && a.transitions == b.transitions;
    }
};

namespace states::detail {

/// What a guard, or something done, is called in files: its name, or where it stands.
inline std::string called(std::string_view name, std::string_view where, const char* what, std::size_t number) {
    if (!name.empty()) return std::string(name);
    return std::string(where) + ": " + what + " " + std::to_string(number);
}
inline std::string_view place(std::string_view state) { return state.empty() ? std::string_view("machine") : state; }

/// How functions are named: as they are called, or by numbers in the order of the description.
struct Called {
    std::string operator()(std::string_view name, std::string_view where, const char* what, std::size_t number) const {
        return called(name, place(where), what, number);
    }
};
struct Numbered {
    std::size_t next = 0;
    std::string operator()(std::string_view, std::string_view, const char*, std::size_t) {
        return std::to_string(next++);
    }
};
/// The name of a When.
template <class W> std::string guard_name(const W& when, std::string_view source, std::size_t number, auto& namer) {
    return namer(when.called.empty() ? when.guard.name() : std::string(when.called), source, "guard", number);
}
template <class P>
Outline::Content content_of(const P& part, std::string_view where, const char* what, std::size_t& number, auto& namer) {
    ++number;
    if constexpr (std::is_same_v<decltype(part.action), Raised>)
        return {Outline::Content::What::raise, std::string(part.action.event), 0};
    else return {Outline::Content::What::action, namer(part.called, where, what, number), 0};
}
template <int Part, class Node>
std::vector<Outline::Content> contents_of(const Node& node, std::string_view where, const char* what,
                                          std::size_t& number, auto& namer) {
    std::vector<Outline::Content> found;
    each_part<Part>(node, [&](const auto& part) { found.push_back(content_of(part, where, what, number, namer)); });
    return found;
}

template <class Node> void outline_state(Outline& outline, const Node& node, std::size_t parent, auto& namer) {
    const std::size_t me = outline.states.size();
    Outline::State state;
    state.name = node.name;
    state.kind = node.kind;
    state.parent = parent;
    std::size_t entries = 0, exits = 0, updates = 0;
    each_part<part_initial>(node, [&](const Initial& i) { state.initial = {std::string(i.state)}; });
    each_part<part_to>(node, [&](const To& t) { state.initial = {std::string(t.state)}; });
    each_part<part_no_initial>(node, [&](const NoInitial&) { state.childless = true; });
    state.entry = contents_of<part_entry>(node, node.name, "entry", entries, namer);
    state.exit = contents_of<part_exit>(node, node.name, "exit", exits, namer);
    state.each = contents_of<part_each>(node, node.name, "update", updates, namer);
    each_part<part_behaves>(node, [&](const auto& b) { state.behaviour = namer(b.called, node.name, "class", 1); });
    outline.states.push_back(std::move(state));
    std::size_t guards = 0, actions = 0;
    each_part<part_transition>(node, [&](const auto& t) {
        Outline::Transition transition;
        transition.source = me;
        each_part<part_on>(t, [&](const On& on) {
            for (const auto& one : words(on.events)) transition.events += (transition.events.empty() ? "" : " ") + one;
        });
        each_part<part_to>(t, [&](const To& to) { transition.targets = {std::string(to.state)}; });
        each_part<part_internal>(t, [&](const Internal&) { transition.internal = true; });
        each_part<part_when>(t, [&](const auto& when) {
            transition.guard = guard_name(when, node.name, ++guards, namer);
            transition.equality = when.guard.is_equality();
        });
        transition.content = contents_of<part_then>(t, node.name, "action", actions, namer);
        outline.transitions.push_back(std::move(transition));
    });
    each_part<part_state>(node, [&](const auto& child) { outline_state(outline, child, me, namer); });
}

template <class D> Outline outline_named(auto namer) {
    Outline outline;
    outline.origin = "the description";
    outline_state(outline, D::machine, 0, namer);
    return outline;
}

} // namespace states::detail

/// The outline of a description.
template <class D> Outline outline_of() { return states::detail::outline_named<D>(states::detail::Called{}); }

} // namespace ansatz
