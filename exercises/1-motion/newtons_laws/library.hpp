// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

#include <vector>

namespace exercise {

using InverseMass = ansatz::Quantity<ansatz::unit::InverseMass>;
using Force = ansatz::VectorQuantity<ansatz::unit::Force, 3>;
using Acceleration = ansatz::VectorQuantity<ansatz::unit::Acceleration, 3>;

struct Act {
    int by, on;
    Force force;
};

inline Force resultant(int body, const std::vector<Act>& acts) {
    Force sum = ansatz::newtons(0, 0, 0);
    for (const Act& act : acts)
        if (act.on == body) sum = ansatz::mechanics::resultant(sum, act.force);
    return sum;
}
/// A world in which it is at rest for a second: the velocity then is the acceleration.
inline Acceleration acceleration(const Force& resultant, InverseMass inverse_mass, const Acceleration& g) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Gravity{g}, AppliedForces{}};
    const auto body = inverse_mass.value() == 0 ? world.add(fixed) : world.add(mass(1.0 / inverse_mass));
    world.apply_force(body, resultant);
    world.step(1.0 * second);
    return world.velocity(body) / (1.0 * second);
}
inline Act reaction(const Act& act) { return {act.on, act.by, ansatz::mechanics::reaction(act.force)}; }
/// A world of the group alone, to which everything is done that is done to its bodies.
inline Acceleration centre_acceleration(const std::vector<int>& group, const std::vector<InverseMass>& inverse_masses,
                                        const std::vector<Act>& acts) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, AppliedForces{}};
    auto all = 0.0 * kilogram;
    for (const int number : group) {
        const auto its = 1.0 / inverse_masses[std::size_t(number)];
        const auto body = world.add(mass(its));
        all += its;
        world.apply_force(body, resultant(number, acts));
    }
    world.step(1.0 * second);
    return total_momentum(world) / (all * (1.0 * second));
}

} // namespace exercise
