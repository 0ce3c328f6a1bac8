// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A description, flattened while it is compiled: states and transitions as numbered rows, who is inside whom, which
/// transitions an event can cause in a state, what a transition leaves and enters. Every compile-time representation
/// reads this; nothing of it is there at run time but what a representation stores.

#include <ansatz/states/describe.hpp>

#include <array>

namespace ansatz::states {

/// A state as a row.
struct StateRow {
    std::string_view name;    ///< empty for the machine itself
    Kind kind = Kind::state;  ///< a place to be, final, parallel, or a history
    std::uint16_t parent = 0; ///< the state that it is in; the machine, 0, is its own
    std::uint16_t end = 0;    ///< one past the last state inside it: its descendants are own + 1 .. end - 1
    /// What is entered with it; of a history, where it goes the first time; none: it has no states.
    std::uint16_t initial = 0xffff;
    std::string_view initial_name; ///< as the description names it; empty: the first state in it
    bool acts = false;             ///< whether something is done in it
    bool childless = false;        ///< it is entered without any of the states in it
};
/// A transition as a row.
struct TransitionRow {
    std::uint16_t source = 0;      ///< the state that it stands in
    std::uint16_t target = 0xffff; ///< the state that it goes to; `nowhere`: nothing is left or entered
    std::uint16_t domain = 0xffff; ///< the state inside which it happens: the innermost that contains source and target
    std::string_view events,       ///< that cause it, separated by blanks; empty: a condition, or at once
        target_name;               ///< as the description names it; empty: none
    bool guarded = false,          ///< it has a guard
        internal = false,          ///< it has internal() among its parts
        acts = false;              ///< something is done in it
};

/// The number of no state.
inline constexpr std::uint16_t nowhere = 0xffff;

/// A short list of states or transitions.
template <std::size_t N> struct Ids {
    std::array<std::uint16_t, N> at{};                        ///< the first `size` of them count
    std::size_t size = 0;                                     ///< how many there are
    constexpr void add(std::uint16_t id) { at[size++] = id; } ///< puts one at the end
};

/// What is wrong with a description.
enum class Fault {
    none,
    unknown_target,
    unknown_initial,
    duplicate,
    no_states,
    history_alone,
    history_target,
    final_left,
    initial_outside,
    childless
};

namespace detail {

template <class Node> constexpr auto flatten_states(const Node& node) {
    return std::apply(
        [&](const auto&... part) {
            [[maybe_unused]] auto of = [](const auto& p) {
                if constexpr (part_of<decltype(p)> == part_state) return flatten_states(p);
                else return std::tuple<>{};
            };
            return std::tuple_cat(std::tuple<const Node*>(&node), of(part)...);
        },
        node.parts);
}
template <class Node> constexpr auto flatten_transitions(const Node& node) {
    return std::apply(
        [](const auto&... part) {
            [[maybe_unused]] auto own = [](const auto& p) {
                if constexpr (part_of<decltype(p)> == part_transition) return std::tuple<decltype(&p)>(&p);
                else return std::tuple<>{};
            };
            return std::tuple_cat(own(part)...);
        },
        node.parts);
}

template <std::size_t NS, std::size_t NT> struct Rows {
    std::array<StateRow, NS> states{};
    std::array<TransitionRow, NT> transitions{};
    Fault fault = Fault::none;
    std::uint16_t culprit = 0;
    bool parallel = false, history = false, acts = false, childless = false;

    constexpr std::uint16_t find(std::string_view name) const {
        for (std::size_t i = 1; i < NS; ++i)
            if (states[i].name == name) return std::uint16_t(i);
        return nowhere;
    }
    /// Whether b is in a, or a itself.
    constexpr bool contains(std::uint16_t a, std::uint16_t b) const { return b >= a && b < states[a].end; }
    constexpr void wrong(Fault f, std::uint16_t who) {
        if (fault == Fault::none) fault = f, culprit = who;
    }
};

template <class Node, class R>
constexpr void fill_states(const Node& node, R& rows, std::uint16_t parent, std::uint16_t& next) {
    check_state(node);
    const std::uint16_t me = next++;
    auto& row = rows.states[me];
    row.name = node.name;
    row.kind = node.kind;
    row.parent = parent;
    if (node.kind == Kind::parallel) rows.parallel = true;
    if (is_history(node.kind)) rows.history = true;
    each_part<part_initial>(node, [&](const Initial& i) { row.initial_name = i.state; });
    each_part<part_to>(node, [&](const To& t) { row.initial_name = t.state; });
    each_part<part_no_initial>(node, [&](const NoInitial&) { rows.childless = row.childless = true; });
    constexpr auto acting = []<class... P>(const std::tuple<P...>*) {
        return ((part_of<P> >= part_entry && part_of<P> <= part_behaves) || ...);
    };
    row.acts = acting(static_cast<decltype(&node.parts)>(nullptr));
    rows.acts = rows.acts || row.acts;
    each_part<part_state>(node, [&](const auto& child) { fill_states(child, rows, me, next); });
    rows.states[me].end = next;
}

template <class T, class R>
constexpr void fill_transition(const T& transition, R& rows, std::uint16_t source, std::uint16_t at) {
    check_transition(transition);
    auto& row = rows.transitions[at];
    row.source = source;
    each_part<part_on>(transition, [&](const On& on) { row.events = on.events; });
    each_part<part_to>(transition, [&](const To& to) { row.target_name = to.state; });
    each_part<part_internal>(transition, [&](const Internal&) { row.internal = true; });
    each_part<part_when>(transition, [&](const auto&) { row.guarded = true; });
    each_part<part_then>(transition, [&](const auto&) { rows.acts = row.acts = true; });
}

template <class R> constexpr void resolve_states(R& rows, std::uint16_t count) {
    for (std::uint16_t i = 0; i < count; ++i) {
        auto& row = rows.states[i];
        if (i > 0 && (row.name.empty() || rows.find(row.name) != i)) rows.wrong(Fault::duplicate, i);
        if (is_history(row.kind)) {
            row.initial = rows.find(row.initial_name);
            if (row.initial == nowhere || row.initial == i || !rows.contains(row.parent, row.initial) ||
                row.initial == row.parent || is_history(rows.states[row.initial].kind))
                rows.wrong(Fault::history_target, i);
            continue;
        }
        std::uint16_t first = nowhere; // the first state in it that is no history
        for (std::uint16_t c = i + 1; c < row.end; c = rows.states[c].end)
            if (!is_history(rows.states[c].kind) && first == nowhere) first = c;
        if (row.end > i + 1 && first == nowhere) rows.wrong(Fault::history_alone, i);
        row.initial = row.initial_name.empty() ? first : rows.find(row.initial_name);
        if (row.childless) {
            if (i == 0 || row.kind != Kind::state || first == nowhere || !row.initial_name.empty())
                rows.wrong(Fault::childless, i);
            row.initial = nowhere;
        }
        if (!row.initial_name.empty() && row.initial == nowhere) rows.wrong(Fault::unknown_initial, i);
        if (row.initial != nowhere && (!rows.contains(i, row.initial) || row.initial == i))
            rows.wrong(Fault::initial_outside, i);
        if (i == 0 && first == nowhere) rows.wrong(Fault::no_states, 0);
        if (row.kind == Kind::final && first != nowhere) rows.wrong(Fault::final_left, i);
    }
}

template <class R> constexpr void resolve_transitions(R& rows, std::uint16_t count) {
    for (std::uint16_t t = 0; t < count; ++t) {
        auto& row = rows.transitions[t];
        if (rows.states[row.source].kind == Kind::final || is_history(rows.states[row.source].kind))
            rows.wrong(Fault::final_left, row.source);
        if (row.target_name.empty()) continue;
        row.target = rows.find(row.target_name);
        if (row.target == nowhere) {
            rows.wrong(Fault::unknown_target, t);
            continue;
        }
        if (row.internal && row.target != row.source && rows.contains(row.source, row.target)) {
            row.domain = row.source;
            continue;
        }
        row.domain = rows.states[row.source].parent;
        // A history is in its parent: going there from inside leaves the parent and enters it again.
        while (!rows.contains(row.domain, row.target) || row.domain == row.target)
            row.domain = rows.states[row.domain].parent;
    }
}

} // namespace detail

/// A description, flattened.
/// \tparam D  a struct with `Context` and `static constexpr auto machine = states::machine(...)`
template <class D> struct Model {
    static_assert(
        requires { typename D::Context; },
        "Ansatz: a description names the type that its guards and actions work on: using Context = Npc;");
    static_assert(
        requires { D::machine.parts; },
        "Ansatz: a description holds its states: static constexpr auto machine = states::machine(state(...), ...);");
    using Context = typename D::Context; ///< the user's

    /// A tuple of pointers to the states of the description, depth first; the first is the machine itself.
    static constexpr auto state_nodes = detail::flatten_states(D::machine);
    /// A tuple of pointers to its transitions, in the order of their sources.
    static constexpr auto transition_nodes = std::apply(
        [](const auto*... node) { return std::tuple_cat(detail::flatten_transitions(*node)...); }, state_nodes);
    static constexpr std::size_t state_count = std::tuple_size_v<decltype(state_nodes)>; ///< with the machine itself
    /// Of the whole machine.
    static constexpr std::size_t transition_count = std::tuple_size_v<decltype(transition_nodes)>;

    /// Its states and transitions as rows, and what is wrong with them.
    static constexpr auto rows = [] {
        detail::Rows<state_count, transition_count> r;
        std::uint16_t next = 0;
        detail::fill_states(D::machine, r, 0, next);
        std::uint16_t s = 0, t = 0;
        std::apply(
            [&](const auto*... node) {
                (
                    [&] {
                        detail::each_part<detail::part_transition>(
                            *node, [&](const auto& transition) { detail::fill_transition(transition, r, s, t++); });
                        ++s;
                    }(),
                    ...);
            },
            state_nodes);
        detail::resolve_states(r, state_count);
        if (r.fault == Fault::none) detail::resolve_transitions(r, transition_count);
        return r;
    }();
    static_assert(rows.fault != Fault::unknown_target,
                  "Ansatz: a transition goes to a state that the machine does not have; compare the name in "
                  "to(\"...\") with those of its states");
    static_assert(rows.fault != Fault::unknown_initial,
                  "Ansatz: initial(\"...\") names a state that the machine does not have");
    static_assert(rows.fault != Fault::initial_outside,
                  "Ansatz: initial(\"...\") names a state that is not inside the state where it stands");
    static_assert(
        rows.fault != Fault::childless,
        "Ansatz: no_initial() stands in a state with states inside, without initial(\"...\") beside it, and not in "
        "the machine itself");
    static_assert(rows.fault != Fault::duplicate,
                  "Ansatz: two states of a machine have the same name, or one has none");
    static_assert(rows.fault != Fault::no_states && rows.fault != Fault::history_alone,
                  "Ansatz: a machine, and a state with a history, has at least one state inside");
    static_assert(
        rows.fault != Fault::history_target,
        "Ansatz: a history says where to go the first time: shallow_history(\"last\", to(\"...\")), a state beside it");
    static_assert(rows.fault != Fault::final_left,
                  "Ansatz: a final state or a history has no transitions and no states of its own");
    static_assert(state_count < 4096 && transition_count < 16384,
                  "Ansatz: a machine of more than 4095 states is for Interpreted, from a file");

    // ---------------------------------------------------------------- events
    /// The names that transitions mention, each once, in order; a descriptor's trailing ".*" is left out.
    static constexpr auto collected = [] {
        constexpr std::size_t most = [] {
            std::size_t words = 1;
            for (const auto& t : rows.transitions) {
                words += t.events.empty() ? 0 : 1;
                for (const char c : t.events) words += c == ' ';
            }
            return words;
        }();
        std::array<std::string_view, most> names{};
        std::size_t count = 0;
        for (const auto& t : rows.transitions)
            for (auto rest = t.events; !rest.empty();) {
                const auto end = rest.find(' ');
                auto one = rest.substr(0, end);
                rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
                if (one.ends_with(".*")) one.remove_suffix(2);
                if (one.empty() || one == "*") continue;
                bool known = false;
                for (std::size_t i = 0; i < count; ++i) known = known || names[i] == one;
                if (!known) names[count++] = one;
            }
        return std::pair(names, count);
    }();
    /// One more than the names: the last is any other event, which only "*" takes.
    static constexpr std::size_t event_count = collected.second + 1;
    /// The name of an event by its number; "*" for the last.
    static constexpr std::string_view event_name(std::size_t e) {
        return e + 1 < event_count ? collected.first[e] : std::string_view("*");
    }
    /// The event of a name: itself, or the longest known name that it begins with, or the last.
    static constexpr std::uint16_t find_event(std::string_view name) {
        std::uint16_t best = event_count - 1;
        for (std::uint16_t e = 0; e + 1u < event_count; ++e)
            if (matches(event_name(e), name) &&
                (best + 1u == event_count || event_name(e).size() > event_name(best).size()))
                best = e;
        return best;
    }

    // ---------------------------------------------------------------- the tree
    /// Whether a state can be the innermost one: nothing is inside it, or it may be entered alone.
    static constexpr bool is_leaf(std::size_t s) {
        return s > 0 && rows.states[s].initial == nowhere && !is_history(rows.states[s].kind);
    }
    static constexpr std::uint16_t parent(std::size_t s) { return rows.states[s].parent; } ///< the state that s is in

    static constexpr std::size_t on_condition = 0x10000, ///< what can happen in a leaf beside an event (its number)
        at_once = 0x10001;                               ///< the same, of transitions with neither event nor guard
    /// Whether transition t is one for an event (its number), `on_condition` or `at_once`.
    static constexpr bool answers(std::size_t t, std::size_t what) {
        const auto& row = rows.transitions[t];
        if (what == on_condition) return row.events.empty() && row.guarded;
        if (what == at_once) return row.events.empty() && !row.guarded;
        return matches(row.events, event_name(what));
    }
    /// Whether a transition has neither event nor guard.
    static constexpr bool has_automatic = [] {
        for (const auto& t : rows.transitions)
            if (t.events.empty() && !t.guarded) return true;
        return false;
    }();
    /// The transitions to try in a leaf, inner states first, each state's in order; none after the first without a
    /// guard.
    static constexpr auto candidates(std::size_t leaf, std::size_t what) {
        Ids<transition_count + 1> found;
        for (std::size_t s = leaf;; s = parent(s)) {
            for (std::uint16_t t = 0; t < transition_count; ++t)
                if (rows.transitions[t].source == s && answers(t, what)) {
                    found.add(t);
                    if (!rows.transitions[t].guarded) return found;
                }
            if (s == 0) return found;
        }
    }
    /// The events that can cause something in a leaf.
    static constexpr auto events_in(std::size_t leaf) {
        Ids<event_count> found;
        for (std::uint16_t e = 0; e < event_count; ++e)
            if (candidates(leaf, e).size > 0) found.add(e);
        return found;
    }
    /// `candidates`, kept: they are asked for again and again while a machine is compiled.
    template <std::size_t Leaf, std::size_t What> static constexpr auto candidates_of = candidates(Leaf, What);
    /// `events_in`, kept as well.
    template <std::size_t Leaf> static constexpr auto events_of = events_in(Leaf);
    /// What is left, inner states first, from `from` to below `domain`.
    static constexpr auto exits(std::size_t from, std::size_t domain) {
        Ids<state_count> found;
        for (std::size_t s = from; s != domain; s = parent(s)) found.add(std::uint16_t(s));
        return found;
    }
    /// What is entered, outer states first, from below `domain` to `target` and on to where that begins; the last is a
    /// leaf, or a history that decides further at run time.
    static constexpr auto entries(std::size_t domain, std::size_t target) {
        Ids<2 * state_count> found;
        std::size_t from = domain;
        for (;;) {
            const auto up = exits(target, from);
            for (std::size_t i = up.size; i-- > 0;) found.add(up.at[i]);
            if (is_history(rows.states[target].kind) || rows.states[target].initial == nowhere) return found;
            from = target;
            target = rows.states[target].initial;
        }
    }
    /// The state directly inside `outer` that `inner` is in.
    static constexpr std::uint16_t child_towards(std::size_t outer, std::size_t inner) {
        while (parent(inner) != outer) inner = parent(inner);
        return std::uint16_t(inner);
    }
};

/// The event of that name, for a constant: `constexpr auto alarm = event<GuardNpc>("alarm")`. A name that the
/// description does not mention does not compile.
template <class D> consteval EventId event_of(std::string_view name) {
    const auto found = Model<D>::find_event(name);
    if (found + 1u == Model<D>::event_count)
        throw "Ansatz: no transition of this machine mentions an event of this name";
    return EventId(found);
}

} // namespace ansatz::states

namespace ansatz {

/// The event of that name: `constexpr auto alarm = event<GuardNpc>("alarm")`. A name that no transition mentions does
/// not compile.
template <class D> consteval EventId event(std::string_view name) { return states::event_of<D>(name); }

} // namespace ansatz
