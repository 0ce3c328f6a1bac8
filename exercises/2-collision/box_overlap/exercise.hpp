// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cstddef>
#include <utility>
#include <vector>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;

/// A bounding box: from its lower corner to its upper one, axis by axis.
struct Box {
    VectorQuantity<unit::Length, 3> lower, upper;
};

/// Two boxes of a list, by their places in it; the first is the smaller.
using Pair = std::pair<std::size_t, std::size_t>;

/// Whether two stretches of one axis have a point in common. Stretches are closed: their ends belong to them.
inline bool overlap(Length low_a, Length high_a, Length low_b, Length high_b) {
    return todo(1);
}

/// 2.1.1.1: whether two boxes touch.
inline bool touch(const Box& a, const Box& b) {
    return todo(2);
}

/// Each pair of boxes that touch, once, in any order.
inline std::vector<Pair> touching_pairs(const std::vector<Box>& boxes) {
    return todo(3);
}

} // namespace exercise
