// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Transitions that are added to an Interpreted machine while it runs, in the words of a description:
///
/// ```cpp
/// machine.add(npc, "patrol", transition(when("tired", after(60.0 * second)), to("sleep")));
/// machine.add(npc, "patrol", transition(on("bell"), to("chapel")), Among::first); // before those that are there
/// ```
///
/// Take it for what a level, a mod or a debugger adds to one machine; what all machines have belongs into their
/// description, and a machine that is changed as a whole is taken over by `reload`. Everything goes on: the active
/// states, their data and times, what guards remember, and the numbers of states and events. The numbers of transitions
/// behind the new one become higher. Other machines of the same chart are left alone: this one has a chart of its own
/// from then on, which is made anew for each call, between two updates and not within them.
///
/// `save` writes what was added by its names, and `load` asks for it again (save.hpp).

#include <ansatz/states/chart_build.hpp>
#include <ansatz/states/check.hpp>

#include <cstring>
#include <optional>

namespace ansatz {

/// Where a transition stands among those of its state: the first whose guard holds is taken.
enum class Among : std::uint8_t { last, first };

namespace states {

namespace detail {

/// Makes charts that differ from one in their transitions.
template <class Context> class ChartEditor {
public:
    /// A transition of the new chart: one of the old chart, or a fresh one.
    struct Row {
        std::optional<std::size_t> old;
        Outline::Transition shown; // with the names that people read
        Outline::Transition bound; // of a fresh one, with the names that are bound
    };

    /// \param names  what the names of fresh transitions stand for
    explicit ChartEditor(const Chart<Context>& chart, Bindings<Context> names = {})
        : chart_(chart), numbered_(chart.outline_), names_(std::move(names)) {
        for (std::size_t s = 0; s < chart.states_.size(); ++s) {
            auto& state = numbered_.states[s];
            const auto& made = chart.states_[s];
            number(state.entry, made.entry), number(state.exit, made.exit), number(state.each, made.each);
            number(state.initial_content, made.initial_content);
            if (state.behaviour.empty()) continue;
            state.behaviour = numbered(made.behaviour);
            names_.adopt(state.behaviour, chart.behaviours_[made.behaviour]);
        }
        for (std::size_t t = 0; t < chart.transitions_.size(); ++t) {
            const auto& made = chart.transitions_[t];
            number(numbered_.transitions[t].content, made.content);
            if (made.guard == nowhere || chart.guards_[made.guard].in != nowhere) continue; // In('x') keeps its name
            names_.adopt(numbered_.transitions[t].guard = numbered(made.guard), chart.guards_[made.guard]);
        }
        names_.adopt_log(chart.log_);
    }
    /// The transitions that are there.
    std::vector<Row> rows() const {
        std::vector<Row> all;
        for (std::size_t t = 0; t < chart_.outline_.transitions.size(); ++t)
            all.push_back({t, chart_.outline_.transitions[t], {}});
        return all;
    }
    /// Puts a fresh one among those of its state.
    /// \return where it is
    static std::size_t insert(std::vector<Row>& rows, Row row, std::size_t place_in_state) {
        std::size_t at = 0;
        while (at < rows.size() && rows[at].shown.source < row.shown.source) ++at;
        for (; at < rows.size() && rows[at].shown.source == row.shown.source && place_in_state > 0; --place_in_state)
            ++at;
        rows.insert(rows.begin() + std::ptrdiff_t(at), std::move(row));
        return at;
    }
    /// \param origin  what the sentence of a refusal begins with
    SharedChart<Context> make(const std::vector<Row>& rows, const std::string& origin) const {
        Outline built = numbered_, shown = chart_.outline_;
        built.origin = origin;
        built.transitions.clear(), shown.transitions.clear();
        for (const auto& row : rows) {
            built.transitions.push_back(row.old ? numbered_.transitions[*row.old] : row.bound);
            shown.transitions.push_back(row.shown);
        }
        return ChartBuilder<Context>::make(std::move(built), names_, std::move(shown), chart_.events_);
    }
    /// What the guards of the old chart remember, in the places of the new one.
    void keep_memories(const std::vector<Row>& rows, const Chart<Context>& made, const std::byte* from,
                       std::byte* to) const {
        for (std::size_t t = 0; t < rows.size(); ++t)
            if (const auto g = made.transitions_[t].guard; rows[t].old && g != nowhere && made.guards_[g].memory > 0)
                std::memcpy(to + made.memory_at_[g], from + chart_.memory_at_[chart_.transitions_[*rows[t].old].guard],
                            made.guards_[g].memory);
    }
    /// A name that no file and no program has.
    static std::string numbered(std::size_t n) { return "\x01" + std::to_string(n); }

private:
    void number(std::vector<Outline::Content>& contents, Range made) {
        for (std::size_t i = 0; i < contents.size(); ++i) {
            if (contents[i].what != Outline::Content::What::action) continue;
            const auto n = chart_.steps_[made.first + i].number;
            names_.adopt(contents[i].name = numbered(n), chart_.actions_[n]);
        }
    }
    const Chart<Context>& chart_;
    Outline numbered_;
    Bindings<Context> names_;
};

} // namespace detail

/// A base of every Interpreted machine.
/// \tparam Machine  the machine
/// \tparam Context  the user's
template <class Machine, class Context> class Additions {
    using Editor = detail::ChartEditor<Context>;

public:
    /// Adds a transition, in the words of a description: on, when, then, to, internal. What its guard remembers begins
    /// now, and what needs no event and no condition is taken at once.
    /// \tparam Own  the class of the state, where the guard reads it
    /// \return its number
    /// \throws std::invalid_argument from within an action; for a state or a target that is not there; for a final state or
    ///         a history; for a guard that reads the class of another state; and for one that would never be taken,
    ///         because an earlier transition always is. The machine is as it was
    template <class Own = NoBehaviour, class... P>
    TransitionId add(Context& context, StateId source, const Transition<P...>& transition, Among among = Among::last) {
        detail::check_transition(transition);
        typename Editor::Row row{{}, begin(source), {}};
        auto& shown = row.shown;
        Bindings<Context> names;
        const auto where = detail::place(machine().name(source));
        detail::each_part<detail::part_on>(transition, [&](const On& on) { shown.events = on.events; });
        detail::each_part<detail::part_to>(transition, [&](const To& to) { shown.targets = {std::string(to.state)}; });
        detail::each_part<detail::part_internal>(transition, [&](const Internal&) { shown.internal = true; });
        detail::each_part<detail::part_when>(transition, [&](const auto& when) {
            using Guard = std::remove_cvref_t<decltype(when.guard)>;
            detail::Called namer;
            shown.guard =
                detail::guard_name(when, where, 1 + of(source, [](const auto& t) { return !t.guard.empty(); }), namer);
            shown.equality = when.guard.is_equality();
            names.adopt(shown.guard, detail::bind_guard<Guard, Context, Own>(when.guard));
        });
        row.bound = shown;
        std::size_t actions = of(source, [](const auto& t) { return !t.content.empty(); });
        detail::each_part<detail::part_then>(transition, [&](const auto& then) {
            detail::Called namer;
            auto content = detail::content_of(then, where, "action", actions, namer);
            shown.content.push_back(content);
            if constexpr (!std::is_same_v<decltype(then.action), Raised>) {
                content.name = "\x01+" + std::to_string(actions); // two actions may have one name
                names.adopt(content.name,
                            detail::bind_action<std::remove_cvref_t<decltype(then.action)>, Context>(then.action));
            }
            row.bound.content.push_back(std::move(content));
        });
        return insert(context, std::move(row), std::move(names), among);
    }
    /// The same into a state of that name; "" is the machine itself, whose transitions are taken wherever it is.
    template <class Own = NoBehaviour, class... P>
    TransitionId add(Context& context, std::string_view source, const Transition<P...>& transition,
                     Among among = Among::last) {
        return add<Own>(context, named(source), transition, among);
    }
    /// Adds a transition that is data, of names: from a file, a console.
    /// \param transition  its source is `source`, whatever stands in it
    /// \param names       what its guard and actions stand for
    /// \throws std::invalid_argument for a name that nobody bound, too
    TransitionId add(Context& context, std::string_view source, const Outline::Transition& transition,
                     const Bindings<Context>& names, Among among = Among::last) {
        typename Editor::Row row{{}, transition, transition};
        row.shown.source = row.bound.source = index(named(source));
        row.shown.added = row.bound.added = true;
        if (const auto* guard = names.find_guard(transition.guard)) row.shown.equality = guard->equality;
        return insert(context, std::move(row), names, among);
    }
    /// The transitions that were added, in their order.
    std::vector<TransitionId> added() const {
        std::vector<TransitionId> found;
        const auto& all = machine().outline().transitions;
        for (std::size_t t = 0; t < all.size(); ++t)
            if (all[t].added) found.push_back(TransitionId(t));
        return found;
    }
    /// Takes one away again.
    /// \throws std::invalid_argument from within an action, and for one that was not added; the machine is as it was
    void remove(TransitionId transition) {
        refuse_busy("remove");
        const auto& all = machine().outline().transitions;
        if (index(transition) >= all.size() || !all[index(transition)].added)
            refuse(Refusal::invalid_argument,
                   "Machine::remove: the transition " + std::to_string(index(transition)) +
                       (index(transition) < all.size()
                            ? " of " + detail::shown(machine().name(StateId(all[index(transition)].source))) +
                                  " stands in the description of the machine"
                            : " is not there") +
                       "; only one that was added can be taken away, see added()");
        const Editor editor(*machine().chart_);
        auto rows = editor.rows();
        rows.erase(rows.begin() + std::ptrdiff_t(index(transition)));
        machine() = with(editor, rows, "Machine::remove");
    }

private:
    friend struct MachineArchive;
    Machine& machine() { return static_cast<Machine&>(*this); }
    const Machine& machine() const { return static_cast<const Machine&>(*this); }
    StateId named(std::string_view state) const { return state.empty() ? StateId::root : machine().state(state); }
    void refuse_busy(const char* verb) const {
        if (machine().busy_)
            refuse(Refusal::invalid_argument,
                   std::string("Machine::") + verb +
                       ": called from an action of the same machine; call it between two updates");
    }
    Outline::Transition begin(StateId source) const {
        if (index(source) >= machine().state_count())
            refuse(Refusal::invalid_argument,
                   "Machine::add: the number " + std::to_string(index(source)) + " names no state of the machine");
        Outline::Transition transition;
        transition.source = index(source);
        transition.added = true;
        return transition;
    }
    std::size_t of(StateId source, auto&& which) const {
        std::size_t n = 0;
        for (const auto& t : machine().outline().transitions) n += t.source == index(source) && which(t);
        return n;
    }
    TransitionId insert(Context& context, typename Editor::Row row, Bindings<Context> names, Among among) {
        refuse_busy("add");
        const Editor editor(*machine().chart_, std::move(names));
        auto rows = editor.rows();
        const std::size_t at =
            Editor::insert(rows, std::move(row), among == Among::first ? 0 : std::numeric_limits<std::size_t>::max());
        for (std::size_t t = at; t-- > 0 && rows[t].shown.source == rows[at].shown.source;)
            if (detail::hides(rows[t].shown, rows[at].shown))
                refuse(Refusal::invalid_argument,
                       "Machine::add: the transition of " +
                           detail::shown(machine().name(StateId(rows[at].shown.source))) +
                           " would never be taken: an earlier one " +
                           (rows[t].shown.guard.empty() ? "without a guard" : "with the same guard") +
                           " is taken before it; add it as Among::first");
        Machine next = with(editor, rows, "Machine::add");
        if (next.started()) {
            const detail::Busy busy(next.busy_);
            next.for_memory(context, at, true);
            next.finish(context);
        }
        machine() = std::move(next);
        return TransitionId(at);
    }
    /// The machine with other transitions, where it is.
    Machine with(const Editor& editor, const std::vector<typename Editor::Row>& rows, const std::string& origin) const {
        Machine next(machine());
        const auto made = editor.make(rows, origin);
        const auto other = std::uint16_t(next.chart_->event_count() - 1); // an event that nothing mentioned
        next.fit_chart(made);
        editor.keep_memories(rows, *made, reinterpret_cast<const std::byte*>(machine().memory_.data()),
                             reinterpret_cast<std::byte*>(next.memory_.data()));
        for (std::size_t n = next.queue_.size(); n > 0; --n) {
            const EventId event = next.queue_.take();
            next.queue_.raise(index(event) == other ? EventId(made->event_count() - 1) : event);
        }
        return next;
    }
};

} // namespace states
} // namespace ansatz
