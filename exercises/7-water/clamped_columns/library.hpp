// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: a channel of columns as wide as the footprints say, one metre across.
#include <ansatz/water/clamped_columns.hpp>
#include <ansatz/world.hpp>

#include <span>
#include <vector>

namespace exercise {

struct Column {
    ansatz::Quantity<ansatz::unit::Length> height;
    ansatz::Quantity<ansatz::unit::Area> footprint;
};
using Columns = std::vector<Column>;

inline ansatz::ColumnGrid channel(const Columns& columns) {
    std::vector<ansatz::Quantity<ansatz::unit::Length>> widths;
    for (const Column& c : columns) widths.push_back(c.footprint / (1.0 * ansatz::metre));
    return ansatz::ColumnGrid(widths, {1.0 * ansatz::metre});
}
inline std::vector<double> heights(const Columns& columns) {
    std::vector<double> all;
    for (const Column& c : columns) all.push_back(c.height.value());
    return all;
}

inline ansatz::Quantity<ansatz::unit::Volume> volume(const Columns& columns) {
    const auto all = heights(columns);
    return channel(columns).volume(std::span<const double>(all));
}

inline ansatz::Quantity<ansatz::unit::Volume> clamped(Columns& columns, const ansatz::Clamp& range) {
    auto all = heights(columns);
    std::vector<double> rates(all.size(), 0.0);
    const auto left = ansatz::clamp_columns(range, channel(columns), std::span<double>(all), std::span<double>(rates));
    for (std::size_t n = 0; n < all.size(); ++n) columns[n].height = all[n] * ansatz::metre;
    return left;
}

inline ansatz::Quantity<ansatz::unit::Volume> cut(Columns& columns, ansatz::Quantity<ansatz::unit::Length> low,
                                                  ansatz::Quantity<ansatz::unit::Length> high) {
    return clamped(columns, {low, high, ansatz::Excess::counted});
}

inline ansatz::Quantity<ansatz::unit::Volume> clamp(Columns& columns, ansatz::Quantity<ansatz::unit::Length> low,
                                                    ansatz::Quantity<ansatz::unit::Length> high) {
    return clamped(columns, {low, high, ansatz::Excess::spread});
}

} // namespace exercise
