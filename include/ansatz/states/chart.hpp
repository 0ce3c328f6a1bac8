// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Chart`: an outline whose names are bound, made ready to run: numbers instead of names, a list of candidates for
/// each state and event. It never changes, and any number of machines share one.

#include <ansatz/states/bindings.hpp>

#include <map>

namespace ansatz {

namespace states::detail {

/// A range in one of the lists of a chart.
struct Range {
    std::uint32_t first = 0, count = 0;
};

/// A state, made ready.
struct ChartState {
    Kind kind = Kind::state;
    std::uint16_t parent = 0, end = 0;
    Range initial, entry, exit, each, initial_content; // initial: states; the others: things that are done
    Range histories;                                   // states
    std::uint16_t done = 0xffff;                       // the event "done.state.<name>", if any transition listens
    std::uint16_t behaviour = 0xffff;
    bool acts = false;
    bool childless = false;
};
/// A transition, made ready.
struct ChartTransition {
    std::uint16_t source = 0, domain = 0xffff;
    Range targets, content;
    std::uint16_t lands = 0xffff; // of a plain one: the state in which it ends
    std::uint16_t guard = 0xffff;
    bool stays = false; // no target
    bool plain = false; // only the present state changes
};
/// Something that is done.
struct Step {
    Outline::Content::What what;
    std::uint16_t number; // action, event or text
};

template <class Context> class ChartBuilder;
template <class Context> class ChartTables;
template <class Context> class ChartEditor;
template <class Context> class Regions;

} // namespace states::detail

/// \tparam Context  the user's
template <class Context> class Chart {
public:
    const Outline& outline() const { return outline_; }            ///< its structure and names
    bool parallel() const { return parallel_; }                    ///< several states can be active beside each other
    bool childless() const { return childless_; }                  ///< a state can be active without those in it
    std::size_t state_count() const { return states_.size(); }     ///< with the root
    std::size_t event_count() const { return events_.size() + 1; } ///< names that it mentions, and one for all others

    /// The event of a name: itself, or the longest known name that it begins with, or the one that only "*" takes.
    EventId event(std::string_view name) const {
        for (;;) {
            if (const auto at = event_ids_.find(name); at != event_ids_.end()) return EventId(at->second);
            const auto dot = name.rfind('.');
            if (dot == std::string_view::npos) return EventId(events_.size());
            name = name.substr(0, dot);
        }
    }
    /// The state of a name; StateId::none if it has none of it.
    StateId find(std::string_view name) const {
        const auto at = state_ids_.find(name);
        return at == state_ids_.end() ? StateId::none : StateId(at->second);
    }
    /// Of a state; empty for StateId::none and what is no state.
    std::string_view name(StateId id) const {
        return index(id) < outline_.states.size() ? std::string_view(outline_.states[index(id)].name) : "";
    }
    /// Of an event.
    std::string_view name(EventId id) const {
        return index(id) < events_.size() ? std::string_view(events_[index(id)]) : "*";
    }

private:
    template <class> friend class states::detail::ChartBuilder;
    template <class> friend class states::detail::ChartEditor;
    template <class> friend class states::detail::ChartTables;
    template <class, class, class...> friend class InterpretedMachine;
    template <class> friend class states::detail::Regions;
    friend struct states::MachineArchive;
    using Guard = states::detail::BoundGuard<Context>;
    using Action = states::detail::BoundAction<Context>;

    Outline outline_;
    bool parallel_ = false, childless_ = false, acts_ = false, raises_ = false, automatic_ = false;
    std::vector<states::detail::ChartState> states_;
    std::vector<states::detail::ChartTransition> transitions_;
    std::vector<std::uint16_t> ids_;          // the lists of states
    std::vector<states::detail::Step> steps_; // the lists of things that are done
    std::vector<Guard> guards_;               // one a transition that has one
    std::vector<Action> actions_;
    std::vector<std::string> texts_;
    std::vector<typename Bindings<Context>::Maker> behaviours_;
    std::vector<std::string> events_;
    std::map<std::string, std::uint16_t, std::less<>> event_ids_, state_ids_;
    std::shared_ptr<const std::function<void(Context&, std::string_view)>> log_;
    std::size_t memory_ = 0;               // bytes for all guards
    std::vector<std::uint32_t> memory_at_; // of each guard
    // Per state: a cell an event, then conditions, then at once. A cell is the first candidate, or `no_candidate`.
    std::vector<std::uint32_t> cells_;
    std::vector<std::uint16_t> candidates_; // transitions; 0xffff ends a list
    std::size_t columns_ = 0;
};

namespace states {
/// Throws std::invalid_argument: a state is entered without any of the states in it, and the machine does not allow
/// that.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_childless(const Outline& outline) {
    std::string name;
    long line = 0;
    for (const auto& s : outline.states)
        if (s.childless && name.empty()) name = s.name, line = s.line;
    refuse(Refusal::invalid_argument,
           outline.origin + (line > 0 ? ":" + std::to_string(line) : "") + ": the state \"" + name +
               "\" begins in none of the states in it; name one, or allow that with the option AllowChildless, e.g. "
               "Machine<InFile<Npc>, Interpreted, AllowChildless>");
}
} // namespace states

/// A chart that machines share.
template <class Context> using SharedChart = std::shared_ptr<const Chart<Context>>;

} // namespace ansatz
