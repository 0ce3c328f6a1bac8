// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: u t alone, without the term of the acceleration
// Why:     Where it was written with 1 / 2, both are integers and their quotient is 0: write 0.5. Where it was left
//          out: u is the velocity at the start only.
// Read:    1.5
// Fails:   displacement, two-times

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
    return {u * t + 1 / 2 * a * t * t, u + a * t};
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

    const auto square = u * u + 2.0 * a * s; // of the velocity there
    if (square < 0.0 * square) return {};
    const auto speed = sqrt(square);
    if (speed == 0.0 * speed) return {-u / a};

    // One root is a sum of two numbers of one sign. The other would be their difference; their product, -2 s / a, is
    // not.
    const auto sum = u < 0.0 * u ? u - speed : u + speed;
    const auto one = -sum / a, other = 2.0 * s / sum;
    return {min(one, other), max(one, other)};
}

} // namespace exercise
