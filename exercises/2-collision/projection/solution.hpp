// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Place = VectorQuantity<unit::Length, 3>;
using PerMass = Quantity<unit::InverseMass>;
using Direction = Vector<double, 3>; // a plain vector, without a unit

struct Body {
    Place position;
    PerMass inverse_mass; ///< 1/m, zero for what is immovable
};

/// Which fraction of the way apart each of two bodies goes, the first and the second; neither, if both are immovable.
inline std::pair<double, double> shares(PerMass first, PerMass second) {
    // task 1: return todo(1);
    const PerMass both = first + second;
    if (both == 0.0 / kilogram) return {0, 0};
    return {first / both, second / both};
    // end of task 1
}

/// 2.2: moves two bodies apart, so that they only touch, and their centre of mass stays.
/// \param normal N, of length 1, from the second to the first
/// \param depth  p, how deep they are in each other
inline void push_apart(Body& first, Body& second, const Direction& normal, Length depth) {
    // task 2: todo(2);
    const PerMass both = first.inverse_mass + second.inverse_mass;
    if (both == 0.0 / kilogram) return;
    first.position += first.inverse_mass / both * depth * normal;
    second.position -= second.inverse_mass / both * depth * normal;
    // end of task 2
}

/// How much of a depth is taken away in one step.
/// \param slop  how deep bodies may stay in each other
/// \param share which part of the rest goes; greater than 0, at most 1
inline Length correction(Length depth, Length slop, double share) {
    // task 3: return todo(3);
    return share * max(depth - slop, 0.0 * metre);
    // end of task 3
}

} // namespace exercise
