// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <vector>

using namespace ansatz;

namespace exercise {

using Mass = Quantity<unit::Mass>;
using InverseMass = Quantity<unit::InverseMass>;
using Force = VectorQuantity<unit::Force, 3>;
using Acceleration = VectorQuantity<unit::Acceleration, 3>;

/// What one body does to another. Bodies are numbers.
struct Act {
    int by, on;
    Force force; ///< acts on the body `on`
};

/// 1.2: the sum of all forces that act on a body; nothing, newtons(0, 0, 0), where none does.
inline Force resultant(int body, const std::vector<Act>& acts) {
    return todo(1);
}

/// 1.1 and 1.2: the acceleration of a body with this resultant of forces on it, which falls with g besides. Its inverse
/// mass is 1/m, and zero for a body that is fixed.
inline Acceleration acceleration(const Force& resultant, InverseMass inverse_mass, const Acceleration& g) {
    return todo(2);
}

/// 1.3: what comes with an act, at the same moment.
inline Act reaction(const Act& act) {
    return todo(3);
}

/// The acceleration of the centre of mass of a group, without gravity. Body i has the inverse mass inverse_masses[i],
/// which is not zero for those of the group; `acts` has every act with its reaction.
inline Acceleration centre_acceleration(const std::vector<int>& group, const std::vector<InverseMass>& inverse_masses,
                                        const std::vector<Act>& acts) {
    return todo(4);
}

} // namespace exercise
