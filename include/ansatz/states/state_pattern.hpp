// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StatePattern`: the hard coded state pattern of the notes (5.1), generated from the description.
///
/// Every state is an object of a class of its own, derived from a base class `State`; it holds the data of that state
/// and answers events through virtual functions. The machine holds a pointer to the present one. It reduces complexity
/// where each state has much of its own to do; a virtual call for each event is the price.

#include <ansatz/states/static_machine.hpp>

namespace ansatz {

/// Representation of a Machine: a class a state, virtual functions.
struct StatePattern {
    static constexpr bool owns_behaviours = true; ///< it keeps the data of state classes itself

    /// What it keeps: an object of each state, and a pointer to the present one.
    template <class Machine, class M> class In {
    public:
        using Context = typename M::Context;

        /// The base class of all states.
        class State {
        public:
            virtual bool on_event(Machine&, Context&, std::size_t) const { return false; } ///< an event
            virtual bool on_condition(Machine&, Context&) const { return false; } ///< the conditions of an update
            virtual bool at_once(Machine&, Context&) const { return false; } ///< what happens as soon as it is entered
            virtual std::uint16_t number() const { return 0; }               ///< its own
        protected:
            ~State() = default; // no state is owned by its base
        };

        In() { current_ = &before_; }
        In(const In& other) : before_(), objects_(other.objects_) { point_to(other.leaf()); }
        // NOLINTNEXTLINE(bugprone-unhandled-self-assignment): it does no harm here
        In& operator=(const In& other) {
            objects_ = other.objects_;
            point_to(other.leaf());
            return *this;
        }

        std::uint16_t leaf() const { return current_->number(); } ///< 0 before start
        bool started() const { return current_ != &before_; }     ///< it is in a state
        template <std::size_t S> void set() {                     ///< the state is S from now on, or none: 0
            if constexpr (S > 0) current_ = &object<S>();
            else current_ = &before_;
        }
        template <std::size_t S> auto& own_of() { return object<S>().own; } ///< the data of a state

        /// A transition for the event.
        [[gnu::always_inline]] bool on_event(Machine& machine, Context& context, EventId event) {
            return current_->on_event(machine, context, index(event));
        }
        /// A condition that holds.
        bool on_condition(Machine& machine, Context& context) { return current_->on_condition(machine, context); }
        /// A transition without one.
        bool at_once(Machine& machine, Context& context) { return current_->at_once(machine, context); }
        bool for_leaf(Machine&, auto&& f) { // f with the innermost active state as a constant
            return states::detail::with_number<M::state_count>(leaf(), [&]<std::size_t S>() {
                if constexpr (M::is_leaf(S)) return f.template operator()<S>();
                else return false;
            });
        }

    private:
        template <std::size_t S> using Own = typename states::Parts<M>::template Behaviour<S>;

        template <std::size_t S> class Concrete final : public State {
        public:
            Own<S> own{};
            bool on_event(Machine& machine, Context& context, std::size_t event) const override {
                if constexpr (M::is_leaf(S)) return events(machine, context, event);
                else return false;
            }
            bool on_condition(Machine& machine, Context& context) const override {
                return try_all<M::on_condition>(machine, context);
            }
            bool at_once(Machine& machine, Context& context) const override {
                return try_all<M::at_once>(machine, context);
            }
            std::uint16_t number() const override { return S; }

        private:
            template <std::size_t What> [[gnu::always_inline]] static bool try_all(Machine& machine, Context& context) {
                if constexpr (M::is_leaf(S)) {
                    constexpr const auto& list = M::template candidates_of<S, What>;
                    return [&]<std::size_t... I>(std::index_sequence<I...>) {
                        return (machine.template attempt<S, list.at[I]>(context) || ...);
                    }(std::make_index_sequence<list.size>{});
                } else return false;
            }
            static bool events(Machine& machine, Context& context, std::size_t event) {
                return states::detail::switch_over<M, S>(event,
                                                         [&]<std::size_t E>() { return try_all<E>(machine, context); });
            }
        };

        template <class S> struct All;
        template <std::size_t... S> struct All<std::index_sequence<S...>> {
            using type = std::tuple<Concrete<S>...>;
        };
        template <std::size_t S> Concrete<S>& object() { return std::get<S>(objects_); }
        void point_to(std::size_t leaf) {
            current_ = &before_;
            states::detail::with_number<M::state_count>(leaf, [&]<std::size_t S>() {
                if constexpr (S > 0) current_ = &object<S>();
                return true;
            });
        }

        class Before final : public State {};
        Before before_; // in no state yet
        typename All<std::make_index_sequence<M::state_count>>::type objects_;
        State* current_;
    };
};

} // namespace ansatz
