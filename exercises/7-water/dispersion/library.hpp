// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/water/dispersion.hpp>
#include <ansatz/water/waves.hpp>
#include <ansatz/world.hpp>

#include <vector>

namespace exercise {

inline ansatz::Quantity<ansatz::unit::Frequency>
angular_frequency(ansatz::Quantity<ansatz::unit::Length> wavelength, ansatz::Quantity<ansatz::unit::Length> depth,
                  ansatz::Quantity<ansatz::unit::Acceleration> gravity) {
    return ansatz::water::angular_frequency(wavelength, depth, gravity);
}

struct Wave {
    ansatz::Quantity<ansatz::unit::Length> wavelength, amplitude;
};

inline ansatz::Quantity<ansatz::unit::Length> height(const std::vector<Wave>& waves,
                                                     ansatz::Quantity<ansatz::unit::Length> depth,
                                                     ansatz::Quantity<ansatz::unit::Acceleration> gravity,
                                                     ansatz::Quantity<ansatz::unit::Length> x,
                                                     ansatz::Quantity<ansatz::unit::Time> t) {
    std::vector<ansatz::Wave> all;
    for (const Wave& wave : waves) all.push_back({wave.wavelength, wave.amplitude});
    return ansatz::Waves(all, depth, gravity).height(x, 0.0 * ansatz::metre, t);
}

inline ansatz::Quantity<ansatz::unit::Velocity> group_speed(ansatz::Quantity<ansatz::unit::Length> wavelength,
                                                            ansatz::Quantity<ansatz::unit::Length> depth,
                                                            ansatz::Quantity<ansatz::unit::Acceleration> gravity) {
    return ansatz::water::group_speed(wavelength, depth, gravity);
}

} // namespace exercise
