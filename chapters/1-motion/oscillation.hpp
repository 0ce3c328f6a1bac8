// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A mass on a spring through the real World, recorded step by step: the scene of sections 1.6.1 to 1.6.4.

#include "problems.hpp"

#include <ansatz/world.hpp>

#include <vector>

namespace problems {

/// What a run of the oscillator left behind, one entry for each step.
struct Recording {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> places;
    std::vector<Quantity<unit::Velocity>> velocities;
    std::vector<Quantity<unit::SpecificEnergy>> energies; ///< kinetic and potential, for each kilogram
};

/// Starts at 1 m with the velocity `v0` and takes `steps` steps of `dt`.
template <class Integrator>
Recording oscillate(Quantity<unit::Frequency> omega, Quantity<unit::Time> dt, int steps,
                    Quantity<unit::Velocity> v0 = 0.0 * metre_per_second) {
    World world{Integrator{}, Oscillator{omega}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(v0 * Vector<double, 3>(1, 0, 0)));
    Recording run;
    auto record = [&] {
        run.times.push_back(world.time());
        run.places.push_back(x(world.position(body)));
        run.velocities.push_back(x(world.velocity(body)));
        run.energies.push_back(0.5 * run.velocities.back() * run.velocities.back() +
                               0.5 * omega * omega * run.places.back() * run.places.back());
    };
    record();
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        record();
    }
    return run;
}

} // namespace problems
