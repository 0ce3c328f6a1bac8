// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Parallel states, for Interpreted: which transitions happen together, what they leave and what they enter. The
/// algorithm is that of the SCXML recommendation (W3C 2015, appendix D), on numbered states and kept vectors, with one
/// difference that all representations share: a history stands for a place in its parent when the domain of a
/// transition is sought.

#include <ansatz/states/chart_build.hpp>

namespace ansatz::states::detail {

/// The active states of a machine with parallel states.
template <class Context> class Regions {
public:
    /// Room for a chart, in no state.
    void fit(const Chart<Context>& c) {
        const std::size_t n = c.parallel_ ? c.state_count() : 0;
        active_.assign(n, 0), were_.assign(n, 0), enters_.assign(n, 0), begins_.assign(n, 0), exits_.assign(n, 0);
        restored_.assign(n, nowhere);
        leaves_.clear(), chosen_.clear(), kept_.clear();
        leaves_.reserve(n), chosen_.reserve(n), kept_.reserve(n);
        // What each history remembers: a flag for each state in its parent.
        recorded_at_.assign(n, 0);
        std::size_t flags = 0;
        for (std::size_t h = 0; h < n; ++h)
            if (is_history(c.states_[h].kind)) {
                recorded_at_[h] = flags;
                flags += 1u + c.states_[c.states_[h].parent].end - c.states_[h].parent;
            }
        recorded_.assign(flags, 0);
    }
    void forget() {
        std::fill(active_.begin(), active_.end(), char(0));
        std::fill(recorded_.begin(), recorded_.end(), char(0));
        leaves_.clear();
    }
    const auto& leaves() const { return leaves_; }
    bool started() const { return !leaves_.empty(); }
    bool has(std::size_t s) const { return s == 0 ? started() : active_[s] != 0; }
    std::size_t first_leaf(const Chart<Context>&) const { return leaves_.empty() ? 0 : leaves_.front(); }

    /// Calls `f(state)` for each that a history remembers: its parent, where that was alone.
    void each_remembered(const Chart<Context>& c, std::size_t h, auto&& f) const {
        const char* flags = recorded_.data() + recorded_at_[h];
        if (!flags[0]) return;
        const std::size_t parent = c.states_[h].parent;
        bool alone = true;
        for (std::size_t d = parent + 1; d < c.states_[parent].end; ++d)
            if (flags[d - parent]) alone = false, f(d);
        if (alone) f(parent);
    }
    /// A history remembers a state in its parent, too, or that its parent was alone.
    void remember(const Chart<Context>& c, std::size_t h, std::size_t s) {
        char* flags = recorded_.data() + recorded_at_[h];
        flags[0] = flags[s - c.states_[h].parent] = 1;
    }
    /// A history whose states cannot be active together remembers nothing.
    void check_history(const Chart<Context>& c, std::size_t h) {
        char* flags = recorded_.data() + recorded_at_[h];
        const std::size_t parent = c.states_[h].parent, end = c.states_[parent].end;
        std::fill(enters_.begin(), enters_.end(), char(0));
        for (std::size_t d = parent + 1; d < end; ++d)
            for (std::size_t up = d; flags[d - parent] && up != parent; up = c.states_[up].parent) enters_[up] = 1;
        for (std::size_t s = parent; s < end; ++s) {
            if (c.states_[s].kind != Kind::state) continue;
            std::size_t inside = 0;
            for (std::size_t child = s + 1; child < c.states_[s].end; child = c.states_[child].end)
                inside += std::size_t(enters_[child]);
            if (inside > 1) return void(std::fill(flags, flags + (end - parent), char(0)));
        }
    }

    /// Enters the initial states.
    void start(auto& machine, Context& context) {
        const auto& c = *machine.chart_;
        begin_entry();
        machine.perform(context, c.states_[0].initial_content);
        aim(c, c.states_[0].initial, 0);
        enter_all(machine, context);
    }
    /// Goes to states, silently where `stays(state)` says that it was active already.
    /// \return whether the states can be active together
    bool go_to(auto& machine, Context& context, const std::vector<std::uint16_t>& targets, auto&& stays) {
        const auto& c = *machine.chart_;
        begin_entry();
        for (const auto t : targets) descend(c, t);
        for (const auto t : targets) ascend(c, t, 0);
        for (std::size_t s = 0; s < c.state_count(); ++s)
            if ((s == 0 || enters_[s]) && c.states_[s].kind == Kind::state &&
                (c.states_[s].initial.count > 0 || c.states_[s].childless)) {
                std::size_t inside = 0;
                for (std::size_t child = s + 1; child < c.states_[s].end; child = c.states_[child].end)
                    inside += std::size_t(enters_[child]);
                if (inside != 1 && (inside != 0 || !c.states_[s].childless)) return false;
            }
        for (std::size_t s = 1; s < c.state_count(); ++s)
            if (enters_[s] && stays(s)) active_[s] = 1, enters_[s] = 0;
        enter_all(machine, context);
        return true;
    }

    /// Takes the transitions of one column (an event, conditions, at once), one for each active region at most.
    bool choose(auto& machine, Context& context, std::size_t column) {
        const auto& c = *machine.chart_;
        chosen_.clear();
        for (const auto leaf : leaves_) {
            const std::uint32_t at = c.cells_[leaf * c.columns_ + column];
            if (at == no_candidate) continue;
            for (std::uint32_t i = at; c.candidates_[i] != nowhere; ++i) {
                const auto t = c.candidates_[i];
                const bool known = std::find(chosen_.begin(), chosen_.end(), t) != chosen_.end();
                if (!known && !machine.holds(context, t)) continue;
                if (!known) chosen_.push_back(t);
                break;
            }
        }
        if (chosen_.empty()) return false;
        without_conflicts(c);
        step(machine, context);
        return true;
    }

private:
    friend struct ansatz::states::MachineArchive;
    static bool inside(const Chart<Context>& c, std::size_t outer, std::size_t inner) {
        return inner > outer && inner < c.states_[outer].end;
    }
    static bool conflict(const Chart<Context>& c, const ChartTransition& a, const ChartTransition& b) {
        if (a.stays || b.stays) return false;
        return a.domain == b.domain || inside(c, a.domain, b.domain) || inside(c, b.domain, a.domain);
    }
    // Of two that would leave the same state the inner one happens, and of two beside each other the former.
    void without_conflicts(const Chart<Context>& c) {
        kept_.clear();
        for (const auto t : chosen_) {
            const auto& mine = c.transitions_[t];
            bool preempted = false;
            for (const auto other : kept_)
                if (conflict(c, mine, c.transitions_[other]) && !inside(c, c.transitions_[other].source, mine.source))
                    preempted = true;
            if (preempted) continue;
            std::erase_if(kept_, [&](std::uint16_t other) { return conflict(c, mine, c.transitions_[other]); });
            kept_.push_back(t);
        }
    }
    void step(auto& machine, Context& context) {
        const auto& c = *machine.chart_;
        std::fill(exits_.begin(), exits_.end(), char(0));
        for (const auto t : kept_) {
            const auto& row = c.transitions_[t];
            if (row.stays) continue;
            for (std::size_t s = row.domain + 1u; s < c.states_[row.domain].end; ++s)
                exits_[s] = char(exits_[s] | active_[s]);
        }
        for (std::size_t s = 1; s < c.state_count(); ++s)
            if (exits_[s]) record(c, s);
        were_ = active_;
        try {
            for (std::size_t s = c.state_count(); s-- > 1;)
                if (exits_[s]) {
                    machine.exit(context, s);
                    active_[s] = 0;
                }
            for (const auto t : kept_) machine.took(context, t);
            begin_entry();
            for (const auto t : kept_)
                if (!c.transitions_[t].stays) aim(c, c.transitions_[t].targets, c.transitions_[t].domain);
            enter_all(machine, context);
        } catch (...) { // by an action: the same states are active as before, as without parallel states
            active_ = were_;
            throw;
        }
    }
    void record(const Chart<Context>& c, std::size_t s) {
        const auto histories = c.states_[s].histories;
        for (std::size_t i = 0; i < histories.count; ++i) {
            const std::size_t h = c.ids_[histories.first + i];
            char* flags = recorded_.data() + recorded_at_[h];
            flags[0] = 1; // something is remembered
            for (std::size_t d = s + 1; d < c.states_[s].end; ++d) {
                const bool wanted = c.states_[h].kind == Kind::deep_history
                                        ? c.states_[d].initial.count == 0 && c.states_[d].kind != Kind::parallel
                                        : c.states_[d].parent == s;
                flags[d - s] = char(wanted && active_[d] != 0);
            }
        }
    }
    void begin_entry() {
        std::fill(enters_.begin(), enters_.end(), char(0));
        std::fill(begins_.begin(), begins_.end(), char(0));
        std::fill(restored_.begin(), restored_.end(), nowhere);
    }
    void aim(const Chart<Context>& c, Range targets, std::size_t domain) {
        for (std::size_t i = 0; i < targets.count; ++i) descend(c, c.ids_[targets.first + i]);
        for (std::size_t i = 0; i < targets.count; ++i) ascend(c, c.ids_[targets.first + i], domain);
    }
    // A state and what is entered with it.
    void descend(const Chart<Context>& c, std::size_t s) {
        const auto& state = c.states_[s];
        if (is_history(state.kind)) {
            const char* flags = recorded_.data() + recorded_at_[s];
            const std::size_t parent = state.parent;
            if (!flags[0]) {
                restored_[parent] = std::uint16_t(s); // its own content is done when the parent is entered
                aim(c, state.initial, parent);
                return;
            }
            for (std::size_t d = parent + 1; d < c.states_[parent].end; ++d)
                if (flags[d - parent]) descend(c, d);
            for (std::size_t d = parent + 1; d < c.states_[parent].end; ++d)
                if (flags[d - parent]) ascend(c, d, parent);
            return;
        }
        enters_[s] = 1;
        if (state.kind == Kind::parallel) all_parts(c, s);
        else if (state.initial.count > 0) {
            begins_[s] = 1;
            aim(c, state.initial, s);
        }
    }
    // What lies between a state and the domain, with the other regions of parallel states.
    void ascend(const Chart<Context>& c, std::size_t s, std::size_t domain) {
        for (std::size_t up = c.states_[s].parent; up != domain && up != 0; up = c.states_[up].parent) {
            enters_[up] = 1;
            if (c.states_[up].kind == Kind::parallel) all_parts(c, up);
        }
    }
    void all_parts(const Chart<Context>& c, std::size_t s) {
        for (std::size_t child = s + 1; child < c.states_[s].end; child = c.states_[child].end) {
            if (is_history(c.states_[child].kind)) continue;
            if (std::none_of(enters_.begin() + std::ptrdiff_t(child),
                             enters_.begin() + std::ptrdiff_t(c.states_[child].end), [](char e) { return e != 0; }))
                descend(c, child);
        }
    }
    void enter_all(auto& machine, Context& context) {
        const auto& c = *machine.chart_;
        for (std::size_t s = 1; s < c.state_count(); ++s) {
            if (!enters_[s] || active_[s]) continue;
            active_[s] = 1;
            machine.enter(context, s);
            if (begins_[s]) machine.perform(context, c.states_[s].initial_content);
            if (restored_[s] != nowhere) machine.perform(context, c.states_[restored_[s]].initial_content);
            if (c.states_[s].kind == Kind::final) ended(machine, s);
        }
        find_leaves(c);
    }
    // The innermost active states.
    void find_leaves(const Chart<Context>& c) {
        leaves_.clear();
        for (std::size_t s = 1; s < c.state_count(); ++s) {
            const auto& state = c.states_[s];
            if (!active_[s] || state.initial.count > 0 || (state.kind == Kind::parallel && state.end != s + 1))
                continue;
            bool inside = false;
            for (std::size_t child = s + 1; state.childless && child < state.end; child = c.states_[child].end)
                inside = inside || active_[child] != 0;
            if (!inside) leaves_.push_back(std::uint16_t(s));
        }
    }
    void ended(auto& machine, std::size_t s) {
        const auto& c = *machine.chart_;
        const std::size_t parent = c.states_[s].parent;
        if (parent == 0) return;
        machine.queue_.raise(EventId(c.states_[parent].done));
        const std::size_t up = c.states_[parent].parent;
        if (up != 0 && c.states_[up].kind == Kind::parallel && is_final(c, up))
            machine.queue_.raise(EventId(c.states_[up].done));
    }
    bool is_final(const Chart<Context>& c, std::size_t s) const {
        const bool all = c.states_[s].kind == Kind::parallel;
        for (std::size_t child = s + 1; child < c.states_[s].end; child = c.states_[child].end) {
            if (is_history(c.states_[child].kind)) continue;
            const bool final = all ? is_final(c, child) : c.states_[child].kind == Kind::final && active_[child] != 0;
            if (final != all) return final;
        }
        return all;
    }

    std::vector<char> active_, were_, enters_, begins_, exits_, recorded_;
    std::vector<std::uint16_t> restored_, leaves_, chosen_, kept_;
    std::vector<std::size_t> recorded_at_;
};

} // namespace ansatz::states::detail
