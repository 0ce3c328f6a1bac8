// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace exercise {

using Pair = ansatz::IndexPair;
using Lengths = std::vector<ansatz::Quantity<ansatz::unit::Length>>;
using Sweep = ansatz::SortAndSweep::In<ansatz::Space<>>;

inline ansatz::Boxes<ansatz::Space<>> on_a_line(const Lengths& lower, const Lengths& upper) {
    ansatz::Boxes<ansatz::Space<>> boxes;
    for (std::size_t i = 0; i < lower.size(); ++i)
        boxes.push_back(ansatz::metres(lower[i].value(), 0, 0), ansatz::metres(upper[i].value(), 0, 0));
    boxes.set_active(boxes.size());
    return boxes;
}
inline int widest_axis(const std::vector<ansatz::VectorQuantity<ansatz::unit::Length, 3>>& points) {
    ansatz::Boxes<ansatz::Space<>> boxes;
    for (const auto& point : points) boxes.push_back(point, point);
    Sweep sweep(ansatz::SortAndSweep{});
    sweep.order(boxes);
    return sweep.axis();
}
inline std::vector<std::size_t> sorted(const Lengths& lower) {
    Sweep sweep(ansatz::SortAndSweep{});
    const std::uint32_t* order = sweep.order(on_a_line(lower, lower));
    return lower.empty() ? std::vector<std::size_t>() : std::vector<std::size_t>(order, order + lower.size());
}
/// The library does both in one go, and counts nothing: what is counted here are the pairs that it reports.
inline std::vector<Pair> sweep(const std::vector<std::size_t>&, const Lengths& lower, const Lengths& upper,
                               const std::function<void()>& look) {
    std::vector<Pair> pairs;
    Sweep(ansatz::SortAndSweep{}).find(on_a_line(lower, upper), [&](std::size_t i, std::size_t j) {
        look();
        pairs.emplace_back(i, j);
    });
    return pairs;
}

} // namespace exercise
