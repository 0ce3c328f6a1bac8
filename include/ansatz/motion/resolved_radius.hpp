// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `resolved_radius`: how far from the origin a motion is still what its velocity says, for a scalar, a speed and a
/// step.
///
/// Ask it before you decide on float or double, on the size of a world and on its step: at 1/240 s a float moves 0.05
/// m/s rightly, within 1 %, out to 32 m, and 5 m/s to 2 km. `WorldRadius` has the world tell which bodies are outside.

#include <ansatz/motion/facts.hpp>
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/space.hpp>

#include <cmath>
#include <limits>

namespace ansatz {

/// The distance from the origin, along each axis, within which every body of at least this speed is moved by its way in
/// each step, in whatever direction, but for a share of it. In m, a power of two; infinite where a double cannot say
/// it.
///
/// A step adds a way of \f$ s = v\,\Delta t \f$ to a position. Where the largest component of that is below
/// \f$ 2^E \f$, its places are at most \f$ u = 2^{E-p} \f$ apart, with the p digits of the scalar, and the sum is
/// rounded to one of them: \f$ u/2 \f$ on each of n axes. Those are at most a share \f$ \varepsilon \f$ of the way if
///
/// \f[ \frac{\sqrt n}{2}\,u \le \varepsilon s \iff u \le \frac{2 \varepsilon s}{\sqrt n}, \qquad
///     R = 2^p\, 2^{\lfloor \log_2 (2 \varepsilon s / \sqrt n) \rfloor} \f]
///
/// A velocity that stays the same is rounded the same way in each step, so that of the whole way, too, up to that share
/// is lost or won. A search over directions and speeds finds this R for 1 %; for shares so large that a way is a few
/// places, R or 2 R. A single speed may fare better further out, by chance: where s is a multiple of u.
///
/// `Compensated` rounds \f$ r + s \f$ instead, with a remainder r that is at most \f$ u/2 \f$: the places there are
/// \f$ 2^p \f$ times as close, and R is \f$ 2^p \f$ times as large.
///
/// \tparam S the space: its scalar and its dimension
/// \tparam I the integrator; what it keeps of a position decides
/// \param speed m/s, finite and greater than zero
/// \param dt    s, finite and greater than zero: of the integrator, which is a substep of the world's step where a
///              response or a StepControl divides it
/// \param share of the way, from 16 times the epsilon of the scalar, which products cost anyhow, to less than 1
/// \return zero, where the scalar has no normal number for the way of a step
/// \throws std::invalid_argument for other values
template <class S, class I = SemiImplicitEuler>
Quantity<unit::Length> resolved_radius(const Parameter<unit::Velocity>& speed, const Parameter<unit::Time>& dt,
                                       double share = 0.01) {
    static_assert(!detail::derives_velocity<I>,
                  "Ansatz: an integrator that derives velocity from positions loses digits of them at any distance, "
                  "so that there is no radius within which it does not; take one that keeps them, e.g. VelocityVerlet");
    using Limits = std::numeric_limits<typename S::Scalar>;
    static_assert(Limits::radix == 2, "Ansatz: resolved_radius counts binary digits; take a scalar that has them");
    require_positive("resolved_radius", "speed", speed);
    require_positive("resolved_radius", "dt", dt);
    if (const double least = 16 * double(Limits::epsilon()); !(share >= least) || !(share < 1))
        refuse_value("resolved_radius", "share", share,
                     detail::joined({"it is at least ", describe(least), " and less than 1"}));
    const Quantity<unit::Length> way = speed * dt;
    if (!(way.value() >= double(Limits::min()))) return 0.0 * metre; // the scalar does not hold its digits anywhere
    if (!is_finite(way)) return way;
    constexpr bool compensated = detail::contains<PositionRemainder, writes_of<I>>;
    const int places = std::ilogb(2 * share * way.value() / std::sqrt(double(S::dimension)));
    return std::ldexp(1.0, places + (compensated ? 2 : 1) * Limits::digits) * metre;
}

} // namespace ansatz
