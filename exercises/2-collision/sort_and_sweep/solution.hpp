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
    // task 1: return todo(1);
    auto mean = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) mean += points[i];
    mean /= double(points.size());
    auto variance = [&](int k) {
        auto sum = 0.0 * metre * metre;
        for (const auto& point : points)
            sum += (component(point, k) - component(mean, k)) * (component(point, k) - component(mean, k));
        return sum;
    };
    int widest = 0;
    for (int k = 1; k < 3; ++k)
        if (variance(k) > variance(widest)) widest = k;
    return widest;
    // end of task 1
}

/// The indices of the bodies in the order in which they begin, on one axis; those that begin in one place by their
/// index.
inline std::vector<std::size_t> sorted(const std::vector<Quantity<unit::Length>>& lower) {
    // task 2: return todo(2);
    std::vector<std::size_t> order(lower.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return lower[a] < lower[b] || (lower[a] == lower[b] && a < b); });
    return order;
    // end of task 2
}

/// 2.1.1.4: all pairs that overlap on the axis, ends included, by one pass over the bodies in `order`, in which they
/// begin. Each pair that is tested calls `look()` once; for 1000 bodies in a row that is a few thousand times, not
/// 499 500.
inline std::vector<Pair> sweep(const std::vector<std::size_t>& order, const std::vector<Quantity<unit::Length>>& lower,
                               const std::vector<Quantity<unit::Length>>& upper, const std::function<void()>& look) {
    // task 3: return todo(3);
    std::vector<Pair> pairs;
    for (std::size_t p = 0; p < order.size(); ++p)
        for (std::size_t q = p + 1; q < order.size(); ++q) {
            look();
            if (lower[order[q]] > upper[order[p]]) break; // and so do all that follow
            pairs.emplace_back(std::min(order[p], order[q]), std::max(order[p], order[q]));
        }
    return pairs;
    // end of task 3
}

} // namespace exercise
