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
    // task 1: return todo(1);
    Force sum = newtons(0, 0, 0);
    for (const Act& act : acts)
        if (act.on == body) sum += act.force;
    return sum;
    // end of task 1
}

/// 1.1 and 1.2: the acceleration of a body with this resultant of forces on it, which falls with g besides. Its inverse
/// mass is 1/m, and zero for a body that is fixed.
inline Acceleration acceleration(const Force& resultant, InverseMass inverse_mass, const Acceleration& g) {
    // task 2: return todo(2);
    if (inverse_mass.value() == 0) return metres_per_second_squared(0, 0, 0);
    return g + inverse_mass * resultant;
    // end of task 2
}

/// 1.3: what comes with an act, at the same moment.
inline Act reaction(const Act& act) {
    // task 3: return todo(3);
    return {act.on, act.by, -act.force};
    // end of task 3
}

/// The acceleration of the centre of mass of a group, without gravity. Body i has the inverse mass inverse_masses[i],
/// which is not zero for those of the group; `acts` has every act with its reaction.
inline Acceleration centre_acceleration(const std::vector<int>& group, const std::vector<InverseMass>& inverse_masses,
                                        const std::vector<Act>& acts) {
    // task 4: return todo(4);
    auto belongs = [&](int body) { return std::find(group.begin(), group.end(), body) != group.end(); };
    Force from_outside = newtons(0, 0, 0);
    for (const Act& act : acts)
        if (belongs(act.on) && !belongs(act.by)) from_outside += act.force;
    Mass all = 0.0 * kilogram;
    for (const int body : group) all += 1.0 / inverse_masses[std::size_t(body)];
    return from_outside / all;
    // end of task 4
}

} // namespace exercise
