// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The machine of the compile-time representations: a value that holds the present state, what states and guards
/// remember, and nothing that its description does not need. `Machine` is its name for users (machine.hpp).

#include <ansatz/states/core.hpp>
#include <ansatz/states/lasting.hpp>

namespace ansatz::states {

/// \tparam D  the description
/// \tparam R  Switch, StatePattern or Table
/// \tparam O  options, see options.hpp
template <class D, class R, class... O>
class StaticMachine : public Lasting<StaticMachine<D, R, O...>, typename D::Context> {
public:
    using Description = D;               ///< where it is described
    using Context = typename D::Context; ///< the user's
    using M = Model<D>;                  ///< its description, flattened
    using P = Parts<M>;                  ///< the types of its parts
    static_assert(!M::rows.parallel, "Ansatz: parallel states are for Interpreted: Machine<Description, Interpreted>");

    /// Needs the time of an update: it has after(...) or held_for(...).
    static constexpr bool needs_time = P::AllGuards::timed;

    using Opts = Options<O...>;                                     ///< all its options together
    static constexpr bool keeps_time = needs_time || Opts::watched; ///< knows its time()

    constexpr StaticMachine() = default;
    /// \param options  those that have a value to begin with; all of them, in the order of the type
    constexpr explicit StaticMachine(O... options)
        requires(sizeof...(O) > 0)
        : options_(options...) {}

    // ------------------------------------------------------------ driving it
    /// Enters the initial state, from the outside inwards. A machine that ran is left as it is, without exits, and
    /// begins anew: events that wait, as those behind an action that threw, and stuck() are forgotten.
    /// \throws std::invalid_argument from within an action; a copy that was taken there is still in it: copy outside
    void start(Context& context) {
        begin(context, [&] { enter_from<0, M::rows.states[0].initial>(context); });
    }
    using Lasting<StaticMachine, Context>::start;
    /// An event. Within an action of this machine it waits until the present transition is complete.
    /// \return whether a transition was taken (true for one that waits)
    /// \throws std::invalid_argument before start; with RefuseUnhandled, for an event that nobody handles
    [[gnu::always_inline]] bool handle(Context& context, EventId event) {
        return handle_as(context, event, [event] {
            return index(event) + 1 < M::event_count ? std::optional(name(event)) : std::nullopt;
        });
    }
    /// The same by name: for consoles and tests, since the name is looked up each time.
    bool handle(Context& context, std::string_view name) {
        return handle_as(context, event(name), [name] { return std::optional(name); });
    }

    /// One update of the fixed clock: guards that remember are updated, then the conditions of the active states are
    /// asked, inner states first, and the first that holds is taken (one an update); then what the active states do,
    /// outer states first.
    /// \param dt  s; may be left out where no guard and no state counts time
    /// \return whether a condition led to a transition
    /// \throws std::invalid_argument before start, and for a negative or non-finite dt, before anything changes
    bool update(Context& context, Parameter<unit::Time> dt) {
        if (!(dt.value() >= 0 && dt.value() <= std::numeric_limits<double>::max())) refuse_dt(dt);
        if (!started()) refuse_not_started();
        if constexpr (can_raise)
            if (busy_)
                refuse(Refusal::invalid_argument,
                       "Machine::update: called from an action of the same machine; raise an event instead");
        const detail::Busy busy(busy_);
        if constexpr (keeps_time) clock_.now += dt, clock_.dt = dt;
        sample_memories(context);
        const bool took = state_.on_condition(*this, context);
        if (took) finish(context);
        if constexpr (M::rows.acts) {
            state_.for_leaf(*this, [&]<std::size_t Leaf>() {
                behave<Leaf>(context, dt);
                return true;
            });
            finish(context);
        }
        return took;
    }
    /// The same where time is not counted.
    bool update(Context& context) {
        static_assert(!needs_time,
                      "Ansatz: this machine counts time (after, held_for); write machine.update(context, dt)");
        return update(context, Quantity<unit::Time>{});
    }
    using Lasting<StaticMachine, Context>::update;
    // ------------------------------------------------------------ what can be asked
    bool started() const { return state_.started(); }         ///< start was called
    StateId active() const { return StateId(state_.leaf()); } ///< the innermost active state
    /// The state or one inside it is active.
    bool is_in(StateId state) const { return started() && M::rows.contains(std::uint16_t(state), state_.leaf()); }
    bool is_in(std::string_view name) const { return is_in(state(name)); } ///< by name
    /// In a final state of the machine itself: nothing more will happen.
    bool done() const {
        return started() && M::rows.states[state_.leaf()].kind == Kind::final && M::parent(state_.leaf()) == 0;
    }
    /// Of the innermost active state.
    std::string_view active_name() const { return M::rows.states[state_.leaf()].name; }
    /// Since start.
    Quantity<unit::Time> time() const
        requires(keeps_time)
    {
        return clock_.now;
    }
    bool stuck() const { return was_stopped(); } ///< one call raised events without end and was stopped
    /// Raised, and no room for them.
    std::uint32_t dropped_events() const {
        if constexpr (can_raise) return queue_.dropped();
        else return 0;
    }
    template <class Option> const Option& get() const { return options_; } ///< one of its options
    template <class Option> Option& get() { return options_; }             ///< one of its options
    /// The data of a state that has a class, `machine.own<Patrol>("patrol")` being spelled
    /// `own<Patrol>(state("patrol"))`.
    template <class B> const B& own(StateId id) const {
        const B* found = nullptr;
        detail::with_number<M::state_count>(index(id), [&]<std::size_t S>() {
            if constexpr (std::is_same_v<typename P::template Behaviour<S>, B>)
                found = &const_cast<StaticMachine*>(this)->template own_of<S>();
            return true;
        });
        if (found == nullptr) refuse(Refusal::invalid_argument, "Machine::own: this state has no data of this class");
        return *found;
    }

    static constexpr std::size_t state_count() { return M::state_count; }           ///< with the root
    static constexpr std::size_t transition_count() { return M::transition_count; } ///< all
    static constexpr std::size_t event_count() { return M::event_count; }           ///< names, and one for all others
    /// Of a state; empty for StateId::none and what is no state.
    static constexpr std::string_view name(StateId id) {
        return index(id) < M::state_count ? M::rows.states[index(id)].name : std::string_view();
    }
    static constexpr std::string_view name(EventId id) { return M::event_name(index(id)); } ///< of an event
    /// The event of a name; of a name that no transition mentions, the event that only "*" takes.
    static constexpr EventId event(std::string_view name) { return EventId(M::find_event(name)); }
    /// The state of a name.
    /// \throws std::invalid_argument for a name that no state has
    static constexpr StateId state(std::string_view name) {
        const auto found = M::rows.find(name);
        if (found == nowhere)
            refuse(Refusal::invalid_argument, "Machine::state: there is no state \"" + std::string(name) + "\"");
        return StateId(found);
    }

    // ------------------------------------------------------------ for representations
    /// Takes the transition if its guard holds.
    template <std::size_t Leaf, std::size_t T> [[gnu::always_inline]] bool attempt(Context& context) {
        if constexpr (M::rows.transitions[T].guarded)
            if (!holds<T>(context)) return false;
        take<Leaf, T>(context);
        return true;
    }
    /// Whether a transition's guard holds.
    template <std::size_t T> [[gnu::always_inline]] bool holds(Context& context) {
        return guard_of<T>().ask(question<T>(context), detail::slot<T, typename P::template Memory<T>>(memories_));
    }
    /// Whether a transition does something beside changing the state.
    static constexpr bool performs(std::size_t t) { return M::rows.transitions[t].acts; }
    /// Leaves, does and enters what the transition says.
    template <std::size_t Leaf, std::size_t T> void take(Context& context) {
        constexpr auto row = M::rows.transitions[T];
        if constexpr (row.target == nowhere) perform<T>(context);
        else {
            constexpr auto out = M::exits(Leaf, row.domain);
            [&]<std::size_t... I>(std::index_sequence<I...>) {
                (exit < Shape::remembers_children(out.at[I]) ? Leaf : 0, out.at[I] > (context), ...);
            }(std::make_index_sequence<out.size>{});
            perform<T>(context);
            enter_from<row.domain, row.target>(context);
        }
    }
    /// The data of the state S: its class, or NoBehaviour.
    template <std::size_t S> auto& own_of() {
        if constexpr (R::owns_behaviours) return state_.template own_of<S>();
        else return detail::slot<S, typename P::template Behaviour<S>>(behaviours_);
    }

private:
    friend struct MachineArchive;
    friend class Lasting<StaticMachine, Context>;
    using Shape = detail::Shape<M>;
    static constexpr Kind kind_of(StateId s) { return M::rows.states[index(s)].kind; }
    Quantity<unit::Time> entered_at(std::size_t s) const { return clock_.entered[s]; }
    void start_in(Context& context, std::size_t s) {
        begin(context, [&] {
            detail::with_number<M::state_count>(s, [&]<std::size_t S>() {
                if constexpr (S > 0 && !is_history(M::rows.states[S].kind)) enter_from<0, S>(context);
                return true;
            });
        });
    }
    void begin(Context& context, auto&& enter) {
        if constexpr (can_raise) {
            if (busy_)
                refuse(Refusal::invalid_argument,
                       "Machine::start: called from an action of the same machine; raise an event instead");
            queue_ = {};
        }
        if constexpr (loops) stopped_ = false;
        const detail::Busy busy(busy_);
        state_.template set<0>(); // half entered is not started
        clock_ = {};
        if constexpr (M::rows.history) history_.fill(nowhere);
        begin_memories(context);
        enter();
        finish(context);
    }
    static constexpr bool can_raise = M::rows.acts || Shape::has_final;

    struct Clock {
        Quantity<unit::Time> now{}, dt{};
        std::array<Quantity<unit::Time>, M::state_count> entered{};
    };
    bool was_stopped() const {
        if constexpr (loops) return stopped_;
        else return false;
    }
    static constexpr bool loops = can_raise || M::has_automatic;

    template <std::size_t T> auto question(Context& context) {
        constexpr std::size_t source = M::rows.transitions[T].source;
        using Own = typename P::template Behaviour<source>;
        Question<Context, Own> q{context, own_of<source>(), {}, {}};
        if constexpr (keeps_time) q.in_state = clock_.now - clock_.entered[source], q.dt = clock_.dt;
        return q;
    }
    template <std::size_t T> static constexpr const auto& guard_of() {
        constexpr auto at = detail::places_in<detail::part_when, typename P::template TransitionNode<T>>;
        return std::get<at[0]>(std::get<T>(M::transition_nodes)->parts).guard;
    }
    void for_memories(auto&& f) {
        if constexpr (P::AllGuards::remember)
            [&]<std::size_t... T>(std::index_sequence<T...>) {
                (
                    [&] {
                        if constexpr (P::template remembers<T>)
                            f.template operator()<T>(guard_of<T>(),
                                                     detail::slot<T, typename P::template Memory<T>>(memories_));
                    }(),
                    ...);
            }(std::make_index_sequence<M::transition_count>{});
    }
    void begin_memories(Context& context) {
        for_memories(
            [&]<std::size_t T>(const auto& guard, auto& memory) { guard.begin(memory, question<T>(context)); });
    }
    void sample_memories(Context& context) {
        for_memories(
            [&]<std::size_t T>(const auto& guard, auto& memory) { guard.sample(memory, question<T>(context)); });
    }

    void tell(Happening::What what, std::size_t state, std::size_t transition = 0xffff, EventId event = EventId::none) {
        if constexpr (Opts::watched) options_.tell({what, StateId(state), TransitionId(transition), event, clock_.now});
    }
    EventQueue& queue() {
        if constexpr (can_raise) return queue_;
        else {
            static EventQueue none;
            return none;
        }
    }

    template <std::size_t T> void perform(Context& context) {
        tell(Happening::What::took, M::rows.transitions[T].source, T);
        if constexpr (performs(T))
            detail::each_part<detail::part_then>(*std::get<T>(M::transition_nodes), [&](const auto& then) {
                detail::act<M>(then.action, context, {}, queue());
            });
    }
    template <std::size_t Leaf, std::size_t S> void exit(Context& context) {
        constexpr auto& node = *std::get<S>(M::state_nodes);
        if constexpr (Shape::remembers_children(S)) remember<Leaf, S>();
        if constexpr (M::rows.states[S].acts) {
            detail::behave_exit(own_of<S>(), context, queue());
            detail::each_part<detail::part_exit>(
                node, [&](const auto& part) { detail::act<M>(part.action, context, {}, queue()); });
        }
        tell(Happening::What::exited, S);
    }
    template <std::size_t Leaf, std::size_t S> void remember() {
        static constexpr std::uint16_t child = Leaf == S ? std::uint16_t(S) : M::child_towards(S, Leaf);
        for (std::size_t h = S + 1; h < M::rows.states[S].end; ++h)
            if (is_history(M::rows.states[h].kind) && M::parent(h) == S)
                history_[h] = M::rows.states[h].kind == Kind::deep_history ? std::uint16_t(Leaf) : child;
    }
    template <std::size_t S> void enter(Context& context) {
        constexpr auto& node = *std::get<S>(M::state_nodes);
        if constexpr (keeps_time) clock_.entered[S] = clock_.now;
        if constexpr (M::rows.states[S].acts) {
            detail::each_part<detail::part_entry>(
                node, [&](const auto& part) { detail::act<M>(part.action, context, {}, queue()); });
            detail::behave_enter(own_of<S>(), context, queue());
        }
        tell(Happening::What::entered, S);
        if constexpr (M::rows.states[S].kind == Kind::final && M::parent(S) != 0)
            queue_.raise(EventId(Shape::template done_event<M::parent(S)>));
    }
    // Enters all from below Domain to Target and on to a leaf.
    template <std::size_t Domain, std::size_t Target> void enter_from(Context& context) {
        constexpr auto in = M::entries(Domain, Target);
        constexpr std::size_t last = in.size == 0 ? Target : in.at[in.size - 1];
        constexpr bool restores = is_history(M::rows.states[last].kind);
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (enter<in.at[I]>(context), ...);
        }(std::make_index_sequence<in.size - (restores ? 1 : 0)>{});
        if constexpr (restores) restore<last>(context);
        else state_.template set<last>();
    }
    template <std::size_t H> void restore(Context& context) {
        const std::size_t kept = history_[H];
        if (kept == nowhere) enter_from<M::parent(H), M::rows.states[H].initial>(context);
        else restore_one<H>(context, kept, std::make_index_sequence<Shape::template holdable<H>.size>{});
    }
    template <std::size_t H, std::size_t... I>
    void restore_one(Context& context, std::size_t kept, std::index_sequence<I...>) {
        constexpr auto& all = Shape::template holdable<H>;
        (void)((kept == all.at[I] && (enter_from<M::parent(H), all.at[I]>(context), true)) || ...);
    }

    template <std::size_t Leaf> void behave(Context& context, Quantity<unit::Time> dt) {
        constexpr auto chain = M::exits(Leaf, 0);
        auto one = [&]<std::size_t S>() {
            if constexpr (M::rows.states[S].acts) {
                detail::each_part<detail::part_each>(*std::get<S>(M::state_nodes), [&](const auto& part) {
                    detail::act<M>(part.action, context, dt, queue());
                });
                detail::behave_update(own_of<S>(), context, dt, queue());
            }
        };
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (one.template operator()<chain.at[chain.size - 1 - I]>(), ...);
        }(std::make_index_sequence<chain.size>{});
    }

    // An event, and how it is called if it must be refused.
    [[gnu::always_inline]] bool handle_as(Context& context, EventId event, auto&& called) {
        if constexpr (can_raise)
            if (busy_) [[unlikely]]
                return queue_.raise(event);
        const detail::Busy busy(busy_);
        if (!state_.on_event(*this, context, event)) {
            unhandled(event, called);
            return false;
        }
        finish(context);
        return true;
    }
    [[gnu::always_inline]] void finish(Context& context) {
        if constexpr (loops) {
            if constexpr (!M::has_automatic)
                if (queue_.empty()) [[likely]]
                    return;
            settle_loop(context);
        }
    }
    [[gnu::noinline]] void settle_loop(Context& context) {
        for (std::uint32_t n = 0; n < detail::most_steps; ++n) {
            if constexpr (M::has_automatic)
                if (state_.at_once(*this, context)) continue;
            if constexpr (can_raise) {
                if (queue_.empty()) return;
                const EventId next = queue_.take();
                if (!state_.on_event(*this, context, next)) tell_unhandled(next);
            } else return;
        }
        stopped_ = true;
        if constexpr (can_raise)
            while (!queue_.empty()) queue_.take();
    }
    void tell_unhandled([[maybe_unused]] EventId event) {
        if constexpr (Opts::watched) tell(Happening::What::unhandled, state_.leaf(), 0xffff, event);
    }
    void unhandled(EventId event, [[maybe_unused]] auto&& called) {
        if (!started()) refuse_not_started();
        if constexpr (Opts::refuses) refuse_event(called(), active_name());
        tell_unhandled(event);
    }

    using Stored = typename R::template In<StaticMachine, M>;
    Stored state_{};
    [[no_unique_address]] std::conditional_t<can_raise, detail::Flag, detail::Slot<5, detail::Absent>> busy_{};
    [[no_unique_address]] std::conditional_t<loops, bool, detail::Slot<0, detail::Absent>> stopped_{};
    [[no_unique_address]] std::conditional_t<M::rows.history, std::array<std::uint16_t, M::state_count>,
                                             detail::Slot<4, detail::Absent>>
        history_{};
    [[no_unique_address]] std::conditional_t<R::owns_behaviours, detail::Slot<1, detail::Absent>,
                                             typename P::Behaviours>
        behaviours_{};
    [[no_unique_address]] typename P::AllGuards::Memories memories_{};
    [[no_unique_address]] std::conditional_t<can_raise, EventQueue, detail::Slot<2, detail::Absent>> queue_{};
    [[no_unique_address]] std::conditional_t<keeps_time, Clock, detail::Slot<3, detail::Absent>> clock_{};
    [[no_unique_address]] Opts options_{};
};

} // namespace ansatz::states
