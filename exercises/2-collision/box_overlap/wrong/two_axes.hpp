// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the third axis forgotten
// Why:     In a plane there are two. In space, what lies above something else does not touch it.
// Read:    2.1.1.1
// Fails:   one-axis-apart

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
    return low_a <= high_b && low_b <= high_a;
}

/// 2.1.1.1: whether two boxes touch.
inline bool touch(const Box& a, const Box& b) {
    bool all = true;
    for (int k = 0; k < 2; ++k) all = all && component(a.lower, k) <= component(b.upper, k) && component(b.lower, k) <= component(a.upper, k);
    return all;
}

/// Each pair of boxes that touch, once, in any order.
inline std::vector<Pair> touching_pairs(const std::vector<Box>& boxes) {
    auto meet = [](const Box& a, const Box& b) {
        return (a.lower.value().array() <= b.upper.value().array()).all() && (b.lower.value().array() <= a.upper.value().array()).all();
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (meet(boxes[i], boxes[j])) pairs.emplace_back(i, j);
    return pairs;
}

} // namespace exercise
