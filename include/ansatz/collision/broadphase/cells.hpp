// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How wide the cells of a grid must be for a box, and how a coordinate is rounded down to its cell (notes 2.1.1,
/// "World Partitioning"): what `UniformGrid` and `StillBoxes` have in common.

#include <ansatz/core/compiler_flags.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ansatz::detail {

/// The whole number below: of numbers that are below 2^41 in size. `std::floor` is a call where the processor is not
/// known to have it.
[[gnu::always_inline]] inline std::int64_t floor_of(double x) {
    const auto whole = std::int64_t(x);
    return whole - std::int64_t(x < double(whole));
}

/// How wide a cell must be at least, so that a box reaches into the next one at most and its cell is exact.
/// \param low, high functions of an axis: its ends, m
/// \return not a number, where a number is not finite: then no cell is wide enough
[[gnu::always_inline]] inline double cell_needed(int dimension, const auto& low, const auto& high) {
    constexpr double margin = 1 + 1.0 / 1024;    // of a cell: more than rounding down can be wrong by
    constexpr double exact = 1.0 / (1ull << 38); // a coordinate of so many cells is known to 1/4096 of a cell
    double widest = 0, farthest = 0, wrong = 0;  // 0, or 0 / 0
    for (int k = 0; k < dimension; ++k) {
        const double lower = double(low(k)), upper = double(high(k));
        const double width = upper - lower, far = std::max(std::abs(lower), std::abs(upper));
        widest = width > widest ? width : widest;
        farthest = far > farthest ? far : farthest;
        wrong += (lower - lower) + (upper - upper);
    }
    return std::max(widest * margin, farthest * exact) + wrong;
}

} // namespace ansatz::detail
