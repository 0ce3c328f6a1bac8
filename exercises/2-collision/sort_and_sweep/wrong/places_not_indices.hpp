// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the place of each body in place of the body at each place
// Why:     Which body is first, and at which place the first body is, are different questions. The one list undoes
//         the other.
// Read:    2.1.1.4
// Fails:   in-order, ties

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

/// The axis, 0, 1 or 2, along which the points are spread most: that of the largest variance. Of equal ones the first. There
/// is one point at least.
inline int widest_axis(const std::vector<VectorQuantity<unit::Length, 3>>& points) {
    auto mean = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) mean += points[i];
    mean /= double(points.size());
    auto variance = [&](int k) {
        auto sum = 0.0 * metre * metre;
        for (const auto& point : points) sum += (component(point, k) - component(mean, k)) * (component(point, k) - component(mean, k));
        return sum;
    };
    int widest = 0;
    for (int k = 1; k < 3; ++k)
        if (variance(k) > variance(widest)) widest = k;
    return widest;
}

/// The indices of the bodies in the order in which they begin, on one axis; those that begin in one place by their index.
inline std::vector<std::size_t> sorted(const std::vector<Quantity<unit::Length>>& lower) {
    std::vector<std::size_t> order(lower.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lower[a] < lower[b] || (lower[a] == lower[b] && a < b); });
    std::vector<std::size_t> place(order.size());
    for (std::size_t p = 0; p < order.size(); ++p) place[order[p]] = p;
    return place;
}

/// 2.1.1.4: all pairs that overlap on the axis, ends included, by a sweep over the bodies in `order`, in which they begin.
/// Each pair that is looked at calls `look()` once; for 1000 bodies in a row that is a few thousand times, not 499 500.
inline std::vector<Pair> sweep(const std::vector<std::size_t>& order, const std::vector<Quantity<unit::Length>>& lower,
                               const std::vector<Quantity<unit::Length>>& upper, const std::function<void()>& look) {
    std::vector<Pair> pairs;
    for (std::size_t p = 0; p < order.size(); ++p)
        for (std::size_t q = p + 1; q < order.size(); ++q) {
            look();
            if (lower[order[q]] > upper[order[p]]) break; // and so do all that follow
            pairs.emplace_back(std::min(order[p], order[q]), std::max(order[p], order[q]));
        }
    return pairs;
}

} // namespace exercise
