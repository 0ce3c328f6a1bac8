// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How short a time step may be: `World::step` asks before it touches anything.
///
/// Two things go wrong in a step that is too short. Integrators and responses divide by it, and where 1/dt is no
/// number, nothing after it is: no world takes a step below `smallest_step`. And an integrator that keeps the last
/// position in place of the velocity (Verlet) has the velocity as a difference of two positions: where v dt is less
/// than the rounding of x, the body stands still from then on. How short a step that is depends on where the bodies
/// are, so they are asked, but only where dt^2 is below a hundredth of the scalar's epsilon (1.5 ns in double, 35
/// microseconds in float): above that it is the price which Verlet names.
///
/// A step in which x + v dt rounds to x is right for every other integrator: the velocity is kept, and the next step is
/// longer. What a history loses besides in such steps are accelerations: a dt^2 of each, where it is below the rounding
/// of x.

#include <ansatz/motion/state.hpp>
#include <ansatz/world/inside.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ansatz::detail {

/// The shortest step that a world of this scalar takes, s: 1e-292 in double, 1e-31 in float. What a response makes of
/// it, a hundredth of it or its square root, still has all digits, and an inverse.
template <class Scalar> Scalar smallest_step() {
    return Scalar(std::numeric_limits<Scalar>::min() / std::numeric_limits<Scalar>::epsilon());
}

/// A velocity is kept by a history that gives back all but this share of it, or all but this share of 1 mm/s.
inline constexpr double lost_share = 1e-3, slowest_kept = 1e-3;

/// The shortest step with which the history of every body holds its velocity, s; zero, where this one is long enough.
/// \param dt s, the step of the integrator: a substep of the world's where a response divides it
template <class C>
typename C::S::Scalar shortest_that_keeps_velocities(const WorldData<C>& data, const typename C::S::Scalar& dt) {
    using std::abs;
    using Scalar = typename C::S::Scalar;
    const auto epsilon = std::numeric_limits<Scalar>::epsilon();
    Scalar shortest(0);
    if (!(Scalar(100) * dt * dt < epsilon)) return shortest;
    for (std::size_t slot = 0; slot < data.bodies.size(); ++slot) {
        const auto kind = data.bodies.motion(slot);
        if (kind != Motion::awake && kind != Motion::moving) continue;
        const auto row = data.load(Bodies::Slot(slot));
        Scalar farthest(0), fastest = static_cast<Scalar>(slowest_kept), lost(0);
        for (int k = 0; k < C::S::dimension; ++k) {
            const Scalar x = row.template get<Position>().value()[k], v = row.template get<Velocity>().value()[k],
                         before = x - v * dt;
            farthest = std::max(farthest, Scalar(abs(x)));
            fastest = std::max(fastest, Scalar(abs(v)));
            lost = std::max(lost, Scalar(abs((x - before) / dt - v)));
        }
        if (lost > Scalar(lost_share) * fastest)
            shortest = std::max(shortest, Scalar(farthest * epsilon / (Scalar(lost_share) * fastest)));
    }
    return shortest;
}

/// \param h     the step, greater than zero
/// \param given the same as it was given
/// \throws std::invalid_argument for a step that is too short, with one that is not
template <class I>
void refuse_short_step([[maybe_unused]] const I& inside, const typename I::S::Time& h, const auto& given) {
    using C = typename I::Composition_;
    using Scalar = typename C::S::Scalar;
    auto is_at_least = [&](const char* why, const Scalar& least) {
        refuse_value("World::step", "dt", given, joined({why, describe(C::S::Time::from_value(least))}));
    };
    if constexpr (C::history) {
        int divided = 1;
        inside.template tell<hook::NextSubsteps>(divided);
        const auto parts = static_cast<Scalar>(divided);
        const Scalar enough = shortest_that_keeps_velocities(inside.data, Scalar(h.value() / parts));
        if (enough > Scalar(0))
            is_at_least("an integrator that keeps the last position would lose the velocity of a body in the rounding "
                        "of its position; "
                        "take one that keeps velocities, e.g. VelocityVerlet, or a step of at least ",
                        Scalar(enough * parts));
    }
    if (h.value() < smallest_step<Scalar>())
        is_at_least("a time step is 0, or one that the world's scalar divides by: at least ", smallest_step<Scalar>());
}

} // namespace ansatz::detail
