// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/water/ring.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <vector>

namespace exercise {

struct Column {
    ansatz::Quantity<ansatz::unit::Length> height;
    ansatz::Quantity<ansatz::unit::Area> footprint;
    double part;
};
using Columns = std::vector<Column>;

/// Calls `f(ring, how many columns are in front of those of the exercise)`. They lie in a channel behind two that are
/// dry: the body, a point, is in the first of them, and the second keeps it so far away that the library's own ring
/// takes the others wholly. How much of a column belongs to it is then what the ring is told of its water.
template <class F> auto with_ring(const Columns& columns, F&& f) {
    auto length = 0.0 * ansatz::square_metre;
    for (const Column& c : columns) length += c.footprint;
    const auto cell = length / (1.0 * ansatz::metre);
    std::vector<ansatz::Quantity<ansatz::unit::Length>> widths = {cell, cell};
    for (const Column& c : columns) widths.push_back(c.footprint / (1.0 * ansatz::metre));
    const ansatz::ColumnGrid grid(widths, {1.0 * ansatz::metre});
    const auto wet = [&](std::size_t n) { return n < 2 ? 0.0 : columns[n - 2].part; };
    const ansatz::Footprint foot{.x = 0.99 * cell.value(), .z = 0.5};
    const ansatz::WaterRing ring(grid, foot, wet);
    return f(ring, std::size_t(2));
}

inline std::vector<double> shares(const Columns& columns) {
    return with_ring(columns, [&](const auto& ring, std::size_t before) {
        std::vector<double> all(columns.size(), 0.0);
        ring.each([&](std::size_t n, double share) { all[n - before] += share; });
        return all;
    });
}

inline void press_up(Columns& columns, ansatz::Quantity<ansatz::unit::Volume> volume) {
    with_ring(columns, [&](const auto& ring, std::size_t before) {
        ring.each_with_area([&](std::size_t n, double share, double area) {
            columns[n - before].height += share * volume.value() / area * ansatz::metre;
        });
        return 0;
    });
}

inline ansatz::Quantity<ansatz::unit::Length> level(const Columns& columns) {
    return with_ring(columns, [&](const auto& ring, std::size_t before) {
        auto sum = 0.0 * ansatz::metre;
        ring.each([&](std::size_t n, double share) { sum += share * columns[n - before].height; });
        return sum;
    });
}

inline ansatz::Quantity<ansatz::unit::Volume> displaced(const Columns& columns,
                                                        ansatz::Quantity<ansatz::unit::Area> section,
                                                        ansatz::Quantity<ansatz::unit::Length> bottom) {
    const double depth = std::max(0.0, (level(columns) - bottom).value());
    return with_ring(columns, [&](const auto& ring, std::size_t) {
        return section.value() * depth / (1 - section.value() * ring.feedback()) * ansatz::cubic_metre;
    });
}

} // namespace exercise
