// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ByMachine`: a plan is carried out by a state machine of chapter 5, whose states are the actions (notes 6.2, 5).
///
/// ```
/// goap::Domain<> woods;                                    // actions "fell tree", "light fire", ...
/// states::machine(transition(on("fell_tree"), to("fell tree")),   // on the machine itself: from wherever it is
///                 transition(on("light_fire"), to("light fire")),
///                 state("idle"),
///                 state("fell tree", each_update(strike), transition(when(slips), to("hurt")),
///                       transition(when(falls), then(fell), to("done"))),
///                 state("light fire", ...), state("done"), state("hurt"));
/// Machine<Woodcutter, Switch> machine;
/// machine.start(man);
/// goap::ByMachine crew{machine, man, woods, 1.0 / 60 * second};
/// while (goap::perform(runner, crew, performance, [&] { return man.sees; })) next_tick();
/// ```
/// The planner decides what is done next, the machine how: an action may take time, have states inside it, be
/// interrupted. Take a `Performer` of your own where an action is a single call. What the actions make of the world is
/// the machine's business too: the plan's effects are what is expected, not what is done.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/goap/perform.hpp>
#include <ansatz/states/ids.hpp>
#include <ansatz/units/describe.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz::goap {

/// A machine that a plan can run through: any `Machine` of chapter 5, in any representation.
template <class M>
concept PlayedMachine =
    requires(M& machine, typename M::Context& context, EventId event_id, StateId state_id, std::string_view name) {
        { machine.handle(context, event_id) } -> std::same_as<bool>;
        machine.update(context, Quantity<unit::Time>{});
        { machine.is_in(state_id) } -> std::same_as<bool>;
        { machine.state_count() } -> std::convertible_to<std::size_t>;
        { machine.name(state_id) } -> std::convertible_to<std::string_view>;
        { machine.name(event_id) } -> std::convertible_to<std::string_view>;
        { machine.event(name) } -> std::same_as<EventId>;
    };

/// A `Performer` whose actions are states of a machine.
///
/// - The state of an action has the action's name; its event has it too, with `_` for every space, since a space
///   separates the events of a transition: "fell tree" is the state, "fell_tree" the event.
/// - Beginning an action is its event. It must be taken wherever the machine may stand: after an action, and in the
///   midst of one that a new plan gives up. A guard on it may refuse; then the action has failed.
/// - A tick is one update. In the action's state, or one inside it, the action is going on; in the state "done" it is
///   done; anywhere else it has failed, whether that state is called "hurt", "out of matches" or "flees".
///
/// An action that is over at once, a state with a transition without a condition, is done in the tick in which it was
/// begun. The event's transition must lead to the action's state: one that only acts would be taken for it in "done".
///
/// Not provided: the machine is left where it is when there is nothing more to do, and is updated only by ticks. It is
/// yours; send it an event, and update it, as you like.
/// \tparam M  a Machine
template <class M> class ByMachine {
    static_assert(PlayedMachine<M>, "Ansatz: ByMachine plays a Machine of chapter 5, e.g. Machine<Woodcutter, Switch>");

public:
    using Context = typename M::Context; ///< what its guards and actions are given

    /// Looks the actions up, once: make it anew after an action was added, or a chart was loaded again.
    /// \param machine  used, not copied; to be started before the first tick
    /// \param context  what the machine works on; used, not copied
    /// \param domain   whose actions are the machine's states
    /// \param dt       s, of the update that a tick is
    /// \param done     the name of the state that means that an action is done
    /// \throws std::invalid_argument for an action without its state or event, for a machine without the state `done`,
    ///         and for a dt that is negative or not finite
    template <std::size_t Words>
    ByMachine(M& machine, Context& context, const Domain<Words>& domain, Parameter<unit::Time> dt,
              std::string_view done = "done")
        : machine_(&machine), context_(&context), dt_(dt), done_(find(done)) {
        if (!std::isfinite(dt.value()) || dt.value() < 0)
            refuse_value("goap::ByMachine", "dt", dt, "the time of a tick is finite and not negative");
        if (done_ == StateId::none)
            refuse_value("goap::ByMachine", quoted(done), "no state of the machine",
                         "actions end in it; add state(" + quoted(done) + "), or give the name of the one that it is");
        for (Action a = 0; a < domain.actions(); ++a) steps_.push_back(step_of(domain.name_of(a)));
    }

    /// Sends the machine the action's event.
    /// \throws std::invalid_argument for an action that was not in the domain; what the machine throws, with
    ///         RefuseUnhandled or before start
    void begin(Action a) {
        require(a);
        begun_ = false; // also when handle throws
        begun_ = machine_->handle(*context_, steps_[a].begins);
    }
    /// The action was begun before, by one whose machine was saved and is loaded: it goes on. See goap/save.hpp.
    /// \throws std::invalid_argument for an action that was not in the domain
    void resume(Action a) {
        require(a);
        begun_ = true;
    }
    /// Updates the machine once and reads from its state how the action goes.
    /// \throws std::invalid_argument for an action that was not in the domain; what the machine throws
    Progress tick(Action a) {
        require(a);
        machine_->update(*context_, dt_); // also where it refused the action: it may be busy with what made it refuse
        // A machine that refuses an action may still stand in "done", from the one before.
        if (!begun_) return Progress::failed;
        if (machine_->is_in(done_)) return Progress::done;
        return machine_->is_in(steps_[a].state) ? Progress::going : Progress::failed;
    }
    /// The machine that performs.
    const M& machine() const { return *machine_; }

private:
    struct Step {
        EventId begins;
        StateId state;
    };

    static std::string quoted(std::string_view name) { return "\"" + std::string(name) + "\""; }
    StateId find(std::string_view name) const {
        for (std::size_t s = 1; s < machine_->state_count(); ++s)
            if (machine_->name(StateId(s)) == name) return StateId(s);
        return StateId::none;
    }
    Step step_of(const std::string& action) const {
        std::string called = action;
        std::replace(called.begin(), called.end(), ' ', '_');
        const StateId state = find(action);
        if (state == StateId::none)
            refuse_value("goap::ByMachine", "the action " + quoted(action), "no state of the machine",
                         "add state(" + quoted(action) + ", ...)");
        const EventId begins = machine_->event(called);
        if (machine_->name(begins) != called)
            refuse_value("goap::ByMachine", "the event " + quoted(called), "not mentioned by the machine",
                         "add transition(on(" + quoted(called) + "), to(" + quoted(action) + "))");
        return {begins, state};
    }
    void require(Action a) const {
        if (a >= steps_.size())
            refuse_value("goap::ByMachine", "the action", std::to_string(a),
                         "the domain had " + std::to_string(steps_.size()) +
                             " when this was made; make it after the last action");
    }

    M* machine_;
    Context* context_;
    Quantity<unit::Time> dt_;
    StateId done_;
    std::vector<Step> steps_;
    bool begun_ = false;
};

} // namespace ansatz::goap
