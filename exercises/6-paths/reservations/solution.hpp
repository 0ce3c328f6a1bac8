// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace exercise {

/// A tile: column and row.
struct Place {
    int x = 0, y = 0;
    bool operator==(const Place&) const = default;
};
/// Where somebody is in each step, from step 0 on. Behind the last one it stays where it is.
using Plan = std::vector<Place>;
/// Row by row: '.' is free, '#' a wall. Outside of it is nothing.
using Room = std::vector<std::string>;

/// 6.3.10: where somebody with this plan is in a step, however late.
inline Place place_at(const Plan& plan, std::size_t step) {
    // task 1: return todo(1);
    return plan[std::min(step, plan.size() - 1)];
    // end of task 1
}

/// Whether one who is at `from` in this step can be at `to`, a neighbour or the same tile, in the next: nobody else is
/// there then, and nobody comes the other way.
inline bool is_free(const std::vector<Plan>& reserved, Place from, Place to, std::size_t step) {
    // task 2: return todo(2);
    for (const Plan& plan : reserved) {
        const Place before = place_at(plan, step), after = place_at(plan, step + 1);
        if (after == to) return false;
        if (before == to && after == from) return false;
    }
    return true;
    // end of task 2
}

/// Where one who is at `at` in this step can be in the next: on a free tile beside it, or there still.
inline std::vector<Place> next_places(const Room& room, const std::vector<Plan>& reserved, Place at, std::size_t step) {
    // task 3: return todo(3);
    const int rows = int(room.size()), columns = int(room[0].size());
    std::vector<Place> next;
    for (const Place to : {Place{at.x + 1, at.y}, {at.x, at.y + 1}, {at.x - 1, at.y}, {at.x, at.y - 1}, at}) {
        if (to.x < 0 || to.y < 0 || to.x >= columns || to.y >= rows) continue;
        if (room[std::size_t(to.y)][std::size_t(to.x)] == '#') continue;
        if (is_free(reserved, at, to, step)) next.push_back(to);
    }
    return next;
    // end of task 3
}

/// Whether one who comes to `goal` in this step can stay for ever.
inline bool can_stay(const std::vector<Plan>& reserved, Place goal, std::size_t step) {
    // task 4: return todo(4);
    for (const Plan& plan : reserved)
        for (std::size_t later = step; later < std::max(step + 1, plan.size()); ++later)
            if (place_at(plan, later) == goal) return false;
    return true;
    // end of task 4
}

} // namespace exercise
