// SPDX-License-Identifier: BSL-1.0
// 7 Why not everything: what the full equations cost, counted in numbers and in operations, beside a surface and a
// formula

// The correct way to simulate a fluid is the equation of Navier and Stokes in a volume: N^3 cells with a velocity and a
// pressure, and in each step a pressure that keeps the fluid from being squeezed, for which every cell must hear of
// every other. A surface has N^2 columns, a sum of sines has none. Counted here, and timed: one sweep for the pressure,
// of the many that a step needs, against a whole step of the columns.

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {
/// The least time of a few runs, s.
template <class F> double least_time(F&& f) {
    double least = 1e9;
    for (int n = 0; n < 7; ++n) {
        const auto start = std::chrono::steady_clock::now();
        f();
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return least;
}

/// One Jacobi sweep of the pressure in N^3 cells: the mean of six neighbours less the divergence.
//! [sweep]
void sweep(std::size_t n, const std::vector<float>& pressure, const std::vector<float>& divergence,
           std::vector<float>& next) {
    for (std::size_t k = 1; k + 1 < n; ++k)
        for (std::size_t j = 1; j + 1 < n; ++j)
            for (std::size_t i = 1; i + 1 < n; ++i) {
                const std::size_t c = (k * n + j) * n + i;
                next[c] = (pressure[c - 1] + pressure[c + 1] + pressure[c - n] + pressure[c + n] + pressure[c - n * n] +
                           pressure[c + n * n] - divergence[c]) /
                          6;
            }
}
//! [sweep]
} // namespace

int main() {
    workbook::Claims claim;
    std::vector<double> sides, volume, surface, formula;
    workbook::Columns table({"N", "numbers in a volume", "of a surface", "of four waves"});
    for (const std::size_t n : {16U, 32U, 64U, 128U}) {
        // Velocity and pressure in each cell; height and rate in each column; length, height, direction, phase.
        const std::size_t in_volume = 4 * n * n * n, in_surface = 2 * n * n, in_formula = 16;
        table.row(n, in_volume, in_surface, in_formula);

        std::vector<float> pressure(n * n * n), divergence(n * n * n, 0.1F), next(n * n * n);
        sides.push_back(double(n));
        volume.push_back(least_time([&] {
            sweep(n, pressure, divergence, next);
            std::swap(pressure, next);
        }));
        Surface<WaterColumns, float> water{{1.0 * metre_per_second}, ColumnGrid(n, n, 1.0 * metre), 1.0 * metre};
        water.set_height(n / 2, n / 2, Quantity<unit::Length, float>::from_value(1.5F));
        surface.push_back(least_time([&] { water.step(0.5 * second); }));
        const Waves waves({{7.0 * metre, 0.2 * metre},
                           {5.0 * metre, 0.1 * metre, 1.0},
                           {3.0 * metre, 0.1 * metre, 2.0},
                           {2.0 * metre, 0.1 * metre, -1.0}});
        std::vector<float> heights(n * n);
        formula.push_back(least_time([&] {
            waves.fill(std::span<float>(heights), n, n, 0.0 * metre, 0.0 * metre, 1.0 * metre, 1.0 * metre,
                       1.0 * second);
        }));
    }
    // How many sweeps are needed: an error as long as the box shrinks by cos(pi/N) with each.
    std::cout << table;
    const double rate = std::cos(3.14159265358979 / 128);
    const double sweeps = std::log(0.01) / std::log(rate);
    workbook::say() << "In 128^3 cells a sweep leaves " << rate
                    << " of an error as long as the box: to a hundredth of it, " << std::round(sweeps) << " sweeps\n";
    claim("thousands of sweeps, where nothing better is used", sweeps > 1e4);
    const double against_columns = volume.back() / surface.back(), against_waves = volume.back() / formula.back();
    claim("one sweep of them takes more than ten steps of columns", against_columns > 10);
    claim("and more than four maps of four waves", against_waves > 4);

    workbook::Plot plot("7", "One sweep for the pressure in a volume, one step of a surface, one map of four waves");
    plot.x("N").y("time in seconds").log_x().log_y();
    plot.linked_points("N^3, one sweep", sides, volume)
        .linked_points("N^2, a whole step", sides, surface)
        .linked_points("four waves", sides, formula)
        .write();
    return claim.result();
}
