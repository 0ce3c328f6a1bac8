// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The words in which a machine is described, once, for every representation.
///
/// ```cpp
/// struct GuardNpc {
///     using Context = Npc;
///     static constexpr auto machine = states::machine(
///         state("patrol", behaves<Walk>("Walk"),
///               transition(when("sees", [](const Npc& n) { return n.distance < 8.0 * metre; }), to("chase"))),
///         state("chase", on_entry("shout", shout),
///               transition(on("lost"), to("patrol")),
///               transition(when(value("distance", &Npc::distance) < 1.0 * metre), then("hit", hit), to("chase"))));
/// };
/// ```
///
/// A transition with `on` happens on an event; one with `when` and no `on` is a condition, asked at every update; one
/// with neither is taken as soon as its state is entered. States stand in states; the first is the one that is entered,
/// unless `initial` names another. All parts of a state or a transition may stand in any order, transitions among each
/// other excepted: the first one whose guard holds is taken. The description costs nothing at run time.

#include <ansatz/states/crossing.hpp>
#include <ansatz/states/dwell.hpp>
#include <ansatz/states/hysteresis.hpp>
#include <ansatz/states/queue.hpp>

#include <array>
#include <tuple>

namespace ansatz::states {

/// The events of a transition: names, or beginnings of names.
struct On {
    std::string_view events; ///< separated by blanks; "*" for every event
};
/// Where a transition goes.
struct To {
    std::string_view state; ///< its name
};
/// Where a state begins.
struct Initial {
    std::string_view state; ///< its name
};
/// A state that is entered without any of the states in it.
struct NoInitial {};
/// A transition that does not leave its source when it goes to a state inside it.
struct Internal {};
/// The guard of a transition.
template <class G> struct When {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    G guard;                 ///< what is asked
};
/// What a transition does.
template <class F> struct Then {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    F action;                ///< a function, or Raised
};
/// What is done when a state is entered.
template <class F> struct OnEntry {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    F action;                ///< a function, or Raised
};
/// What is done when a state is left.
template <class F> struct OnExit {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    F action;                ///< a function, or Raised
};
/// What is done at every update in which a state is active.
template <class F> struct Each {
    std::string_view called; ///< its name in files and pictures; empty: it has none
    F action;                ///< a function, or Raised
};
/// A class that holds a state's behaviour and data.
template <class B> struct Behaves {
    std::string_view called; ///< its name in files and pictures; empty: it has none
};
/// A transition.
template <class... P> struct Transition {
    std::tuple<P...> parts; ///< On, When, Then, To, Internal, in any order
};
/// A state, with what is in it.
template <class... P> struct State {
    std::string_view name;  ///< its name, unique in the machine; empty for the machine itself
    Kind kind;              ///< a place to be, final, parallel, or a history
    std::tuple<P...> parts; ///< transitions, states, actions, in the order in which they were written
};

/// An action that raises an event: it is handled when the present transition is complete, before `handle` or `update`
/// returns.
struct Raised {
    std::string_view event; ///< its name
};

/// The names of the events that a transition takes: "alarm", or several, "alarm noise". A name stands for all that
/// begin with it and a dot ("lost" takes "lost.sight"), "*" for every event.
constexpr On on(std::string_view events) { return {events}; }
/// The state that a transition goes to; without it the machine stays where it is and nothing is left or entered.
constexpr To to(std::string_view state) { return {state}; }
/// The state inside this one that is entered with it; the first one by default.
constexpr Initial initial(std::string_view state) { return {state}; }
/// The state is entered alone, and is the innermost one until a transition goes to a state in it. Only where the
/// machine allows that, with the option AllowChildless.
constexpr NoInitial no_initial() { return {}; }
/// A transition to a state inside its source leaves the source and enters it again, unless this is among its parts.
constexpr Internal internal() { return {}; }

/// A guard: a function of the context, or one of the library's guards.
template <class F> constexpr auto when(F guard) {
    if constexpr (std::derived_from<F, GuardBase>) return When<F>{{}, guard};
    else return When<Asked<F>>{{}, {{}, guard}};
}
/// The same with a name, by which a file calls it.
template <class F> constexpr auto when(std::string_view name, F guard) {
    if constexpr (std::derived_from<F, GuardBase>) return When<F>{name, guard};
    else return When<Asked<F>>{name, {name, guard}};
}
/// An action: a function of the context, or of the context and an EventQueue& in which it raises events.
template <class F> constexpr Then<F> then(F action) { return {{}, action}; }
/// The same with a name, by which a file calls it.
template <class F> constexpr Then<F> then(std::string_view name, F action) { return {name, action}; }
/// When the state is entered.
template <class F> constexpr OnEntry<F> on_entry(F action) { return {{}, action}; }
/// The same with a name.
template <class F> constexpr OnEntry<F> on_entry(std::string_view name, F action) { return {name, action}; }
/// When the state is left.
template <class F> constexpr OnExit<F> on_exit(F action) { return {{}, action}; }
/// The same with a name.
template <class F> constexpr OnExit<F> on_exit(std::string_view name, F action) { return {name, action}; }
/// At every update, after the conditions.
template <class F> constexpr Each<F> each_update(F action) { return {{}, action}; }
/// The same with a name.
template <class F> constexpr Each<F> each_update(std::string_view name, F action) { return {name, action}; }
/// The action that raises an event, for then, on_entry, on_exit and each_update.
constexpr Raised raise(std::string_view event) { return {event}; }

/// A state class: any of `enter(Context&)`, `update(Context&)` or `update(Context&, Quantity<unit::Time>)`,
/// `exit(Context&)`, each also with an EventQueue& at the end, and its own data, which the machine keeps in every
/// representation.
template <class B> constexpr Behaves<B> behaves(std::string_view name = {}) { return {name}; }

/// A transition of the state it stands in.
template <class... P> constexpr Transition<P...> transition(P... parts) { return {{parts...}}; }
/// A state.
template <class... P> constexpr State<P...> state(std::string_view name, P... parts) {
    return {name, Kind::state, {parts...}};
}
/// Its parent is done: raises "done.state.<parent>".
template <class... P> constexpr State<P...> final_state(std::string_view name, P... parts) {
    return {name, Kind::final, {parts...}};
}
/// Where its parent was when it was left last: the state directly in it (shallow_history) or the innermost one
/// (deep_history).
/// \param parts  `to("...")`: where to go the first time
template <class... P> constexpr State<P...> shallow_history(std::string_view name, P... parts) {
    return {name, Kind::shallow_history, {parts...}};
}
/// The innermost one.
template <class... P> constexpr State<P...> deep_history(std::string_view name, P... parts) {
    return {name, Kind::deep_history, {parts...}};
}
/// All states in it at once; only Interpreted.
template <class... P> constexpr State<P...> parallel(std::string_view name, P... parts) {
    return {name, Kind::parallel, {parts...}};
}
/// The machine: its states, and `initial` where it is not the first.
template <class... P> constexpr State<P...> machine(P... parts) { return {"", Kind::state, {parts...}}; }

namespace detail {

template <class T> struct PartTraits {
    static constexpr int what = 0;
};
template <> struct PartTraits<On> {
    static constexpr int what = 1;
};
template <> struct PartTraits<To> {
    static constexpr int what = 2;
};
template <> struct PartTraits<Initial> {
    static constexpr int what = 3;
};
template <> struct PartTraits<Internal> {
    static constexpr int what = 4;
};
template <class G> struct PartTraits<When<G>> {
    static constexpr int what = 5;
};
template <class F> struct PartTraits<Then<F>> {
    static constexpr int what = 6;
};
template <class F> struct PartTraits<OnEntry<F>> {
    static constexpr int what = 7;
};
template <class F> struct PartTraits<OnExit<F>> {
    static constexpr int what = 8;
};
template <class F> struct PartTraits<Each<F>> {
    static constexpr int what = 9;
};
template <class B> struct PartTraits<Behaves<B>> {
    static constexpr int what = 10;
    using Class = B;
};
template <class... P> struct PartTraits<Transition<P...>> {
    static constexpr int what = 11;
};
template <class... P> struct PartTraits<State<P...>> {
    static constexpr int what = 12;
};

template <> struct PartTraits<NoInitial> {
    static constexpr int what = 13;
};

enum Part {
    part_on = 1,
    part_to,
    part_initial,
    part_internal,
    part_when,
    part_then,
    part_entry,
    part_exit,
    part_each,
    part_behaves,
    part_transition,
    part_state,
    part_no_initial
};

template <class P> inline constexpr int part_of = PartTraits<std::remove_cvref_t<P>>::what;

/// Where the parts of one sort stand.
template <int What, class... P> constexpr auto places(const std::tuple<P...>*) {
    constexpr std::size_t count = (std::size_t(part_of<P> == What) + ... + 0);
    std::array<std::size_t, count> found{};
    [[maybe_unused]] std::size_t next = 0, at = 0;
    ((part_of<P> == What ? void(found[next++] = at) : void(), ++at), ...);
    return found;
}
template <int What, class Node>
inline constexpr auto places_in = places<What>(static_cast<const decltype(Node::parts)*>(nullptr));

/// Calls f with each part of one sort. Nothing is made of the others: a machine has many parts, and few of any sort.
template <int What, class Node> [[gnu::always_inline]] constexpr void each_part(const Node& node, auto&& f) {
    if constexpr (constexpr auto at = places_in<What, Node>; at.size() == 1) f(std::get<at[0]>(node.parts));
    else if constexpr (at.size() > 1) [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
            (f(std::get<at[I]>(node.parts)), ...);
        }
    (std::make_index_sequence<at.size()>{});
}
template <class P>
inline constexpr bool part_of_transition =
    part_of<P> == part_on || part_of<P> == part_to || part_of<P> == part_internal || part_of<P> == part_when ||
    part_of<P> == part_then;

/// What may stand where, one sentence a rule.
template <class... P> constexpr void check_transition(const Transition<P...>&) {
    static_assert((part_of_transition<P> && ...), "Ansatz: the parts of a transition are on, when, then, to and "
                                                  "internal, e.g. transition(on(\"alarm\"), to(\"chase\"))");
    static_assert((std::size_t(part_of<P> == part_when) + ... + 0) <= 1,
                  "Ansatz: a transition has one guard; combine several with &&, e.g. when(asked(\"near\", near) && "
                  "asked(\"armed\", armed))");
    static_assert((std::size_t(part_of<P> == part_to) + ... + 0) <= 1, "Ansatz: a transition goes to one state");
    static_assert((std::size_t(part_of<P> == part_on) + ... + 0) <= 1,
                  "Ansatz: a transition names its events once; several stand in one text, on(\"alarm noise\")");
}
template <class... P> constexpr void check_state(const State<P...>&) {
    static_assert((((part_of<P> >= part_entry || part_of<P> == part_initial || part_of<P> == part_to)) && ...),
                  "Ansatz: the parts of a state are transition(...), state(...), on_entry, on_exit, each_update, "
                  "behaves, initial and no_initial; on, when and then stand in a transition");
    static_assert((std::size_t(part_of<P> == part_behaves) + ... + 0) <= 1,
                  "Ansatz: a state has one class, behaves<Patrol>()");
}

} // namespace detail
} // namespace ansatz::states
