// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace ansatz;

namespace exercise {

/// 7.3: omega of a wave in water of that depth, which may be infinite; in 1/s.
inline Quantity<unit::Frequency> angular_frequency(Quantity<unit::Length> wavelength, Quantity<unit::Length> depth,
                                                   Quantity<unit::Acceleration> gravity) {
    return todo(1);
}

/// A wave that runs to where x is larger.
struct Wave {
    Quantity<unit::Length> wavelength, amplitude;
};

/// 7.3: how high a sum of waves is at x and t, above still water of that depth.
inline Quantity<unit::Length> height(const std::vector<Wave>& waves, Quantity<unit::Length> depth,
                                     Quantity<unit::Acceleration> gravity, Quantity<unit::Length> x,
                                     Quantity<unit::Time> t) {
    return todo(2);
}

/// 7.3: how fast a group of waves of about that length runs, in m/s.
inline Quantity<unit::Velocity> group_speed(Quantity<unit::Length> wavelength, Quantity<unit::Length> depth,
                                            Quantity<unit::Acceleration> gravity) {
    return todo(3);
}

} // namespace exercise
