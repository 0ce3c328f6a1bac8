// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the times in the order of the signs of the root
// Why:     The plus gives the earlier time where a is negative and the later one where it is positive. (The formula
//          loses digits as well: see the test for short ways.)
// Read:    1.5
// Fails:   twice, digits

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

/// Where a motion ends: how far from its start, and how fast.
struct End {
    Quantity<unit::Length> s;
    Quantity<unit::Velocity> v;
};

/// 1.5: the end of a motion that starts with u and has the constant acceleration a for the time t.
inline End after(Quantity<unit::Velocity> u, Quantity<unit::Acceleration> a, Quantity<unit::Time> t) {
    return {u * t + 0.5 * a * t * t, u + a * t};
}

/// The displacement of a motion that ends with v, after it had the constant acceleration a for the time t.
inline Quantity<unit::Length> displacement_until(Quantity<unit::Velocity> v, Quantity<unit::Acceleration> a,
                                                 Quantity<unit::Time> t) {
    return v * t - 0.5 * a * t * t;
}

/// All times at which a motion is displaced by s that starts with u and has the constant acceleration a, the earlier
/// first. u and a are not both zero.
inline std::vector<Quantity<unit::Time>> times_at(Quantity<unit::Length> s, Quantity<unit::Velocity> u,
                                                  Quantity<unit::Acceleration> a) {
    const Quantity<unit::Acceleration> none;
    if (a == none) return {s / u};
    const auto square = u * u + 2.0 * a * s;
    if (square < 0.0 * square) return {};
    const auto speed = sqrt(square);
    if (speed == 0.0 * speed) return {-u / a};
    return {(-u + speed) / a, (-u - speed) / a};
}

} // namespace exercise
