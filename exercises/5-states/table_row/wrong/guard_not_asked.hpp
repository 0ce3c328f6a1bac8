// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the guard was not asked
// Why:     The first row of the state and the event is taken, whether its guard holds or not: a single coin unlocks.
// Read:    5.1
// Fails:   guard, does

#include <cstddef>
#include <vector>

namespace exercise {

/// A turnstile takes two coins and lets one person through.
enum class State { locked, unlocked };
enum class Event { coin, push, kick };
struct Gate {
    int coins = 0;    ///< paid and not yet used
    int passed = 0;   ///< who went through
    int returned = 0; ///< coins that were given back
};

/// A row: in `from`, on `event`, if `guard` is empty or holds, `action` is done if there is one, and the state is `to`.
struct Row {
    State from;
    Event event;
    bool (*guard)(const Gate&);
    void (*action)(Gate&);
    State to;
};
using Rows = std::vector<Row>;

/// 5.1: which row answers an event: the first one that fits. -1 where there is none.
inline int row_for(const Rows& rows, State state, Event event, const Gate& gate) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        if (row.from == state && row.event == event) return int(i);
    }
    return -1;
}

/// The state after an event, with what is done on the way.
inline State handle(const Rows& rows, State state, Event event, Gate& gate) {
    const int i = row_for(rows, state, event, gate);
    if (i < 0) return state;
    if (rows[std::size_t(i)].action != nullptr) rows[std::size_t(i)].action(gate);
    return rows[std::size_t(i)].to;
}

} // namespace exercise
