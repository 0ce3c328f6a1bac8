// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `perform`: how a plan is carried out, one tick of the game at a time. Whatever can begin an action and say
/// how it goes is a `Performer`: a function of yours, an animation, a state machine whose states are named after the
/// actions.

#include <ansatz/paths/goap/runner.hpp>

#include <concepts>
#include <optional>

namespace ansatz::goap {

/// How an action goes.
enum class Progress {
    going,  ///< it takes longer
    done,   ///< it is finished
    failed, ///< it cannot be finished
};

/// What can begin an action, and be asked each tick how it goes.
template <class P>
concept Performer = requires(P& p, Action a) {
    p.begin(a);
    { p.tick(a) } -> std::same_as<Progress>;
};

/// What a plan is doing, between ticks.
struct Performance {
    std::optional<Action> begun; ///< the action that was begun and has not ended
};

/// One tick: checks whether the plan still holds, begins the action that is due unless it is being done already, and
/// asks how it goes. An action goes on when there is another plan that begins with it.
/// \param state_of a function that answers with the state of the world at this moment; it is asked again behind the
/// action
/// \return whether there is anything left to do
template <class Planner, class Memory, Performer P, class StateOf>
bool perform(Runner<Planner, Memory>& runner, P& performer, Performance& performance, StateOf&& state_of) {
    runner.look(state_of());
    const auto due = runner.action();
    if (!due) {
        performance.begun.reset();
        return false;
    }
    if (performance.begun != due) { // by another plan it may be another: what was begun is given up
        performer.begin(*due);
        performance.begun = due;
    }
    switch (performer.tick(*due)) {
    case Progress::going: return true;
    case Progress::done: runner.done(state_of()); break;
    case Progress::failed: runner.failed(state_of()); break;
    }
    performance.begun.reset();
    return runner.action().has_value();
}
/// The same of a runner that remembers what failed.
/// \param dt of the tick, s
template <class Planner, class Memory, Performer P, class StateOf>
bool perform(Runner<Planner, Memory>& runner, P& performer, Performance& performance, StateOf&& state_of,
             Parameter<unit::Time> dt) {
    runner.pass(dt);
    return perform(runner, performer, performance, state_of);
}

} // namespace ansatz::goap
