// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 3: what a spring does to a body that is displaced by so much from where the spring would rest.
inline Quantity<unit::Force> force(Quantity<unit::Stiffness> stiffness, Quantity<unit::Length> displacement) {
    return todo(1);
}

/// What a spring holds that is displaced by so much; in J.
inline Quantity<unit::Energy> energy(Quantity<unit::Stiffness> stiffness, Quantity<unit::Length> displacement) {
    return todo(2);
}

/// What a spring between two places on a line does to its end in the first place. The places are coordinates on that
/// line, in any order; a positive force points to where coordinates are larger.
inline Quantity<unit::Force> force_on_first(Quantity<unit::Length> first, Quantity<unit::Length> second,
                                            Quantity<unit::Length> rest_length, Quantity<unit::Stiffness> stiffness) {
    return todo(3);
}

} // namespace exercise
