// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Steering: which velocity a walker wants, and how much of it its acceleration allows (beyond the notes' 6.3, which
/// find the path and leave the walking open).
///
/// `seek`, `flee`, `arrive` and `pursue` answer with the velocity that is wanted; `steered` turns the present one
/// towards it by at most a dt. `separation` is a force between two bodies. They know no world, and are what a policy of
/// your own is made of. For a body that follows a path take `Walkers`, which plans its speed along the whole of it.
///
/// Each has a closed form, of the steps and not only of their limit: `arrive` brakes by exactly a dt in each step and
/// lands on the target to the rounding, so that no walker circles it, however long the step is. The verbs are Reynolds'
/// (Steering Behaviors For Autonomous Characters, 1999); his arrival slows down in proportion to the distance and lands
/// only in the limit of short steps.

#include <ansatz/units.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace ansatz::paths {

namespace detail {
/// A vector with a unit, of which number and dimension are deduced.
template <class Unit, class S, int D, int O> using Arrow = Quantity<Unit, ansatz::detail::Dense<S, D, 1, O>>;
template <class Unit, class S> using Given = Quantity<Unit, std::type_identity_t<S>>;
/// A vector of this length along another; zero where that is zero.
template <class Unit, class S, int D, int O, class Long>
auto along(const Arrow<Unit, S, D, O>& way, const Long& length) {
    const auto whole = norm(way);
    const S least = std::numeric_limits<S>::min();
    return whole.value() > least ? length * (way / whole) : length * (way / Quantity<Unit, S>::from_value(S(1)));
}
} // namespace detail

/// The velocity after a step: the wanted one, or as near to it as an acceleration leads.
/// \param velocity     m/s, the present one
/// \param wanted       m/s
/// \param acceleration m/s^2, the greatest
/// \param dt           s
template <class S, int D, int O>
detail::Arrow<unit::Velocity, S, D, O>
steered(const detail::Arrow<unit::Velocity, S, D, O>& velocity, const detail::Arrow<unit::Velocity, S, D, O>& wanted,
        const detail::Given<unit::Acceleration, S>& acceleration, const detail::Given<unit::Time, S>& dt) {
    const auto change = wanted - velocity;
    const Quantity<unit::Velocity, S> most = acceleration * dt;
    if (!(norm(change) > most)) return wanted;
    return velocity + detail::along(change, most);
}

/// At full speed towards a place; zero where the walker is there. \return m/s
template <class S, int D, int O>
detail::Arrow<unit::Velocity, S, D, O> seek(const detail::Arrow<unit::Length, S, D, O>& place,
                                            const detail::Arrow<unit::Length, S, D, O>& target,
                                            const detail::Given<unit::Velocity, S>& speed) {
    return detail::along(target - place, speed);
}
/// At full speed away from it. \return m/s
template <class S, int D, int O>
detail::Arrow<unit::Velocity, S, D, O> flee(const detail::Arrow<unit::Length, S, D, O>& place,
                                            const detail::Arrow<unit::Length, S, D, O>& from,
                                            const detail::Given<unit::Velocity, S>& speed) {
    return detail::along(place - from, speed);
}

/// How fast the next step may be, so that one that brakes by a dt in each step after it comes to rest at the distance.
///
/// \f[ u = \frac m2 a\,\Delta t + \frac{d}{(m + 1)\,\Delta t}, \qquad
///     m = \left\lfloor \tfrac12\left(\sqrt{1 + 8d/(a\,\Delta t^2)} - 1\right)\right\rfloor \f]
///
/// | symbol | meaning |
/// |---|---|
/// | \f$ d \f$ | the distance, m |
/// | \f$ a \f$ | the acceleration, m/s^2 |
/// | \f$ m \f$ | how many steps follow in which it still moves |
///
/// For short steps it is \f$ \sqrt{2ad} \f$; the last step, m = 0, is what is left of the way. \return m/s
template <class S>
Quantity<unit::Velocity, S> arrival_speed(const Quantity<unit::Length, S>& distance,
                                          const detail::Given<unit::Acceleration, S>& acceleration,
                                          const detail::Given<unit::Time, S>& dt) {
    using std::floor;
    using std::sqrt;
    const Quantity<unit::Velocity, S> change = acceleration * dt;
    const S reach = (change * dt).value();
    const S m = floor((sqrt(S(1) + S(8) * distance.value() / reach) - S(1)) / S(2));
    return S(0.5) * m * change + distance / (dt * (m + S(1)));
}
/// Towards a place, and at rest there. \return m/s
/// \param dt s, the step that will be taken with this velocity
template <class S, int D, int O>
detail::Arrow<unit::Velocity, S, D, O>
arrive(const detail::Arrow<unit::Length, S, D, O>& place, const detail::Arrow<unit::Length, S, D, O>& target,
       const detail::Given<unit::Velocity, S>& speed, const detail::Given<unit::Acceleration, S>& acceleration,
       const detail::Given<unit::Time, S>& dt) {
    const auto way = target - place;
    const auto u = arrival_speed(norm(way), acceleration, dt);
    return detail::along(way, u < speed ? u : speed);
}

/// When a walker of this speed can first meet another that goes on as now: the smaller root t > 0 of
/// \f$ |\mathbf r + \mathbf w t| = c\,t \f$. Nothing where there is none. \return s
/// \param offset   m, from the walker to the other
/// \param velocity m/s, of the other
/// \param speed    m/s, of the walker
template <class S, int D, int O>
std::optional<Quantity<unit::Time, S>> meeting_time(const detail::Arrow<unit::Length, S, D, O>& offset,
                                                    const detail::Arrow<unit::Velocity, S, D, O>& velocity,
                                                    const detail::Given<unit::Velocity, S>& speed) {
    const auto away = dot(offset, velocity);
    const auto apart = squared_norm(offset);
    const auto under = away * away + (speed * speed - squared_norm(velocity)) * apart;
    if (!(apart.value() > S(0))) return Quantity<unit::Time, S>::from_value(S(0));
    if (under.value() < S(0)) return std::nullopt;
    const auto closing = sqrt(under) - away;
    if (!(closing.value() > S(0))) return std::nullopt;
    return Quantity<unit::Time, S>(apart / closing);
}
/// Towards where another that goes on as now can be met, or where that is nowhere, after it. \return m/s
template <class S, int D, int O>
detail::Arrow<unit::Velocity, S, D, O>
pursue(const detail::Arrow<unit::Length, S, D, O>& place, const detail::Arrow<unit::Length, S, D, O>& other,
       const detail::Arrow<unit::Velocity, S, D, O>& velocity, const detail::Given<unit::Velocity, S>& speed) {
    const auto time = meeting_time(other - place, velocity, speed);
    const Quantity<unit::Time, S> t = time ? *time : Quantity<unit::Time, S>::from_value(S(0));
    const detail::Arrow<unit::Length, S, D, O> there = other + velocity * t;
    return seek(place, there, speed);
}

/// What pushes a body away from another that is nearer than `reach`: a force along their line, \f$ F (1 - d/r) \f$. The
/// other is pushed by its opposite, so that the two keep their momentum, and it has the potential
/// \f$ F (r - d)^2 / 2r \f$. Two in one place have no line, and no force. \return N
/// \param strength N, what it would be without a distance
template <class S, int D, int O>
detail::Arrow<unit::Force, S, D, O>
separation(const detail::Arrow<unit::Length, S, D, O>& place, const detail::Arrow<unit::Length, S, D, O>& other,
           const detail::Given<unit::Length, S>& reach, const detail::Given<unit::Force, S>& strength) {
    const auto way = place - other;
    const auto apart = norm(way);
    const Quantity<unit::Force, S> none = S(0) * strength;
    return detail::along(way, apart < reach ? strength * (S(1) - S(apart / reach)) : none);
}

} // namespace ansatz::paths
