// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Makes a chart of an outline and bindings, or says in one sentence why not: with the path of the file, the line and
/// the name. Nothing half-made is ever seen.

#include <ansatz/states/chart.hpp>
#include <ansatz/states/names.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

namespace ansatz {

namespace states::detail {

inline constexpr std::uint32_t no_candidate = 0xffffffff;
inline constexpr std::size_t most_depth = 256, most_targets = 64;
inline constexpr std::size_t most_cells = std::size_t(1) << 24; // 64 MB

/// The structure: which state is in which, and all names resolved.
template <class Context> class ChartBuilder {
public:
    ChartBuilder(Chart<Context>& chart, const Bindings<Context>& names)
        : c_(chart), names_(names), outline_(chart.outline_) {}

    void build() {
        if (outline_.states.empty()) wrong(0, "a machine has at least its root; the outline is empty");
        if (outline_.states.size() >= 0xfff0)
            wrong(0, "it has " + std::to_string(outline_.states.size()) + " states; a machine has at most 65519");
        if (outline_.transitions.size() >= 0xfff0)
            wrong(0, "it has " + std::to_string(outline_.transitions.size()) +
                         " transitions; a machine has at most 65519");
        tree();
        for (std::size_t t = 0; t < outline_.transitions.size(); ++t) collect_events(outline_.transitions[t]);
        if (c_.events_.size() >= 0xfff0)
            wrong(0, "it mentions " + std::to_string(c_.events_.size()) + " events; a machine has at most 65519");
        for (std::size_t s = 0; s < c_.states_.size(); ++s) state(s);
        for (const auto& t : outline_.transitions) transition(t);
        c_.log_ = names_.log_function();
    }

    /// The whole of it.
    // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved from
    static SharedChart<Context> make(Outline outline, const Bindings<Context>& names,
                                     std::optional<Outline> shown_as = {},
                                     const std::vector<std::string>& first_events = {}) {
        auto chart = std::make_shared<Chart<Context>>();
        chart->outline_ = std::move(outline);
        for (const auto& event : first_events)
            chart->event_ids_.emplace(event, std::uint16_t(chart->events_.size())), chart->events_.push_back(event);
        ChartBuilder builder(*chart, names);
        builder.build();
        ChartTables<Context>(*chart, builder).build();
        if (shown_as) chart->outline_ = std::move(*shown_as);
        return chart;
    }

    [[noreturn]] void wrong(long line, const std::string& what) const {
        refuse(Refusal::invalid_argument, outline_.origin + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what);
    }

private:
    void tree() {
        c_.states_.resize(outline_.states.size());
        std::vector<std::size_t> depth(c_.states_.size());
        for (std::size_t s = 0; s < c_.states_.size(); ++s) {
            const auto& from = outline_.states[s];
            auto& to = c_.states_[s];
            if (s > 0 && (from.parent >= s || c_.states_[from.parent].end != s))
                wrong(from.line, "the outline is not depth first at the state " + shown(from.name));
            to.kind = from.kind;
            to.parent = std::uint16_t(from.parent);
            if (s > 0) depth[s] = depth[from.parent] + 1;
            if (depth[s] > most_depth)
                wrong(from.line, "the state " + shown(from.name) + " is nested more than 256 deep");
            for (std::size_t up = s;; up = c_.states_[up].parent) {
                c_.states_[up].end = std::uint16_t(s + 1);
                if (up == 0) break;
            }
            if (s == 0) continue;
            if (from.name.empty()) wrong(from.line, "a state has no id");
            const auto parent = c_.states_[from.parent].kind;
            if (is_history(parent) || parent == Kind::final)
                wrong(from.line, "the state " + shown(from.name) + " stands in " +
                                     shown(outline_.states[from.parent].name) +
                                     ", a final state or a history, which has none inside");
            if (!c_.state_ids_.emplace(from.name, std::uint16_t(s)).second)
                wrong(from.line, "the id " + shown(from.name) + " is taken already, by the state of line " +
                                     std::to_string(outline_.states[index(c_.find(from.name))].line));
            if (from.kind == Kind::parallel) c_.parallel_ = true;
        }
    }

    void collect_events(const Outline::Transition& t) {
        for (auto one : words(t.events)) {
            while (one.ends_with(".*") || one.ends_with('.')) one.resize(one.size() - (one.ends_with('.') ? 1 : 2));
            if (one.empty() || one == "*") continue;
            if (c_.event_ids_.emplace(one, std::uint16_t(c_.events_.size())).second) c_.events_.push_back(one);
        }
    }

    std::uint16_t find(const std::string& name, long line, const std::string& who) const {
        const StateId found = c_.find(name);
        if (found == StateId::none) wrong(line, who + " names the state " + shown(name) + ", which is not there");
        return std::uint16_t(found);
    }
    bool inside(std::size_t outer, std::size_t inner) const { return inner > outer && inner < c_.states_[outer].end; }

    void state(std::size_t s) {
        const auto& from = outline_.states[s];
        auto& to = c_.states_[s];
        const std::string who = s == 0 ? "the machine" : "the state " + shown(from.name);
        to.entry = steps(from.entry);
        to.exit = steps(from.exit);
        to.each = steps(from.each);
        to.initial_content = steps(from.initial_content);
        to.acts =
            to.entry.count + to.exit.count + to.each.count + to.initial_content.count > 0 || !from.behaviour.empty();
        if (!from.behaviour.empty()) {
            const auto* maker = names_.find_behaviour(from.behaviour);
            if (maker == nullptr)
                wrong(from.line, who + " is of the class " + shown(from.behaviour) +
                                     ", which nobody bound; call behaviour<...>(" + shown(from.behaviour) + ")");
            to.behaviour = std::uint16_t(c_.behaviours_.size());
            c_.behaviours_.push_back(*maker);
        }
        if (to.acts) c_.acts_ = true;
        if (to.kind == Kind::final || to.kind == Kind::parallel) c_.raises_ = true;
        if (s > 0) to.done = std::uint16_t(c_.event("done.state." + from.name));

        to.histories.first = std::uint32_t(c_.ids_.size());
        std::uint16_t first = nowhere;
        std::size_t children = 0;
        for (std::size_t child = s + 1; child < to.end; child = c_.states_[child].end, ++children) {
            if (is_history(outline_.states[child].kind)) c_.ids_.push_back(std::uint16_t(child));
            else if (first == nowhere) first = std::uint16_t(child);
        }
        to.histories.count = std::uint32_t(c_.ids_.size()) - to.histories.first;
        if (s == 0 && first == nowhere) wrong(from.line, "the machine has no states");
        if (children > 0 && first == nowhere) wrong(from.line, who + " has a history and no state for it to remember");
        initial(from, to, s, first, who);
    }

    void initial(const Outline::State& from, ChartState& to, std::size_t s, std::uint16_t first,
                 const std::string& who) {
        to.initial.first = std::uint32_t(c_.ids_.size());
        if (is_history(to.kind)) {
            if (from.initial.empty())
                wrong(from.line, "the history " + shown(from.name) + " does not say where to go the first time");
        } else if (to.kind == Kind::parallel && !from.initial.empty())
            wrong(from.line,
                  "the parallel state " + shown(from.name) + " has an initial state; all its states are entered");
        for (const auto& name : from.initial) {
            const auto id = find(name, from.line, who);
            if (!inside(is_history(to.kind) ? to.parent : s, id) || id == s)
                wrong(from.line, who + " begins in " + shown(name) + ", which is not inside it");
            if (is_history(to.kind) && is_history(outline_.states[id].kind))
                wrong(from.line, who + " begins in the history " + shown(name));
            c_.ids_.push_back(id);
        }
        if (from.childless && (s == 0 || to.kind != Kind::state || first == nowhere || !from.initial.empty()))
            wrong(from.line,
                  who + " is to begin in none of the states in it, which is for a state with states inside and "
                        "without an initial one");
        if (from.childless) to.childless = c_.childless_ = true;
        else if (from.initial.empty() && to.kind == Kind::state && first != nowhere) c_.ids_.push_back(first);
        to.initial.count = std::uint32_t(c_.ids_.size()) - to.initial.first;
        check_together(to.initial, from.line, who);
    }

    // Several targets are states that can be active at once: in different regions of a parallel state.
    void check_together(Range targets, long line, const std::string& who) const {
        if (targets.count > most_targets)
            wrong(line, who + " goes to " + std::to_string(targets.count) + " states; 64 are possible");
        for (std::size_t i = 0; i < targets.count; ++i)
            for (std::size_t j = i + 1; j < targets.count; ++j) {
                const std::size_t a = c_.ids_[targets.first + i], b = c_.ids_[targets.first + j];
                std::size_t up = a;
                while (up != 0 && up != b && !inside(up, b)) up = outline_.states[up].parent;
                if (a == b || up == a || up == b || outline_.states[up].kind != Kind::parallel)
                    wrong(line, who + " goes to " + shown(outline_.states[a].name) + " and " +
                                    shown(outline_.states[b].name) + ", which are never active together");
            }
    }

    Range steps(const std::vector<Outline::Content>& contents) {
        Range range{std::uint32_t(c_.steps_.size()), std::uint32_t(contents.size())};
        for (const auto& content : contents) {
            Step step{content.what, 0};
            if (content.what == Outline::Content::What::action) {
                const auto* action = names_.find_action(content.name);
                if (action == nullptr)
                    wrong(content.line,
                          "the action " + shown(content.name) + " is not bound; bound are: " + names_.action_names());
                step.number = std::uint16_t(c_.actions_.size());
                c_.actions_.push_back(*action);
            } else if (content.what == Outline::Content::What::raise) {
                if (content.name.empty()) wrong(content.line, "an event that is raised has no name");
                step.number = std::uint16_t(c_.event(content.name));
                c_.raises_ = true;
            } else {
                step.number = std::uint16_t(c_.texts_.size());
                c_.texts_.push_back(content.name);
            }
            if (c_.actions_.size() >= 0xfff0 || c_.texts_.size() >= 0xfff0)
                wrong(content.line, "it does more than 65519 things");
            c_.steps_.push_back(step);
            c_.acts_ = true;
        }
        return range;
    }

    void transition(const Outline::Transition& from) {
        ChartTransition to;
        to.source = std::uint16_t(from.source);
        const auto& source = outline_.states[from.source];
        const std::string who = "the transition of " + shown(source.name);
        if (source.kind == Kind::final || is_history(source.kind))
            wrong(from.line, "the state " + shown(source.name) + " is final or a history and has a transition");
        to.targets.first = std::uint32_t(c_.ids_.size());
        for (const auto& name : from.targets) c_.ids_.push_back(find(name, from.line, who));
        to.targets.count = std::uint32_t(from.targets.size());
        check_together(to.targets, from.line, who);
        to.stays = from.targets.empty();
        to.content = steps(from.content);
        if (!to.stays) to.domain = domain(to, from.internal);
        if (!from.guard.empty()) guard(to, from, source, who);
        if (from.events.empty() && from.guard.empty()) {
            if (to.stays) wrong(from.line, who + " has no event, no condition and no target: it would happen for ever");
            c_.automatic_ = true;
        }
        c_.transitions_.push_back(to);
    }
    void guard(ChartTransition& to, const Outline::Transition& from, const Outline::State& source,
               const std::string& who) {
        const auto* found = names_.find_guard(from.guard);
        BoundGuard<Context> asks_in;
        if (const auto asked = in_predicate(from.guard); found == nullptr && !asked.state.empty()) {
            asks_in.in = find(std::string(asked.state), from.line, who + ", by its condition,");
            asks_in.not_in = asked.negated;
            if (is_history(outline_.states[asks_in.in].kind))
                wrong(from.line, who + " has the condition " + shown(from.guard) + ", and nobody can be in a history");
            found = &asks_in;
        }
        if (found == nullptr)
            wrong(from.line, who + " has the guard " + shown(from.guard) +
                                 ", which is not bound; bound are: " + names_.guard_names());
        if (found->own != nullptr) {
            const auto* maker = names_.find_behaviour(source.behaviour);
            if (maker == nullptr || (*maker)()->tag() != found->own)
                wrong(from.line,
                      who + " has the guard " + shown(from.guard) + ", which reads the class of another state");
        }
        to.guard = std::uint16_t(c_.guards_.size());
        c_.guards_.push_back(*found);
        constexpr std::size_t align = alignof(std::max_align_t);
        c_.memory_at_.push_back(std::uint32_t(c_.memory_));
        c_.memory_ += (found->memory + align - 1) / align * align;
        const auto number = std::size_t(&from - outline_.transitions.data());
        outline_.transitions[number].equality = found->equality;
    }
    // The innermost state that holds source and targets, and is no parallel one; the source itself for an internal one.
    std::uint16_t domain(const ChartTransition& t, bool internal) const {
        auto holds = [&](std::size_t s) {
            if (c_.states_[s].kind == Kind::parallel) return false;
            for (std::size_t i = 0; i < t.targets.count; ++i)
                if (!inside(s, c_.ids_[t.targets.first + i])) return false;
            return true;
        };
        std::size_t s = t.source;
        if (internal && holds(s)) return std::uint16_t(s);
        do s = c_.states_[s].parent;
        while (s != 0 && !holds(s));
        return std::uint16_t(s);
    }

    Chart<Context>& c_;
    const Bindings<Context>& names_;
    Outline& outline_;
};

/// The candidates of each state and event, and which transitions are plain.
template <class Context> class ChartTables {
public:
    ChartTables(Chart<Context>& chart, const ChartBuilder<Context>& builder) : c_(chart), builder_(builder) {}

    void build() {
        c_.columns_ = c_.event_count() + 2;
        if (c_.columns_ * c_.state_count() > most_cells)
            builder_.wrong(0, "it has " + std::to_string(c_.state_count()) + " states and " +
                                  std::to_string(c_.event_count()) +
                                  " events; the product of both is at most 16777216");
        columns_of_transitions();
        c_.cells_.assign(c_.columns_ * c_.state_count(), no_candidate);
        for (std::size_t s = 1; s < c_.state_count(); ++s)
            if (c_.states_[s].childless || (c_.states_[s].end == s + 1 && !is_history(c_.states_[s].kind))) leaf(s);
        if (!c_.parallel_)
            for (auto& t : c_.transitions_)
                if (!t.stays) plain(t);
    }

private:
    void columns_of_transitions() {
        of_state_.resize(c_.state_count());
        columns_.resize(c_.transitions_.size());
        std::size_t work = 0;
        for (std::size_t t = 0; t < c_.transitions_.size(); ++t) {
            const auto& from = c_.outline_.transitions[t];
            of_state_[from.source].push_back(std::uint16_t(t));
            if (from.events.empty()) columns_[t] = {std::uint32_t(c_.columns_ - (from.guard.empty() ? 1 : 2))};
            else events(t);
            work += columns_[t].size();
            if (work > most_cells) builder_.wrong(from.line, "its transitions take more than 16777216 events");
        }
    }
    // The events of a transition, each once: those that a descriptor begins stand together in the order of names.
    void events(std::size_t t) {
        auto& found = columns_[t];
        for (auto one : words(c_.outline_.transitions[t].events)) {
            while (one.ends_with(".*") || one.ends_with('.')) one.resize(one.size() - (one.ends_with('.') ? 1 : 2));
            if (one.empty() || one == "*") {
                found.resize(c_.event_count());
                std::iota(found.begin(), found.end(), 0u);
                return;
            }
            found.push_back(c_.event_ids_.find(one)->second);
            one += '.';
            for (auto at = c_.event_ids_.lower_bound(one); at != c_.event_ids_.end() && at->first.starts_with(one);
                 ++at)
                found.push_back(at->second);
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }
    void leaf(std::size_t s) {
        // Column by column, the candidates of the state and of all around it.
        lists_.resize(c_.columns_);
        for (const auto column : used_) lists_[column].clear();
        used_.clear();
        for (std::size_t up = s;; up = c_.states_[up].parent) {
            for (const auto t : of_state_[up])
                for (const auto column : columns_[t]) {
                    ++work_;
                    auto& list = lists_[column];
                    if (list.empty()) used_.push_back(column);
                    if (list.empty() || c_.transitions_[list.back()].guard != nowhere) list.push_back(t);
                }
            if (up == 0) break;
        }
        for (const auto column : used_) {
            c_.cells_[s * c_.columns_ + column] = std::uint32_t(c_.candidates_.size());
            c_.candidates_.insert(c_.candidates_.end(), lists_[column].begin(), lists_[column].end());
            c_.candidates_.push_back(nowhere);
        }
        if (c_.candidates_.size() > most_cells || work_ > 16 * most_cells) // the latter takes a second
            builder_.wrong(0, "its states and transitions make more than 16777216 candidates");
    }
    // A transition that changes the present state and does nothing else: no guard, and nothing inside its domain acts,
    // remembers or ends.
    void plain(ChartTransition& t) {
        if (t.guard != nowhere || t.content.count > 0) return;
        for (std::size_t s = t.domain + 1u; s < c_.states_[t.domain].end; ++s)
            if (c_.states_[s].acts || c_.states_[s].kind != Kind::state) return;
        t.lands = c_.ids_[t.targets.first];
        while (c_.states_[t.lands].initial.count > 0) t.lands = c_.ids_[c_.states_[t.lands].initial.first];
        t.plain = true;
    }

    Chart<Context>& c_;
    const ChartBuilder<Context>& builder_;
    std::vector<std::vector<std::uint16_t>> of_state_;
    std::vector<std::vector<std::uint32_t>> columns_;
    std::vector<std::vector<std::uint16_t>> lists_;
    std::vector<std::uint32_t> used_;
    std::size_t work_ = 0; // candidates that were visited, whether they are any or stand behind one without a guard
};

} // namespace states::detail

/// A chart of an outline.
/// \param names  what its names stand for
/// \throws std::invalid_argument with origin, line and name for whatever is wrong
template <class Context> SharedChart<Context> make_chart(Outline outline, const Bindings<Context>& names) {
    return states::detail::ChartBuilder<Context>::make(std::move(outline), names);
}

/// The chart of a description, with its own guards and actions, whether they have names or not. Made once.
template <class D> SharedChart<typename D::Context> chart_of() {
    using Builder = states::detail::ChartBuilder<typename D::Context>;
    // Numbers for names: two functions of a description may have one name.
    static const auto chart =
        Builder::make(states::detail::outline_named<D>(states::detail::Numbered{}),
                      states::detail::bindings_named<D>(states::detail::Numbered{}), outline_of<D>());
    return chart;
}

} // namespace ansatz
