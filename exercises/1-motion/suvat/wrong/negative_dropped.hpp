// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: negative times dropped
// Why:     A time before the start is one of the same motion, seen backwards. Whether it is wanted is for those to
//          say who ask; times_at is to give all.
// Read:    1.5
// Fails:   before, no-acceleration

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
    std::vector<Quantity<unit::Time>> all;
    if (a == none) {
        all = {s / u};
    } else {
        const auto square = u * u + 2.0 * a * s;
        if (square < 0.0 * square) return {};
        const auto speed = sqrt(square);
        const auto sum = u < 0.0 * u ? u - speed : u + speed;
        const auto one = -sum / a, other = 2.0 * s / sum;
        all = {min(one, other), max(one, other)};
        if (speed == 0.0 * speed) all = {-u / a};
    }
    std::vector<Quantity<unit::Time>> times;
    for (const auto& t : all)
        if (t >= 0.0 * t) times.push_back(t);
    return times;
}

} // namespace exercise
