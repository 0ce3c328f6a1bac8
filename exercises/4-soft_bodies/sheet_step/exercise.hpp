// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;

namespace exercise {

/// Bodies on a line, and the springs between them.
struct Net {
    struct Spring {
        std::size_t a, b; ///< its two bodies, by number
        Quantity<unit::Stiffness> stiffness;
    };
    std::vector<Quantity<unit::InverseMass>> weights; ///< 1/m of each body, zero where it is held
    std::vector<Spring> springs;
};

/// No omega^2 of the net is larger; in 1/s^2.
inline Quantity<unit::FrequencySquared> bound(const Net& net) {
    return todo(1);
}

/// The largest omega^2 of the net; in 1/s^2.
inline Quantity<unit::FrequencySquared> measured(const Net& net) {
    return todo(2);
}

/// The longest step that semi-implicit Euler takes at that omega^2; in s.
inline Quantity<unit::Time> longest_step(Quantity<unit::FrequencySquared> omega_squared) {
    return todo(3);
}

} // namespace exercise
