// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace ansatz;

namespace exercise {

using Mass = Quantity<unit::Mass>;
using Length = Quantity<unit::Length>;
using Velocity = Quantity<unit::Velocity>;
using Time = Quantity<unit::Time>;
using Stiffness = Quantity<unit::Stiffness>;

/// A body on a line.
struct Body {
    Mass mass;
    Length place;
    Velocity velocity;
};
/// Two of them, and the spring that joins them. The second is where coordinates are larger.
struct Pair {
    Body first, second;
    Stiffness stiffness;
    Length rest_length;
};

/// 3.2: how long one swing takes of two free bodies that a spring joins.
inline Time period(Mass first, Mass second, Stiffness stiffness) {
    // task 1: return todo(1);
    const Mass reduced = first * (second / (first + second));
    return 2 * std::numbers::pi * sqrt(reduced / stiffness);
    // end of task 1
}

/// The stiffness of springs that join the same two bodies, beside each other.
inline Stiffness beside(const std::vector<Stiffness>& springs) {
    // task 2: return todo(2);
    Stiffness sum = 0.0 * newton_per_metre;
    for (const Stiffness& k : springs) sum += k;
    return sum;
    // end of task 2
}

/// The stiffness of springs of which each hangs at the end of the one before it.
inline Stiffness in_a_row(const std::vector<Stiffness>& springs) {
    // task 2: return todo(2);
    auto metres_per_newton = 0.0 / newton_per_metre;
    for (const Stiffness& k : springs) metres_per_newton += 1.0 / k;
    return 1.0 / metres_per_newton;
    // end of task 2
}

/// The pair after this time, which is not negative; exactly, whatever the time is.
inline Pair after(const Pair& pair, Time time) {
    // task 3: return todo(3);
    const auto& [first, second, stiffness, rest_length] = pair;
    const Mass total = first.mass + second.mass;
    const double share = first.mass / total;
    const auto omega = sqrt(stiffness / (share * second.mass));
    const double angle = omega * time;

    // The centre goes straight on.
    const Velocity drift = share * first.velocity + (1 - share) * second.velocity;
    const Length centre = share * first.place + (1 - share) * second.place + drift * time;

    // What the second does as the first sees it is a swing about the rest length.
    const Length x = second.place - first.place - rest_length;
    const Velocity v = second.velocity - first.velocity;
    const Length length = rest_length + x * std::cos(angle) + v / omega * std::sin(angle);
    const Velocity lengthens = v * std::cos(angle) - omega * x * std::sin(angle);

    // Each has of the length between them what the other has of the mass.
    Pair then = pair;
    then.first.place = centre - (1 - share) * length;
    then.second.place = centre + share * length;
    then.first.velocity = drift - (1 - share) * lengthens;
    then.second.velocity = drift + share * lengthens;
    return then;
    // end of task 3
}

} // namespace exercise
