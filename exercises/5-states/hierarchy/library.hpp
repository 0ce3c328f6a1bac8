// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: a machine of these states is built as data and run, and a watcher tells
// what it left, entered and took.
#include <ansatz/states.hpp>

#include <string>
#include <vector>

namespace exercise {

using Parents = std::vector<int>;
struct Way {
    std::vector<int> left, entered;
};
struct Transition {
    int source;
    bool holds;
};

/// A machine of the given states, which begins in `innermost`.
struct Tree {
    struct Context {
        std::vector<bool> holds;
    };
    ansatz::Outline outline;
    ansatz::Bindings<Context> names;
    std::vector<int> states;         // the outline has them depth first
    std::vector<std::size_t> places; // of each state in the outline

    Tree(const Parents& parents, int innermost) : places(parents.size()) {
        put(parents, 0);
        outline.states[0].initial = {name(innermost)};
    }
    void put(const Parents& parents, int s) {
        places[std::size_t(s)] = states.size();
        states.push_back(s);
        auto& state = outline.states.emplace_back();
        if (s != 0) {
            state.name = name(s);
            state.parent = places[std::size_t(parents[std::size_t(s)])];
        }
        for (std::size_t inner = 1; inner < parents.size(); ++inner)
            if (parents[inner] == s) put(parents, int(inner));
    }
    static std::string name(int s) { return "s" + std::to_string(s); }

    using Machine = ansatz::Machine<ansatz::InFile<Context>, ansatz::Interpreted, ansatz::Recorded<>>;
    /// Runs one update, and hands over what happened in it.
    ansatz::Recorded<> update(Context context) const {
        Machine machine(make_chart(outline, names), ansatz::Recorded<>{});
        machine.start(context);
        machine.get<ansatz::Recorded<>>().clear();
        machine.update(context, 1.0 * ansatz::second);
        return machine.get<ansatz::Recorded<>>();
    }
    void lead(int source, const std::string& guard, int target) {
        ansatz::Outline::Transition transition;
        transition.source = places[std::size_t(source)];
        transition.guard = guard;
        transition.targets = {name(target)};
        outline.transitions.push_back(transition);
    }
};

inline Way way(const Parents& parents, int source, int target) {
    Tree tree(parents, source);
    tree.names.guard("always", [](const Tree::Context&) { return true; });
    tree.lead(source, "always", target);
    const auto recorded = tree.update({});
    Way way;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        const int state = tree.states[ansatz::index(recorded[i].state)];
        if (recorded[i].what == ansatz::Happening::What::exited) way.left.push_back(state);
        // What is entered behind the target is where that begins.
        if (recorded[i].what == ansatz::Happening::What::entered &&
            (way.entered.empty() || way.entered.back() != target))
            way.entered.push_back(state);
    }
    return way;
}
inline int around_both(const Parents& parents, int source, int target) {
    return parents[std::size_t(way(parents, source, target).left.back())];
}

inline int taken(const Parents& parents, int innermost, const std::vector<Transition>& transitions) {
    Tree tree(parents, innermost);
    Tree::Context context;
    std::vector<int> order; // the transitions of a state stand together
    for (const int s : tree.states)
        for (std::size_t i = 0; i < transitions.size(); ++i) {
            if (transitions[i].source != s) continue;
            const std::size_t number = order.size();
            tree.names.guard(Tree::name(int(number)),
                             [number](const Tree::Context& c) { return bool(c.holds[number]); });
            tree.lead(s, Tree::name(int(number)), innermost);
            context.holds.push_back(transitions[i].holds);
            order.push_back(int(i));
        }
    const auto recorded = tree.update(context);
    for (std::size_t i = 0; i < recorded.size(); ++i)
        if (recorded[i].what == ansatz::Happening::What::took) return order[ansatz::index(recorded[i].transition)];
    return -1;
}

} // namespace exercise
