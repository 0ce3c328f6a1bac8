// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What all machines that last have in common: they begin in any state that is asked for, and know for how long they
/// have been in a state. A base of every Machine.

#include <ansatz/states/ids.hpp>

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ansatz::states {

/// \tparam Machine  the machine, of which this is a base
/// \tparam Context  the user's
template <class Machine, class Context> class Lasting {
public:
    /// Enters a state of your choice, from the outside inwards, and the initial states in it: for a test, a checkpoint,
    /// a character that is met asleep. Otherwise the same as start(context).
    /// \throws std::invalid_argument for the machine itself, a history, or what is no state; nothing is changed
    void start(Context& context, StateId state) {
        auto& machine = static_cast<Machine&>(*this);
        if (index(state) >= machine.state_count() || state == StateId::root || is_history(machine.kind_of(state)))
            refuse(Refusal::invalid_argument,
                   "Machine::start: " +
                       (index(state) < machine.state_count() && state != StateId::root
                            ? "\"" + std::string(machine.name(state)) + "\" is a history"
                            : "the number " + std::to_string(index(state)) + " names no state inside the machine") +
                       "; it can begin in a state that it can be in");
        machine.start_in(context, index(state));
    }
    /// The same by name.
    /// \throws std::invalid_argument for a name that no state has, too
    void start(Context& context, std::string_view state) {
        start(context, static_cast<const Machine&>(*this).state(state));
    }
    /// The names of all active states, outer ones first; empty before start.
    std::vector<std::string> active_names() const {
        const auto& machine = static_cast<const Machine&>(*this);
        std::vector<std::string> names;
        for (std::size_t s = 1; s < machine.state_count(); ++s)
            if (machine.is_in(StateId(s))) names.emplace_back(machine.name(StateId(s)));
        return names;
    }
    /// Seconds without their unit.
    template <class Number>
        requires(std::is_arithmetic_v<Number>)
    bool update(Context&, Number) {
        static_assert(ansatz::detail::never<Number>,
                      "Ansatz: update takes the time of a step; write e.g. machine.update(npc, 1.0 / 60 * second)");
        return false;
    }
    /// Transitions are added to a machine that is interpreted: additions.hpp.
    template <class M = Machine> void add(Context&, const auto&, const auto&, auto&&...) {
        static_assert(ansatz::detail::never<M>,
                      "Ansatz: Switch, StatePattern and Table have the transitions of their "
                      "description; take Machine<..., Interpreted> to add some while it runs");
    }
    /// For how long a state has been active, s; none where it is not. Known to machines that keep the time.
    Quantity<unit::Time> time_in(StateId state) const {
        const auto& machine = static_cast<const Machine&>(*this);
        static_assert(Machine::keeps_time, "Ansatz: this machine counts no time; it does with a guard of time (after, "
                                           "held_for) or a watcher, such as Recorded<>");
        return machine.is_in(state) ? machine.time() - machine.entered_at(index(state)) : Quantity<unit::Time>{};
    }
    /// The same by name.
    /// \throws std::invalid_argument for a name that no state has
    Quantity<unit::Time> time_in(std::string_view state) const {
        return time_in(static_cast<const Machine&>(*this).state(state));
    }
};

} // namespace ansatz::states
