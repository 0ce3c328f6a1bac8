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
    // task 1: return todo(1);
    const Quantity<unit::InverseLength> k = 2 * std::numbers::pi / wavelength;
    return sqrt(gravity * k * std::tanh(double(k * depth)));
    // end of task 1
}

/// A wave that runs to where x is larger.
struct Wave {
    Quantity<unit::Length> wavelength, amplitude;
};

/// 7.3: how high a sum of waves is at x and t, above still water of that depth.
inline Quantity<unit::Length> height(const std::vector<Wave>& waves, Quantity<unit::Length> depth,
                                     Quantity<unit::Acceleration> gravity, Quantity<unit::Length> x,
                                     Quantity<unit::Time> t) {
    // task 2: return todo(2);
    auto y = 0.0 * metre;
    for (const Wave& wave : waves) {
        const auto omega = angular_frequency(wave.wavelength, depth, gravity);
        y += wave.amplitude * std::cos(2 * std::numbers::pi * double(x / wave.wavelength) - double(omega * t));
    }
    return y;
    // end of task 2
}

/// 7.3: how fast a group of waves of about that length runs, in m/s.
inline Quantity<unit::Velocity> group_speed(Quantity<unit::Length> wavelength, Quantity<unit::Length> depth,
                                            Quantity<unit::Acceleration> gravity) {
    // task 3: return todo(3);
    const Quantity<unit::InverseLength> k = 2 * std::numbers::pi / wavelength;
    const double kd = double(k * depth);
    const double shallow = kd < 300 ? 2 * kd / std::sinh(2 * kd) : 0.0;
    return 0.5 * (1 + shallow) * angular_frequency(wavelength, depth, gravity) / k;
    // end of task 3
}

} // namespace exercise
