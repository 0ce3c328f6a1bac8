// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the second end forgotten
// Why:     A spring that pulls at one end only moves its own centre of mass. It may be forgotten where the other end
//          is a wall.
// Read:    3.2
// Fails:   opposite, power

#include <ansatz/world.hpp>

#include <utility>

using namespace ansatz;

namespace exercise {

/// What a spring is fixed to: a place in m, and how fast that place moves, in m/s.
struct End {
    VectorQuantity<unit::Length, 3> position;
    VectorQuantity<unit::Velocity, 3> velocity;
};
/// A spring, and the damper beside it.
struct Damped {
    Quantity<unit::Length> rest_length;  ///< m
    Quantity<unit::Stiffness> stiffness; ///< k, N/m
    Quantity<unit::Damping> damping;     ///< c, N s/m
};
using Force = VectorQuantity<unit::Force, 3>;

/// 3: how fast the distance between two ends grows; zero for ends in the same place.
inline Quantity<unit::Velocity> lengthening(const End& first, const End& second) {
    const auto to = second.position - first.position;
    if (norm(to) == 0.0 * metre) return 0.0 * metre_per_second;
    return dot(second.velocity - first.velocity, to) / norm(to);
}

/// The force on the first end, and the force on the second; none for ends in the same place.
inline std::pair<Force, Force> forces(const End& first, const End& second, const Damped& spring) {
    const auto to = second.position - first.position;
    if (norm(to) == 0.0 * metre) return {newtons(0, 0, 0), newtons(0, 0, 0)};
    const auto pull = spring.stiffness * (norm(to) - spring.rest_length) + spring.damping * lengthening(first, second);
    const Force on_first = pull * (to / norm(to));
    return {on_first, newtons(0, 0, 0)};
}

} // namespace exercise
