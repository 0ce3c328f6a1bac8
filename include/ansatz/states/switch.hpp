// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Switch`: the hard coded switch of the notes (5.1), generated from the description.
///
/// The state is a number; one conditional structure, first over the states, then over the events of each, holds
/// everything, and the compiler sees through all of it. Simple and efficient for a small machine. What it costs: code
/// for every pair of a state and a transition that it can take, so a large hierarchy compiles slowly; Table is smaller.

#include <ansatz/states/static_machine.hpp>

namespace ansatz {

/// Representation of a Machine: nested switches over state and event.
struct Switch {
    static constexpr bool owns_behaviours = false; ///< the machine keeps the data of state classes

    /// What it keeps: the number of the innermost active state.
    template <class Machine, class M> class In {
    public:
        using Context = typename M::Context;
        std::uint16_t leaf() const { return leaf_; }       ///< 0 before start
        bool started() const { return leaf_ != 0; }        ///< it is in a state
        template <std::size_t S> void set() { leaf_ = S; } ///< the state is S from now on, or none: 0

        [[gnu::always_inline]] bool on_event(Machine& machine, Context& context,
                                             EventId event) { // a transition for the event
            return for_leaf(machine, [&]<std::size_t Leaf>() {
                return states::detail::switch_over<M, Leaf>(
                    index(event), [&]<std::size_t E>() { return try_all<Leaf, E>(machine, context); });
            });
        }
        /// A condition that holds.
        bool on_condition(Machine& machine, Context& context) { return without<M::on_condition>(machine, context); }
        /// A transition without one.
        bool at_once(Machine& machine, Context& context) { return without<M::at_once>(machine, context); }
        [[gnu::always_inline]] bool for_leaf(Machine&, auto&& f) { // f with the innermost active state as a constant
            return states::detail::with_number<M::state_count>(leaf_, [&]<std::size_t S>() {
                if constexpr (M::is_leaf(S)) return f.template operator()<S>();
                else return false;
            });
        }

    private:
        template <std::size_t Leaf, std::size_t What>
        [[gnu::always_inline]] static bool try_all(Machine& machine, Context& context) {
            constexpr const auto& list = M::template candidates_of<Leaf, What>;
            return [&]<std::size_t... I>(std::index_sequence<I...>) {
                return (machine.template attempt<Leaf, list.at[I]>(context) || ...);
            }(std::make_index_sequence<list.size>{});
        }
        template <std::size_t What> bool without(Machine& machine, Context& context) {
            return for_leaf(machine, [&]<std::size_t Leaf>() { return try_all<Leaf, What>(machine, context); });
        }
        std::uint16_t leaf_ = 0;
    };
};

} // namespace ansatz
