// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: it asks a world.
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <vector>

namespace exercise {

struct Net {
    struct Spring {
        std::size_t a, b;
        ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    };
    std::vector<ansatz::Quantity<ansatz::unit::InverseMass>> weights;
    std::vector<Spring> springs;
};

inline auto world_of(const Net& net) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Springs{}};
    std::vector<Handle> bodies;
    for (const auto& weight : net.weights) {
        const auto at = position(metres(double(bodies.size()), 0, 0));
        bodies.push_back(weight.value() > 0 ? world.add(at, mass(1.0 / weight)) : world.add(at, fixed));
    }
    for (const auto& [a, b, stiffness] : net.springs)
        world.add(ansatz::Spring{.first = bodies[a], .second = bodies[b], .stiffness = stiffness});
    return world;
}

inline ansatz::Quantity<ansatz::unit::FrequencySquared> bound(const Net& net) {
    return ansatz::stiffness_of(world_of(net)).largest;
}

inline ansatz::Quantity<ansatz::unit::FrequencySquared> measured(const Net& net) {
    return ansatz::measured_stiffness(world_of(net), 4000);
}

inline ansatz::Quantity<ansatz::unit::Time>
longest_step(ansatz::Quantity<ansatz::unit::FrequencySquared> omega_squared) {
    return ansatz::stable_step<ansatz::SemiImplicitEuler>(omega_squared, 0.0 / ansatz::second);
}

} // namespace exercise
