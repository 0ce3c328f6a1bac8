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
    return todo(1);
}

/// The stiffness of springs that join the same two bodies, beside each other.
inline Stiffness beside(const std::vector<Stiffness>& springs) {
    return todo(2);
}

/// The stiffness of springs of which each hangs at the end of the one before it.
inline Stiffness in_a_row(const std::vector<Stiffness>& springs) {
    return todo(2);
}

/// The pair after this time, which is not negative; exactly, whatever the time is.
inline Pair after(const Pair& pair, Time time) {
    return todo(3);
}

} // namespace exercise
