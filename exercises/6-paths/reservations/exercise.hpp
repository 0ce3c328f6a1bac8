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
    return todo(1);
}

/// Whether one who is at `from` in this step can be at `to`, a neighbour or the same tile, in the next: nobody else is
/// there then, and nobody comes the other way.
inline bool is_free(const std::vector<Plan>& reserved, Place from, Place to, std::size_t step) {
    return todo(2);
}

/// Where one who is at `at` in this step can be in the next: on a free tile beside it, or there still.
inline std::vector<Place> next_places(const Room& room, const std::vector<Plan>& reserved, Place at, std::size_t step) {
    return todo(3);
}

/// Whether one who comes to `goal` in this step can stay for ever.
inline bool can_stay(const std::vector<Plan>& reserved, Place goal, std::size_t step) {
    return todo(4);
}

} // namespace exercise
