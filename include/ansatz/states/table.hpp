// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Table`: one row of cells a state, one cell an event, made while the description is compiled.
///
/// Where no transition has a guard and nothing is done, a cell is the next state: an event is one load. Otherwise a
/// cell is a pointer to the function that asks the guards of this state and event in turn, and takes the transition.
/// Use it for machines with many transitions; it is faster than Switch where they only change the state.
/// <!-- costs: states representation/changes: Table < Switch from 10 --> What it costs: 2 or
/// 16 bytes for every pair of state and event, and a call through a pointer, which the compiler cannot see through,
/// where anything is asked or done.

#include <ansatz/states/static_machine.hpp>

namespace ansatz {

/// Representation of a Machine: a table over state and event.
struct Table {
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
            if (index(event) >= M::event_count) return false;
            return look(machine, context, table[leaf_ * columns + index(event)]);
        }
        /// A condition that holds.
        bool on_condition(Machine& machine, Context& context) {
            return look(machine, context, table[leaf_ * columns + M::event_count]);
        }
        /// A transition without one.
        bool at_once(Machine& machine, Context& context) {
            return look(machine, context, table[leaf_ * columns + M::event_count + 1]);
        }
        bool for_leaf(Machine&, auto&& f) { // f with the innermost active state as a constant
            return states::detail::with_number<M::state_count>(leaf_, [&]<std::size_t S>() {
                if constexpr (M::is_leaf(S)) return f.template operator()<S>();
                else return false;
            });
        }

    private:
        // After the events: conditions, then transitions at once.
        static constexpr std::size_t columns = M::event_count + 2;
        static constexpr std::uint16_t none = 0xffff;
        static constexpr std::size_t what(std::size_t column) {
            return column < M::event_count ? column : column == M::event_count ? M::on_condition : M::at_once;
        }
        // A transition that changes the number of the state and does nothing else.
        static constexpr bool is_plain(std::size_t leaf, std::size_t t) {
            const auto& row = M::rows.transitions[t];
            if (row.guarded || Machine::keeps_time || Machine::performs(t) || row.target == states::nowhere)
                return false;
            const auto out = M::exits(leaf, row.domain);
            for (std::size_t i = 0; i < out.size; ++i)
                if (M::rows.states[out.at[i]].acts || has_history(out.at[i])) return false;
            const auto in = M::entries(row.domain, row.target);
            for (std::size_t i = 0; i < in.size; ++i)
                if (M::rows.states[in.at[i]].acts || M::rows.states[in.at[i]].kind != states::Kind::state) return false;
            return true;
        }
        static constexpr bool has_history(std::size_t s) {
            for (std::size_t i = s + 1; i < M::rows.states[s].end; ++i)
                if (M::parent(i) == s && states::is_history(M::rows.states[i].kind)) return true;
            return false;
        }
        static constexpr std::uint16_t lands_in(std::size_t t) {
            const auto in = M::entries(M::rows.transitions[t].domain, M::rows.transitions[t].target);
            return in.at[in.size - 1];
        }
        struct Target {
            std::uint16_t target = none;
        };
        struct Function {
            bool (*attempt)(Machine&, Context&) = nullptr;
        };
        // Whether some cell needs a function.
        static constexpr bool calls = [] {
            for (std::size_t s = 1; s < M::state_count; ++s)
                for (std::size_t c = 0; M::is_leaf(s) && c < columns; ++c)
                    if (const auto list = M::candidates(s, what(c));
                        list.size > 1 || (list.size == 1 && !is_plain(s, list.at[0])))
                        return true;
            return false;
        }();
        using Cell = std::conditional_t<calls, Function, Target>;
        [[gnu::always_inline]] bool look(Machine& machine, Context& context, const Cell& cell) {
            // Where anything acts every cell has a function: whether one has is what a processor cannot guess.
            if constexpr (calls) return cell.attempt(machine, context);
            else {
                if (cell.target == none) return false;
                leaf_ = cell.target;
                return true;
            }
        }

        static bool nothing(Machine&, Context&) { return false; }
        template <std::size_t Leaf, std::size_t What> static bool attempt(Machine& machine, Context& context) {
            constexpr const auto& list = M::template candidates_of<Leaf, What>;
            return [&]<std::size_t... I>(std::index_sequence<I...>) {
                return (machine.template attempt<Leaf, list.at[I]>(context) || ...);
            }(std::make_index_sequence<list.size>{});
        }
        using Cells = std::array<Cell, M::state_count * columns>;
        template <std::size_t Leaf, std::size_t Column> static constexpr void fill(Cells& cells) {
            constexpr const auto& list = M::template candidates_of<Leaf, what(Column)>;
            auto& cell = cells[Leaf * columns + Column];
            if constexpr (!calls && list.size == 1) cell.target = lands_in(list.at[0]);
            else if constexpr (list.size > 0) cell.attempt = &attempt<Leaf, what(Column)>;
        }
        template <std::size_t Leaf, std::size_t... E>
        static constexpr void fill_row(Cells& cells, std::index_sequence<E...>) {
            (fill<Leaf, M::template events_of<Leaf>.at[E]>(cells), ...);
            fill<Leaf, M::event_count>(cells);
            fill<Leaf, M::event_count + 1>(cells);
        }
        template <std::size_t S> static constexpr void fill_state(Cells& cells) {
            if constexpr (M::is_leaf(S)) fill_row<S>(cells, std::make_index_sequence<M::template events_of<S>.size>{});
        }
        template <std::size_t... S> static constexpr Cells make(std::index_sequence<S...>) {
            Cells cells{};
            if constexpr (calls)
                for (auto& cell : cells) cell.attempt = &nothing;
            (fill_state<S>(cells), ...);
            return cells;
        }
        static constexpr Cells table = make(std::make_index_sequence<M::state_count>{});

        std::uint16_t leaf_ = 0;
    };
};

} // namespace ansatz
