// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `MachineArchive`: what a machine of each representation consists of, field by field, for save.hpp: where it is, its
/// times, its histories, what guards and state classes remember, and what waits. A reader is held to what a machine
/// can be.
// not in the umbrella: it is a part of save.hpp

#include <ansatz/states/archive.hpp>
#include <ansatz/states/machine.hpp>
#include <ansatz/states/outline.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::states {

namespace detail {
template <class R> constexpr std::string_view representation_name = "Interpreted";
template <> inline constexpr std::string_view representation_name<Switch> = "Switch";
template <> inline constexpr std::string_view representation_name<StatePattern> = "StatePattern";
template <> inline constexpr std::string_view representation_name<Table> = "Table";
} // namespace detail

/// Lists what a machine consists of; a friend of every representation.
struct MachineArchive {
    static constexpr std::uint64_t version = 1; ///< of the format

    /// The name of its representation.
    template <class D, class R, class... O> static std::string_view representation(const StaticMachine<D, R, O...>&) {
        return detail::representation_name<R>;
    }
    /// The same.
    template <class D, class C, class... O>
    static std::string_view representation(const InterpretedMachine<D, C, O...>&) {
        return detail::representation_name<Interpreted>;
    }
    /// Its structure and names.
    template <class D, class R, class... O> static Outline outline(const StaticMachine<D, R, O...>&) {
        return outline_of<D>();
    }
    /// The same.
    template <class D, class C, class... O> static const Outline& outline(const InterpretedMachine<D, C, O...>& m) {
        return m.outline();
    }
    /// Whether an action of it is running.
    template <class D, class R, class... O> static bool busy(const StaticMachine<D, R, O...>& m) {
        if constexpr (StaticMachine<D, R, O...>::can_raise) return m.busy_;
        else return false;
    }
    /// The same.
    template <class D, class C, class... O> static bool busy(const InterpretedMachine<D, C, O...>& m) {
        return m.busy_;
    }
    /// A machine of the same kind and options that is in no state.
    template <class D, class R, class... O> static auto fresh(const StaticMachine<D, R, O...>& m) {
        StaticMachine<D, R, O...> next;
        next.options_ = m.options_;
        return next;
    }
    /// The same.
    template <class D, class C, class... O> static auto fresh(const InterpretedMachine<D, C, O...>& m) {
        InterpretedMachine<D, C, O...> next(m);
        next.adopt(m.chart_);
        next.now_ = next.dt_ = {}, next.queue_ = {}, next.stopped_ = false;
        return next;
    }

    /// A transition that was added, and where it stands among those of its state.
    using Addition = std::pair<Outline::Transition, std::size_t>;
    /// Gives a machine these additions and no others. One that it has keeps its functions; the names of another are
    /// looked up in `names`, if there are any.
    /// \param file  for the sentences
    template <class D, class C, class... O>
    static void set_additions(InterpretedMachine<D, C, O...>& m, const std::vector<Addition>& additions,
                              const Bindings<C>* names, const std::string& file) {
        if (additions.empty() && m.added().empty()) return;
        using Editor = detail::ChartEditor<C>;
        const Editor editor(*m.chart_, names != nullptr ? *names : Bindings<C>{});
        auto before = editor.rows(), rows = before;
        std::erase_if(rows, [](const auto& row) { return row.shown.added; });
        for (const auto& [transition, place] : additions) {
            typename Editor::Row row{{}, transition, transition};
            for (auto& old : before)
                if (!row.old && old.old && old.shown.added && old.shown == transition)
                    row.old = std::exchange(old.old, std::nullopt), row.shown = old.shown;
            if (!row.old && names == nullptr)
                refuse(Refusal::invalid_argument,
                       file + ": a transition of " + detail::shown(m.name(StateId(transition.source))) +
                           (transition.events.empty() ? "" : " on " + detail::shown(transition.events)) +
                           (transition.guard.empty() ? "" : " with the guard " + detail::shown(transition.guard)) +
                           " was added to the machine before it was saved; add it to this one too, or give load the "
                           "Bindings of its names");
            if (const auto* guard = row.old ? nullptr : names->find_guard(transition.guard))
                row.shown.equality = guard->equality;
            Editor::insert(rows, std::move(row), place);
        }
        m.fit_chart(editor.make(rows, file));
    }

    /// A machine of the compile-time representations, field by field.
    template <class D, class R, class... O> static void fields(StaticMachine<D, R, O...>& m, Archive& a) {
        using Machine = StaticMachine<D, R, O...>;
        using M = typename Machine::M;
        std::string active(m.started() ? m.active_name() : std::string_view());
        a.text("active", active);
        if (a.reads() && !active.empty()) {
            const auto s = M::rows.find(active);
            if (s == nowhere || !M::is_leaf(s)) a.refuse_here("active", "the name of a state without others in it");
            detail::with_number<M::state_count>(s, [&]<std::size_t S>() {
                if constexpr (M::is_leaf(S)) m.state_.template set<S>();
                return true;
            });
        }
        if constexpr (Machine::loops) detail::archive_field(a, "stuck", m.stopped_);
        if constexpr (Machine::keeps_time) times(m, m.clock_.now, m.clock_.dt, m.clock_.entered, a);
        if constexpr (M::rows.history) {
            a.open("histories");
            for (std::size_t h = 1; h < M::state_count; ++h)
                if (is_history(M::rows.states[h].kind))
                    history(m, h, m.history_[h], a, [&](std::size_t s) {
                        return M::rows.contains(M::parent(h), std::uint16_t(s)) &&
                               (M::rows.states[h].kind == Kind::deep_history
                                    ? M::is_leaf(s)
                                    : (M::parent(s) == M::parent(h) && !is_history(M::rows.states[s].kind)) ||
                                          (s == M::parent(h) && M::is_leaf(s)));
                    });
            a.close();
        }
        if constexpr (Machine::P::AllGuards::remember) {
            a.open("guards");
            m.for_memories(
                [&]<std::size_t T>(const auto&, auto& memory) { detail::archive_field(a, std::to_string(T), memory); });
            a.close();
        }
        a.open("classes");
        [&]<std::size_t... S>(std::index_sequence<S...>) {
            (
                [&] {
                    using B = typename Machine::P::template Behaviour<S>;
                    if constexpr (!std::is_empty_v<B>)
                        detail::archive_field(a, M::rows.states[S].name, m.template own_of<S>());
                }(),
                ...);
        }(std::make_index_sequence<M::state_count>{});
        a.close();
        if constexpr (Machine::can_raise) queue(m, m.queue_, a);
    }
    /// An interpreted machine, field by field.
    template <class D, class C, class... O> static void fields(InterpretedMachine<D, C, O...>& m, Archive& a) {
        const auto& c = *m.chart_;
        if (c.parallel_) regions(m, m.regions_, a);
        else {
            std::string active(m.started() ? m.active_name() : std::string_view());
            a.text("active", active);
            if (a.reads() && !active.empty()) {
                const auto s = c.find(active);
                if (s == StateId::none || c.states_[index(s)].initial.count > 0 || is_history(m.kind_of(s)))
                    a.refuse_here("active", "the name of a state without others in it");
                m.leaf_ = std::uint16_t(s);
            }
            a.open("histories");
            for (std::size_t h = 1; h < c.state_count(); ++h)
                if (is_history(c.states_[h].kind))
                    history(m, h, m.history_[h], a, [&](std::size_t s) {
                        const std::size_t parent = c.states_[h].parent;
                        if (s == parent) return c.states_[s].childless; // it was there alone
                        return s > parent && s < c.states_[parent].end && !is_history(c.states_[s].kind) &&
                               (c.states_[h].kind == Kind::deep_history ? c.states_[s].initial.count == 0
                                                                        : c.states_[s].parent == parent);
                    });
            a.close();
        }
        detail::archive_field(a, "stuck", m.stopped_);
        times(m, m.now_, m.dt_, m.entered_, a);
        a.open("guards");
        for (std::size_t t = 0; t < c.transitions_.size(); ++t) {
            const auto g = c.transitions_[t].guard;
            if (g == nowhere || c.guards_[g].memory == 0) continue;
            if (c.guards_[g].archive == nullptr)
                refuse(Refusal::invalid_argument, "Machine: the guard " +
                                                      detail::shown(m.outline().transitions[t].guard) +
                                                      " remembers something of which it is not known what it consists "
                                                      "of; give its Memory `fields`, see states/archive.hpp");
            c.guards_[g].archive(const_cast<void*>(m.memory_at(g)), a, std::to_string(t));
        }
        a.close();
        a.open("classes");
        for (std::size_t s = 0; s < c.state_count(); ++s)
            if (const auto own = c.states_[s].behaviour;
                own != nowhere && !m.owns_[own]->archive(a, c.name(StateId(s))))
                refuse(Refusal::invalid_argument, "Machine: the class of the state " +
                                                      detail::shown(c.name(StateId(s))) +
                                                      " holds something of which it is not known what it consists of; "
                                                      "give it `fields`, see states/archive.hpp");
        a.close();
        queue(m, m.queue_, a);
    }

private:
    static void times(const auto& m, auto& now, auto& dt, auto& entered, Archive& a) {
        detail::archive_field(a, "time", now);
        detail::archive_field(a, "dt", dt);
        a.open("entered");
        for (std::size_t s = 1; s < m.state_count(); ++s) detail::archive_field(a, m.name(StateId(s)), entered[s]);
        a.close();
    }
    static void history(const auto& m, std::size_t h, std::uint16_t& kept, Archive& a, auto&& holds) {
        const auto own = m.name(StateId(h));
        std::string name(kept == nowhere ? std::string_view() : m.name(StateId(kept)));
        a.text(own, name);
        if (!a.reads()) return;
        kept = nowhere;
        for (std::size_t s = 1; s < m.state_count() && !name.empty(); ++s)
            if (m.name(StateId(s)) == name && holds(s)) kept = std::uint16_t(s);
        if (!name.empty() && kept == nowhere)
            a.refuse_here(own, "the name of a state that this history can remember, or none, \"\"");
    }
    static void queue(const auto& m, EventQueue& queue, Archive& a) {
        std::vector<std::string> waiting;
        if (!a.reads())
            for (EventQueue copy = queue; !copy.empty();) waiting.emplace_back(m.name(copy.take()));
        detail::archive_field(a, "waiting", waiting);
        if (a.reads()) {
            if (waiting.size() > EventQueue::capacity)
                a.refuse_here("waiting", "at most " + std::to_string(EventQueue::capacity) + " events");
            for (const auto& name : waiting) queue.raise(m.event(name));
        }
        detail::archive_field(a, "dropped", queue.dropped_);
    }
    /// The active states of parallel ones, and what their histories remember.
    template <class C> static void regions(const auto& m, detail::Regions<C>& r, Archive& a) {
        const auto& c = *m.chart_;
        std::vector<std::string> active;
        for (std::size_t s = 1; s < c.state_count(); ++s)
            if (r.active_[s]) active.emplace_back(c.name(StateId(s)));
        detail::archive_field(a, "active", active);
        if (a.reads()) {
            for (const auto& name : active) {
                const auto s = c.find(name);
                if (s == StateId::none || is_history(m.kind_of(s)))
                    a.refuse_here("active", "names of states; " + detail::shown(name) + " is none that can be active");
                r.active_[index(s)] = 1;
            }
            if (!active.empty())
                for (std::size_t s = 0; s < c.state_count(); ++s) require_children(c, r, s, a);
            r.find_leaves(c);
        }
        a.open("histories");
        for (std::size_t h = 1; h < c.state_count(); ++h) {
            if (!is_history(c.states_[h].kind)) continue;
            char* flags = r.recorded_.data() + r.recorded_at_[h];
            const std::size_t parent = c.states_[h].parent;
            std::vector<std::string> kept;
            for (std::size_t d = parent + 1; d < c.states_[parent].end; ++d)
                if (flags[0] && flags[d - parent]) kept.emplace_back(c.name(StateId(d)));
            const bool alone = c.states_[parent].childless, deep = c.states_[h].kind == Kind::deep_history;
            if (alone && flags[0] && kept.empty()) kept.emplace_back(c.name(StateId(parent)));
            detail::archive_field(a, c.name(StateId(h)), kept);
            if (!a.reads()) continue;
            flags[0] = char(!kept.empty());
            for (const auto& name : kept) {
                const auto s = c.find(name);
                if (alone && index(s) == parent && kept.size() == 1) continue;
                if (s == StateId::none || index(s) <= parent || index(s) >= c.states_[parent].end ||
                    is_history(m.kind_of(s)) ||
                    (deep ? c.states_[index(s)].initial.count > 0 || c.states_[index(s)].kind == Kind::parallel
                          : c.states_[index(s)].parent != parent)) // what Regions::record keeps
                    a.refuse_here(c.name(StateId(h)), "names of states that this history can remember");
                flags[index(s) - parent] = 1;
            }
            r.check_history(c, h);
            if (!kept.empty() && !flags[0])
                a.refuse_here(c.name(StateId(h)), "names of states that can be active together");
        }
        a.close();
    }
    /// A state has all its children active, one of them, or none.
    static void require_children(const auto& c, const auto& r, std::size_t s, Archive& a) {
        const bool active = s == 0 || r.active_[s] != 0;
        std::size_t inside = 0, all = 0;
        for (std::size_t child = s + 1; child < c.states_[s].end; child = c.states_[child].end)
            if (!is_history(c.states_[child].kind)) ++all, inside += std::size_t(r.active_[child] != 0);
        const std::size_t wanted = !active ? 0 : c.states_[s].kind == Kind::parallel ? all : all > 0 ? 1 : 0;
        if (inside != wanted && (inside != 0 || !active || !c.states_[s].childless))
            a.refuse_here("active", "states that can be active together; " +
                                        (s == 0 ? std::string("the machine") : detail::shown(c.name(StateId(s)))) +
                                        " has " + std::to_string(inside) + " active parts and needs " +
                                        std::to_string(wanted));
    }
};

} // namespace ansatz::states
