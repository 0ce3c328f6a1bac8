// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

namespace exercise {

using Mass = ansatz::Quantity<ansatz::unit::Mass>;
using Length = ansatz::Quantity<ansatz::unit::Length>;
using Acceleration = ansatz::Quantity<ansatz::unit::Acceleration>;
using Energy = ansatz::Quantity<ansatz::unit::Energy>;
using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using Force = ansatz::VectorQuantity<ansatz::unit::Force, 3>;
using Constant = ansatz::Quantity<ansatz::unit::GravitationalConstant>;

struct Body {
    Mass mass;
    Place place;
};

/// A world of two that attract each other.
inline auto world_of(const Body& first, const Body& second, Constant G, Length softening) {
    ansatz::World world{ansatz::SemiImplicitEuler{}, ansatz::Attraction{G, softening}};
    const auto one = world.add(ansatz::position(first.place), ansatz::mass(first.mass));
    world.add(ansatz::position(second.place), ansatz::mass(second.mass));
    return std::pair(world, one);
}
inline Energy potential_energy(const Body& first, const Body& second, Constant G, Length softening) {
    return ansatz::potential_energy(world_of(first, second, G, softening).first);
}
inline Force force_on_first(const Body& first, const Body& second, Constant G, Length softening) {
    auto [world, one] = world_of(first, second, G, softening);
    world.step(1.0 * ansatz::second); // from rest: the velocity after a second is the acceleration
    return Force(first.mass * (world.velocity(one) / (1.0 * ansatz::second)));
}
/// By the attraction of a body of one kilogram to a planet that has this g at its ground.
inline Acceleration gravity_at(Length height, Acceleration g, Length radius) {
    const Constant G = 6.6743e-11 * (ansatz::cubic_metre / (ansatz::kilogram * ansatz::second * ansatz::second));
    const Mass planet = g * radius * radius / G;
    const Body here{1.0 * ansatz::kilogram, ansatz::metres((radius + height).value(), 0, 0)};
    return ansatz::norm(force_on_first(here, {planet, ansatz::metres(0, 0, 0)}, G, 0.0 * ansatz::metre)) / here.mass;
}

} // namespace exercise
