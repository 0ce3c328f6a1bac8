// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of chapter 7 share: grids, and heights by a function.

#include <ansatz/water/surface.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace water_tests {

using namespace ansatz;
using namespace ansatz::test;
using Catch::Approx;
using Length = Quantity<unit::Length>;
inline constexpr double pi = std::numbers::pi;
inline constexpr auto mps = 1.0 * metre_per_second;
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Widths that differ, between 0.5 m and 1.5 m.
inline std::vector<Length> widths(std::size_t count, double phase) {
    std::vector<Length> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back((1 + 0.5 * std::sin(1.7 * double(i) + phase)) * metre);
    return all;
}
inline ColumnGrid unequal(std::size_t nx, std::size_t nz) { return ColumnGrid(widths(nx, 0.3), widths(nz, 1.1)); }

/// Sets the height of each column by a function of its centre, m of (m, m).
template <class Surface_, class F> void set_heights(Surface_& water, F&& height) {
    const auto& grid = water.grid();
    using Height = typename Surface_::Height;
    for (std::size_t j = 0; j < grid.columns_z(); ++j)
        for (std::size_t i = 0; i < grid.columns_x(); ++i)
            water.set_height(i, j,
                             Height::from_value(typename Height::value_type(
                                 height(grid.centre_x(i).value(), grid.centre_z(j).value()))));
}
/// The slope of the last two of a list of errors, where the grid is twice as fine each time.
inline double order(const std::vector<double>& errors) { return std::log2(errors[errors.size() - 2] / errors.back()); }

} // namespace water_tests
