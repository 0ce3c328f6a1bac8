// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

namespace exercise {

/// What a column of water holds, in m^3. y points up; the column stands on dx by dz.
inline Quantity<unit::Volume> volume(Quantity<unit::Length> height, Quantity<unit::Length> dx,
                                     Quantity<unit::Length> dz) {
    // task 1: return todo(1);
    return height * dx * dz;
    // end of task 1
}

/// Heights of the four columns around one.
struct Neighbours {
    Quantity<unit::Length> west, east, south, north;
};

/// 7.2: how fast a column rises after a step, in m/s. Columns are `width` by `width`, waves travel at `c`.
inline Quantity<unit::Velocity> next_rate(Quantity<unit::Velocity> rate, Quantity<unit::Length> height,
                                          const Neighbours& around, Quantity<unit::Velocity> c,
                                          Quantity<unit::Length> width, Quantity<unit::Time> dt) {
    // task 2: return todo(2);
    const auto pull = around.west + around.east + around.south + around.north - 4.0 * height;
    return rate + c * c * pull / (width * width) * dt;
    // end of task 2
}

/// 7.2: the longest step that a grid of columns of dx by dz takes without growing, in s, where waves travel at `c`.
inline Quantity<unit::Time> longest_step(Quantity<unit::Velocity> c, Quantity<unit::Length> dx,
                                         Quantity<unit::Length> dz) {
    // task 3: return todo(3);
    return 1.0 / (c * sqrt(1.0 / (dx * dx) + 1.0 / (dz * dz)));
    // end of task 3
}

/// 7.2: the rate of a column that nothing pulls, a step later, in m/s, where `damping` is what it loses of itself in a
/// second, in 1/s: after a second it is the same whatever the steps were.
inline Quantity<unit::Velocity> damped(Quantity<unit::Velocity> rate, Quantity<unit::Frequency> damping,
                                       Quantity<unit::Time> dt) {
    // task 4: return todo(4);
    return rate * std::exp(-double(damping * dt));
    // end of task 4
}

} // namespace exercise
