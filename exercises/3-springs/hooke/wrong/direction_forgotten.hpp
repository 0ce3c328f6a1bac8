// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the tension without its direction
// Why:     How much a spring pulls is one question, to which side is another. The end with the smaller coordinate is
//          pulled to where coordinates are larger, the other one to where they are smaller.
// Read:    3, 3.2
// Fails:   stretched-or-pressed, mirror, opposite

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 3: what a spring does to a body that is displaced by so much from where the spring would rest.
inline Quantity<unit::Force> force(Quantity<unit::Stiffness> stiffness, Quantity<unit::Length> displacement) {
    return -stiffness * displacement;
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
    return pull;
}

} // namespace exercise
