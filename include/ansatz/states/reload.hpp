// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How an interpreted machine goes on in another chart: `machine.reload(context, chart)` (notes 5.1, the interpreted
/// pattern). What has a name in both charts stays; what is gone is not left (its actions are gone too); what is new is
/// entered.

#include <ansatz/states/interpreted_machine.hpp>

namespace ansatz {

template <class D, class Context_, class... O>
Reloaded InterpretedMachine<D, Context_, O...>::take_over(const InterpretedMachine& before, Context& context) {
    const auto& c = *chart_;
    const auto& old = *before.chart_;
    const states::detail::Busy busy(busy_);
    std::vector<char> stays(c.state_count(), 0);
    std::vector<std::uint16_t> targets;
    bool all = true;
    for (std::size_t s = 1; s < old.state_count(); ++s) {
        const StateId now = c.find(old.name(StateId(s)));
        if (now == StateId::none) {
            all = all && !before.is_in(StateId(s));
            continue;
        }
        const auto& kept = old.states_[s];
        const auto& mine = c.states_[index(now)];
        if (before.is_in(StateId(s))) stays[index(now)] = 1, entered_[index(now)] = before.entered_[s];
        if (kept.behaviour != states::nowhere && mine.behaviour != states::nowhere &&
            before.owns_[kept.behaviour]->tag() == owns_[mine.behaviour]->tag())
            owns_[mine.behaviour] = before.owns_[kept.behaviour]->copy();
        if (kept.kind == mine.kind && states::is_history(kept.kind) &&
            old.states_[kept.parent].kind == c.states_[mine.parent].kind)
            keep_history(before, s, index(now));
    }
    // Each innermost active state, or the innermost around it that is still there.
    for (const StateId leaf : before.leaves()) {
        std::size_t s = index(leaf);
        while (s != 0 && (c.find(old.name(StateId(s))) == StateId::none ||
                          states::is_history(c.states_[index(c.find(old.name(StateId(s))))].kind)))
            s = old.states_[s].parent;
        if (s != 0) targets.push_back(std::uint16_t(c.find(old.name(StateId(s)))));
    }
    for_memories(context, true);
    std::size_t entered = 0;
    if (c.parallel_) {
        auto quiet = [&](std::size_t s) {
            entered += stays[s] ? 0 : 1;
            return stays[s] != 0;
        };
        if (targets.empty() || !regions_.go_to(*this, context, targets, quiet)) {
            regions_.forget();
            regions_.start(*this, context);
            entered = 1;
        }
    } else {
        std::vector<std::uint16_t> path;
        const std::size_t target = targets.empty() ? 0 : targets.front();
        for (std::size_t s = target; s != 0; s = c.states_[s].parent) path.push_back(std::uint16_t(s));
        for (std::size_t i = path.size(); i-- > 0;)
            if (!stays[path[i]]) enter_one(context, path[i]), ++entered;
        entered += c.states_[target].initial.count;
        enter_initial(context, target);
    }
    finish(context);
    return all && entered == 0 ? Reloaded::same_states : Reloaded::other_states;
}

/// What a history remembers, by names, where it is in its parent still and, for a deep one, innermost. Charts with
/// parallel states remember several for each history, all others one.
template <class D, class Context_, class... O>
void InterpretedMachine<D, Context_, O...>::keep_history(const InterpretedMachine& before, std::size_t was,
                                                         std::size_t now) {
    const auto& c = *chart_;
    const auto& old = *before.chart_;
    const auto& history = c.states_[now];
    const auto keep = [&](std::size_t remembered) {
        std::size_t s = history.parent;
        if (remembered == old.states_[was].parent) { // it was there alone
            if (!c.states_[s].childless) return;
        } else {
            s = index(c.find(old.name(StateId(remembered))));
            if (s >= c.state_count() || states::is_history(c.states_[s].kind)) return;
            const bool inside = history.kind == states::Kind::shallow_history
                                    ? c.states_[s].parent == history.parent
                                    : s > history.parent && s < c.states_[history.parent].end &&
                                          c.states_[s].initial.count == 0 &&
                                          c.states_[s].kind != states::Kind::parallel;
            if (!inside) return;
        }
        if (c.parallel_) regions_.remember(c, now, s);
        else if (history_[now] == states::nowhere) history_[now] = std::uint16_t(s); // of several, the first
    };
    if (old.parallel_) before.regions_.each_remembered(old, was, keep);
    else if (before.history_[was] != states::nowhere) keep(before.history_[was]);
    if (c.parallel_) regions_.check_history(c, now);
}

template <class D, class Context_, class... O>
Reloaded InterpretedMachine<D, Context_, O...>::reload(Context& context, SharedChart<Context> chart) {
    if (chart == nullptr) refuse(Refusal::invalid_argument, "Machine::reload: there is no chart");
    if (busy_)
        refuse(Refusal::invalid_argument,
               "Machine::reload: called from an action of the same machine; call it between two updates");
    InterpretedMachine next(*this);
    next.adopt(std::move(chart));
    if (!started()) {
        *this = std::move(next);
        return Reloaded::same_states;
    }
    const auto how = next.take_over(*this, context);
    *this = std::move(next);
    return how;
}

} // namespace ansatz
