// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

using namespace ansatz;

namespace exercise {

/// Two boxes by their indices; the first is the smaller.
using Pair = std::pair<std::size_t, std::size_t>;

/// The axis, 0, 1 or 2, along which the points are spread most: that of the largest variance. Of equal ones the first.
/// There is one point at least.
inline int widest_axis(const std::vector<VectorQuantity<unit::Length, 3>>& points) {
    return todo(1);
}

/// The indices of the bodies in the order in which they begin, on one axis; those that begin in one place by their
/// index.
inline std::vector<std::size_t> sorted(const std::vector<Quantity<unit::Length>>& lower) {
    return todo(2);
}

/// 2.1.1.4: all pairs that overlap on the axis, ends included, by one pass over the bodies in `order`, in which they
/// begin. Each pair that is tested calls `look()` once; for 1000 bodies in a row that is a few thousand times, not
/// 499 500.
inline std::vector<Pair> sweep(const std::vector<std::size_t>& order, const std::vector<Quantity<unit::Length>>& lower,
                               const std::vector<Quantity<unit::Length>>& upper, const std::function<void()>& look) {
    return todo(3);
}

} // namespace exercise
