// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs/hooke.hpp>
#include <ansatz/world.hpp>

#include <utility>

namespace exercise {

/// What a spring is fixed to: a place in m, and how fast that place moves, in m/s.
struct End {
    ansatz::VectorQuantity<ansatz::unit::Length, 3> position;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 3> velocity;
};
/// A spring, and the damper beside it.
struct Damped {
    ansatz::Quantity<ansatz::unit::Length> rest_length;
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    ansatz::Quantity<ansatz::unit::Damping> damping;
};
using Force = ansatz::VectorQuantity<ansatz::unit::Force, 3>;

inline std::pair<Force, Force> forces(const End& first, const End& second, const Damped& spring) {
    const Force on_first = ansatz::springs::between(second.position - first.position, second.velocity - first.velocity,
                                                    spring.rest_length, spring.stiffness, spring.damping);
    return {on_first, -on_first};
}

/// Nothing of this name is in the library; it is what a damper without a spring feels, for each newton second per
/// metre.
inline ansatz::Quantity<ansatz::unit::Velocity> lengthening(const End& first, const End& second) {
    const auto c = 1.0 * ansatz::newton_second_per_metre;
    const auto to = second.position - first.position;
    const auto length = ansatz::norm(to);
    if (length == 0.0 * ansatz::metre) return 0.0 * ansatz::metre_per_second;
    return ansatz::dot(forces(first, second, {0.0 * ansatz::metre, 0.0 * ansatz::newton_per_metre, c}).first, to) /
           length / c;
}

} // namespace exercise
