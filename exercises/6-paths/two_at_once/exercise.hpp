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
    return todo(1);
}

/// An estimate of the steps until both are at their goals: as much as can be said without regard to walls or to the
/// other, and never too much. In a step both walk.
inline int estimate(const Both& now, const Both& goals) {
    return todo(2);
}

} // namespace exercise
