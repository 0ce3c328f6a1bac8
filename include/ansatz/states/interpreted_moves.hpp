// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How an interpreted machine takes a transition: what it leaves, from the inside outwards, what it does, and what it
/// enters, from the outside inwards, on to a leaf or to what a history holds (notes 5.1, 5.3). One path through the
/// states; where parallel regions are active regions.hpp does the same for all of them.

#include <ansatz/states/interpreted_machine.hpp>

namespace ansatz {

template <class D, class Context_, class... O>
inline void InterpretedMachine<D, Context_, O...>::take(Context& context, std::size_t t) {
    const auto& c = *chart_;
    const auto& row = c.transitions_[t];
    if (row.stays) return took(context, t);
    for (std::size_t s = leaf_, below = leaf_; s != row.domain; below = s, s = c.states_[s].parent) {
        const auto histories = c.states_[s].histories;
        for (std::size_t i = 0; i < histories.count; ++i) {
            const auto h = c.ids_[histories.first + i];
            history_[h] = std::uint16_t(c.states_[h].kind == states::Kind::deep_history ? leaf_ : below);
        }
        exit(context, s);
    }
    took(context, t);
    enter_target(context, row.domain, c.ids_[row.targets.first]);
}

template <class D, class Context_, class... O>
inline void InterpretedMachine<D, Context_, O...>::restore(Context& context, std::size_t h) {
    const auto& c = *chart_;
    const auto kept = history_[h];
    if (kept == states::nowhere) perform(context, c.states_[h].initial_content);
    enter_target(context, c.states_[h].parent, kept == states::nowhere ? c.ids_[c.states_[h].initial.first] : kept);
}

// From below `domain` to a target, and on to where that begins.
template <class D, class Context_, class... O>
inline void InterpretedMachine<D, Context_, O...>::enter_target(Context& context, std::size_t domain,
                                                                std::size_t target) {
    const auto& c = *chart_;
    std::size_t from = domain;
    while (from != target) { // outermost first; depth is at most 256, a walk up for each costs nothing that matters
        std::size_t s = target;
        while (c.states_[s].parent != from) s = c.states_[s].parent;
        if (states::is_history(c.states_[s].kind)) return restore(context, s);
        enter_one(context, s);
        from = s;
    }
    enter_initial(context, target);
}

template <class D, class Context_, class... O>
inline void InterpretedMachine<D, Context_, O...>::enter_initial(Context& context, std::size_t s) {
    const auto& state = chart_->states_[s];
    if (state.initial.count == 0) {
        leaf_ = std::uint16_t(s);
        return;
    }
    perform(context, state.initial_content);
    enter_target(context, s, chart_->ids_[state.initial.first]);
}

} // namespace ansatz
