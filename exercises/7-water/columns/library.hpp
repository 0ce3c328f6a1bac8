// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <span>
#include <vector>

namespace exercise {

inline ansatz::Quantity<ansatz::unit::Volume> volume(ansatz::Quantity<ansatz::unit::Length> height,
                                                     ansatz::Quantity<ansatz::unit::Length> dx,
                                                     ansatz::Quantity<ansatz::unit::Length> dz) {
    const ansatz::ColumnGrid grid(3, 3, dx, dz);
    std::vector<double> heights(9, 0.0);
    heights[grid.index(1, 1)] = height.value();
    return grid.volume(std::span<const double>(heights));
}

struct Neighbours {
    ansatz::Quantity<ansatz::unit::Length> west, east, south, north;
};

/// One pass of the library's loop over nine columns; that in the middle is asked for.
inline ansatz::Quantity<ansatz::unit::Velocity>
next_rate(ansatz::Quantity<ansatz::unit::Velocity> rate, ansatz::Quantity<ansatz::unit::Length> height,
          const Neighbours& around, ansatz::Quantity<ansatz::unit::Velocity> c,
          ansatz::Quantity<ansatz::unit::Length> width, ansatz::Quantity<ansatz::unit::Time> dt) {
    const ansatz::ColumnGrid grid(3, 3, width);
    const ansatz::WaterColumns::In<double> loop(ansatz::WaterColumns{c}, grid, 0.0 * ansatz::metre);
    std::vector<double> heights(9, height.value()), rates(9, 0.0);
    heights[grid.index(0, 1)] = around.west.value();
    heights[grid.index(2, 1)] = around.east.value();
    heights[grid.index(1, 0)] = around.south.value();
    heights[grid.index(1, 2)] = around.north.value();
    rates[grid.index(1, 1)] = rate.value();
    loop.advance(heights, rates, dt);
    return rates[grid.index(1, 1)] * ansatz::metre_per_second;
}

inline ansatz::Quantity<ansatz::unit::Time> longest_step(ansatz::Quantity<ansatz::unit::Velocity> c,
                                                         ansatz::Quantity<ansatz::unit::Length> dx,
                                                         ansatz::Quantity<ansatz::unit::Length> dz) {
    return ansatz::Surface(ansatz::WaterColumns{c}, ansatz::ColumnGrid(3, 3, dx, dz), 1.0 * ansatz::metre)
        .longest_step();
}

/// Nine level columns, of which that in the middle rises.
inline ansatz::Quantity<ansatz::unit::Velocity> damped(ansatz::Quantity<ansatz::unit::Velocity> rate,
                                                       ansatz::Quantity<ansatz::unit::Frequency> damping,
                                                       ansatz::Quantity<ansatz::unit::Time> dt) {
    using namespace ansatz;
    const ColumnGrid grid(3, 3, 1.0 * metre);
    const WaterColumns::In<double> loop(WaterColumns{1.0 * metre_per_second, damping}, grid, 0.0 * metre);
    std::vector<double> heights(9, 1.0), rates(9, 0.0);
    rates[grid.index(1, 1)] = rate.value();
    loop.advance(heights, rates, dt);
    return rates[grid.index(1, 1)] * metre_per_second;
}

} // namespace exercise
