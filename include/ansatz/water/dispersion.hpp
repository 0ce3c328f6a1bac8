// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `water`: how fast waves run, from their length and the depth (notes 7.3).
///
/// Use it to choose waves: a length that is seen gives a period that must go with it, and a sea whose waves have one
/// period for all lengths looks wrong. Capillary waves, below 2 cm, are not in it, nor is a current.
///
/// \f[ \omega^2 = g k \tanh(k d), \qquad k = 2\pi/\lambda \f]
///
/// | symbol | meaning                                            | unit  |
/// |--------|----------------------------------------------------|-------|
/// | lambda | wavelength                                         | m     |
/// | k      | wave number, 2 pi / lambda; not 2 / lambda         | 1/m   |
/// | omega  | angular frequency, 2 pi over the period            | 1/s   |
/// | d      | depth; infinite where there is no ground           | m     |
///
/// G. B. Airy, Tides and Waves (1845).

#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace ansatz::water {

/// Deeper than any wave reaches: what depth is where none is given.
inline constexpr double bottomless = std::numeric_limits<double>::infinity();

/// \f$ k = 2\pi/\lambda \f$, 1/m.
/// \throws std::invalid_argument unless the wavelength is finite and positive, and so long that k is finite
inline Quantity<unit::InverseLength> wave_number(const Quantity<unit::Length>& wavelength) {
    require_positive("water::wave_number", "wavelength", wavelength);
    const Quantity<unit::InverseLength> k = 2 * std::numbers::pi / wavelength;
    if (!is_finite(k.value()))
        refuse_value("water::wave_number", "wavelength", wavelength, "2 pi over it must be a finite number");
    return k;
}
namespace detail {
/// tanh(k d), with the checks that all below share.
inline double shallowness(const Quantity<unit::Length>& wavelength, const Quantity<unit::Length>& depth,
                          const Quantity<unit::Acceleration>& gravity) {
    require_positive("water", "gravity", gravity);
    if (!(depth.value() > 0)) refuse_value("water", "depth", depth, "it must be greater than zero, or infinite");
    return std::tanh(wave_number(wavelength).value() * depth.value());
}
} // namespace detail
/// \f$ \omega = \sqrt{g k \tanh(k d)} \f$, 1/s.
/// \param wavelength m, finite, positive
/// \param depth      m, positive, infinite by default
/// \param gravity    m/s^2, finite, positive
/// \throws std::invalid_argument for other values
inline Quantity<unit::Frequency>
angular_frequency(const Quantity<unit::Length>& wavelength, const Quantity<unit::Length>& depth = bottomless * metre,
                  const Quantity<unit::Acceleration>& gravity = 9.81 * metre_per_second_squared) {
    const double part = detail::shallowness(wavelength, depth, gravity);
    return std::sqrt(gravity.value() * wave_number(wavelength).value() * part) * hertz;
}
/// \f$ T = 2\pi/\omega \f$, s; as angular_frequency().
inline Quantity<unit::Time> period(const Quantity<unit::Length>& wavelength,
                                   const Quantity<unit::Length>& depth = bottomless * metre,
                                   const Quantity<unit::Acceleration>& gravity = 9.81 * metre_per_second_squared) {
    return 2 * std::numbers::pi / angular_frequency(wavelength, depth, gravity);
}
/// \f$ c = \omega/k \f$: how fast a crest runs, m/s; as angular_frequency().
inline Quantity<unit::Velocity>
phase_speed(const Quantity<unit::Length>& wavelength, const Quantity<unit::Length>& depth = bottomless * metre,
            const Quantity<unit::Acceleration>& gravity = 9.81 * metre_per_second_squared) {
    return angular_frequency(wavelength, depth, gravity) / wave_number(wavelength);
}
/// \f$ d\omega/dk \f$: how fast a group of waves runs, and its energy, m/s; half of a crest's speed in deep water, all of
/// it in shallow. As angular_frequency().
inline Quantity<unit::Velocity>
group_speed(const Quantity<unit::Length>& wavelength, const Quantity<unit::Length>& depth = bottomless * metre,
            const Quantity<unit::Acceleration>& gravity = 9.81 * metre_per_second_squared) {
    const double kd = wave_number(wavelength).value() * depth.value();
    const double more = kd < 300 ? 2 * kd / std::sinh(2 * kd) : 0.0; // where sinh overflows it is nothing
    return phase_speed(wavelength, depth, gravity) * (0.5 * (1 + more));
}

} // namespace ansatz::water
