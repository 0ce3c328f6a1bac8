// SPDX-License-Identifier: BSL-1.0
// 7.2.1 The Courant limit: in two dimensions it is 1/sqrt(2), not the 1 that is quoted

// Nothing may run further than a column in a step, says the rule c dt < dx. Along a channel that is so. On a grid the
// fastest thing is no wave at all: columns like a chessboard, each against its four neighbours. It swings at
// omega = c sqrt(4/dx^2 + 4/dz^2), and a step of semi-implicit Euler stays while omega dt <= 2: c dt / dx <= 1/sqrt(2).
// (A part of 7.2 that the notes do not name.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {
/// The highest column after each step, of a board of 1 mm between walls that hold, without the check of a Surface.
//! [board]
std::vector<double> highest(std::size_t nx, std::size_t nz, double courant, int steps) {
    const ColumnGrid grid(nx, nz, 1.0 * metre);
    const WaterColumns columns{.wave_speed = 1.0 * metre_per_second, .walls = Walls::all(Wall::holds)};
    const WaterColumns::In<double> loop(columns, grid, 0.0 * metre); // the loop by itself, which checks nothing
    std::vector<double> height(grid.size()), rate(grid.size()), most;
    for (std::size_t n = 0; n < grid.size(); ++n) height[n] = (n % nx + n / nx) % 2 ? -1e-3 : 1e-3;
    for (int n = 0; n < steps; ++n) {
        loop.advance(height, rate, courant * second); // 1 m, 1 m/s: the Courant number is dt
        most.push_back(std::abs(*std::max_element(height.begin(), height.end())));
    }
    return most;
}
//! [board]
} // namespace

int main() {
    workbook::Claims claim;
    const int steps = 600;
    const auto below = highest(16, 16, 0.7071, steps), above = highest(16, 16, 0.708, steps);
    const auto channel = highest(16, 1, 0.9999, steps), beyond = highest(16, 1, 1.01, steps);
    auto most = [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); };
    std::cout << "A chessboard of 1 mm after " << steps << " steps\n"
              << "  on a grid, C = 0.7071: never above " << most(below) << " m\n"
              << "  on a grid, C = 0.708:  " << above.back() << " m\n"
              << "  in a channel, C = 0.9999: never above " << most(channel) << " m\n"
              << "  in a channel, C = 1.01:   " << beyond.back() << " m\n";
    claim("just below 1/sqrt(2) a grid stays", most(below) < 0.25);
    claim("just above it explodes", above.back() > 1e6);
    claim("in a channel the limit is 1", most(channel) < 0.25 && beyond.back() > 1e6);

    std::vector<double> number;
    for (int n = 1; n <= steps; ++n) number.push_back(n);
    workbook::Plot plot("7.2.1", "The same chessboard, with steps that differ by 0.13 %");
    plot.x("step").y("highest column in metres").log_y().y_range(1e-4, 1e8);
    plot.line("C = 0.7071", number, below).line("C = 0.708", number, above).write();
    return claim.result();
}
