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
    // task 1: return todo(1);
    return low_a <= high_b && low_b <= high_a;
    // end of task 1
}

/// 2.1.1.1: whether two boxes touch.
inline bool touch(const Box& a, const Box& b) {
    // task 2: return todo(2);
    bool all = true;
    for (int k = 0; k < 3; ++k)
        all = all && component(a.lower, k) <= component(b.upper, k) && component(b.lower, k) <= component(a.upper, k);
    return all;
    // end of task 2
}

/// Each pair of boxes that touch, once, in any order.
inline std::vector<Pair> touching_pairs(const std::vector<Box>& boxes) {
    // task 3: return todo(3);
    auto meet = [](const Box& a, const Box& b) {
        return (a.lower.value().array() <= b.upper.value().array()).all() &&
               (b.lower.value().array() <= a.upper.value().array()).all();
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (meet(boxes[i], boxes[j])) pairs.emplace_back(i, j);
    return pairs;
    // end of task 3
}

} // namespace exercise
