// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The exact motion of problems.hpp's Pendulum (apart, because elliptic functions take a second to compile).
///
/// | symbol | meaning                                                        | unit |
/// |--------|----------------------------------------------------------------|------|
/// | omega  | of small swings, sqrt(g / l)                                   | 1/s  |
/// | k      | sin(half of the largest angle), below 1; v0 = 2 k l omega below | none |
/// | sn, cn | Jacobi's elliptic functions                                    | none |

#include "problems.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <numbers>

namespace problems {

/// From the lowest point with \f$ v_0 = 2 k l \omega \f$: \f$ \sin(\theta/2) = k\,\mathrm{sn}(\omega t, k) \f$ and
/// \f$ \dot\theta = 2 k \omega\,\mathrm{cn}(\omega t, k) \f$; as arc length and its velocity.
inline OnALine pendulum(const Pendulum& p, double k, Quantity<unit::Time> t) {
    const Quantity<unit::Frequency> omega = sqrt(Quantity<unit::FrequencySquared>(p.gravity / p.length));
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, (omega * t).value(), &cn, &dn);
    return {2 * std::asin(k * sn) * Quantity<unit::Length>(p.length),
            2 * k * cn * omega * Quantity<unit::Length>(p.length)};
}

/// The time of one swing there and back when it is released at rest from an angle: \f$ 4 K(\sin(\theta_0/2)) / \omega \f$.
/// From 90 degrees it is 1.180341 times that of small swings.
inline Quantity<unit::Time> pendulum_period(const Pendulum& p, double angle) {
    const Quantity<unit::Frequency> omega = sqrt(Quantity<unit::FrequencySquared>(p.gravity / p.length));
    return 4 * boost::math::ellint_1(std::sin(angle / 2)) / omega;
}

} // namespace problems
