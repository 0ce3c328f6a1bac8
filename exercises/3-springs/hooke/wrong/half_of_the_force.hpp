// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the half of the energy, in the force
// Why:     k x^2 / 2 is the energy. Its derivative is k x, and the half is gone.
// Read:    3
// Fails:   weight

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 3: what a spring does to a body that is displaced by so much from where the spring would rest.
inline Quantity<unit::Force> force(Quantity<unit::Stiffness> stiffness, Quantity<unit::Length> displacement) {
    return -0.5 * stiffness * displacement;
}

/// What a spring holds that is displaced by so much; in J.
inline Quantity<unit::Energy> energy(Quantity<unit::Stiffness> stiffness, Quantity<unit::Length> displacement) {
    return 0.5 * stiffness * displacement * displacement;
}

/// What a spring between two places on a line does to its end in the first place. The places are coordinates on that
/// line, in any order; a positive force points to where coordinates are larger.
inline Quantity<unit::Force> force_on_first(Quantity<unit::Length> first, Quantity<unit::Length> second,
                                            Quantity<unit::Length> rest_length, Quantity<unit::Stiffness> stiffness) {
    const auto pull = stiffness * (abs(second - first) - rest_length);
    return second > first ? pull : -pull;
}

} // namespace exercise
