// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace exercise {

/// A tile: column and row.
struct Place {
    int x = 0, y = 0;
    bool operator==(const Place&) const = default;
};
/// Row by row: '.' is free, '#' a wall. Outside of it is nothing.
using Room = std::vector<std::string>;
/// Where two agents are in one step: a node of the graph of both.
struct Both {
    Place a, b;
    bool operator==(const Both&) const = default;
};

/// 6.3.4: where both can be one step later: the edges of that graph. Each goes to one of the four tiles beside, or
/// waits. They may not be in one tile, nor change places. In any order; whether the pair in which both wait is among
/// them does not matter, for it leads nowhere.
inline std::vector<Both> next_pairs(const Room& room, const Both& now) {
    // task 1: return todo(1);
    const auto next_places = [&](Place p) {
        const int rows = int(room.size()), columns = int(room[0].size());
        std::vector<Place> places;
        for (const Place to : {p, Place{p.x + 1, p.y}, {p.x, p.y + 1}, {p.x - 1, p.y}, {p.x, p.y - 1}})
            if (to.x >= 0 && to.y >= 0 && to.x < columns && to.y < rows)
                if (room[std::size_t(to.y)][std::size_t(to.x)] == '.') places.push_back(to);
        return places;
    };
    std::vector<Both> pairs;
    for (const Place a : next_places(now.a))
        for (const Place b : next_places(now.b)) {
            const bool in_one_tile = a == b, change_places = a == now.b && b == now.a;
            if (!in_one_tile && !change_places) pairs.push_back({a, b});
        }
    return pairs;
    // end of task 1
}

/// An estimate of the steps until both are at their goals: as much as can be said without regard to walls or to the
/// other, and never too much. In a step both walk.
inline int estimate(const Both& now, const Both& goals) {
    // task 2: return todo(2);
    const auto steps = [](Place from, Place to) { return std::abs(from.x - to.x) + std::abs(from.y - to.y); };
    return std::max(steps(now.a, goals.a), steps(now.b, goals.b));
    // end of task 2
}

} // namespace exercise
