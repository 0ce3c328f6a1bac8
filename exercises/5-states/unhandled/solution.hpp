// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace exercise {

/// What is done on an event. `source` handles it while it is active, itself or by a state in it.
struct Transition {
    int source;
    std::string event;
    bool holds; ///< whether its guard holds now
    int target; ///< where it leads; -1: nowhere, something is done and the machine stays
};
/// A machine: the parent of each state, and its transitions. State 0 is the machine itself, around all others; it has
/// no parent: -1.
struct Chart {
    std::vector<int> parents;
    std::vector<Transition> transitions;
};
/// An event that came in a state and that nobody handled there.
struct Unhandled {
    int state;
    std::string event;
    bool operator==(const Unhandled&) const = default;
};

/// 5.2: whether anybody handles the event while `innermost`, a state without states in it, is active.
inline bool handled(const Chart& chart, int innermost, const std::string& event) {
    // task 1: return todo(1);
    for (int s = innermost; s >= 0; s = chart.parents[std::size_t(s)])
        for (const Transition& t : chart.transitions)
            if (t.source == s && t.event == event && t.holds) return true;
    return false;
    // end of task 1
}

/// What nobody can ever handle: each state without states in it, with each of the events for which neither it nor a
/// state around it has a transition, whatever the guards say. In any order.
inline std::vector<Unhandled> never_handled(const Chart& chart, const std::vector<std::string>& events) {
    // task 2: return todo(2);
    const auto has_transition = [&](int innermost, const std::string& event) {
        for (int s = innermost; s >= 0; s = chart.parents[std::size_t(s)])
            for (const Transition& t : chart.transitions)
                if (t.source == s && t.event == event) return true;
        return false;
    };
    std::vector<Unhandled> all;
    for (int s = 0; s < int(chart.parents.size()); ++s) {
        const bool has_states_in_it = std::count(chart.parents.begin(), chart.parents.end(), s) > 0;
        if (has_states_in_it) continue;
        for (const std::string& event : events)
            if (!has_transition(s, event)) all.push_back({s, event});
    }
    return all;
    // end of task 2
}

/// The last four unhandled events. Its memory is an array that never grows, for a game may run for days.
struct Log {
    std::array<Unhandled, 4> kept{};
    std::size_t count = 0; ///< how many there were since the game began, those that are forgotten among them
};
/// Notes one more; of those that are kept the oldest is forgotten where there is no room.
inline void note(Log& log, const Unhandled& one) {
    // task 3: todo(3);
    log.kept[log.count % log.kept.size()] = one;
    ++log.count;
    // end of task 3
}
/// Those that are kept, the oldest first.
inline std::vector<Unhandled> last(const Log& log) {
    // task 3: return todo(3);
    const std::size_t size = std::min(log.count, log.kept.size());
    std::vector<Unhandled> all;
    for (std::size_t i = log.count - size; i < log.count; ++i) all.push_back(log.kept[i % log.kept.size()]);
    return all;
    // end of task 3
}

} // namespace exercise
