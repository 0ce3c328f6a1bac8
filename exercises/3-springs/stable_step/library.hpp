// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/springs/step_limit.hpp>
#include <ansatz/world.hpp>

namespace exercise {

/// The library asks the integrator itself, by what a step does to two states, so that any integrator may stand here.
inline ansatz::Quantity<ansatz::unit::Time> largest_step(ansatz::Quantity<ansatz::unit::Mass> mass,
                                                         ansatz::Quantity<ansatz::unit::Stiffness> stiffness,
                                                         ansatz::Quantity<ansatz::unit::Damping> damping) {
    return ansatz::stable_step<ansatz::SemiImplicitEuler>(stiffness / mass, damping / mass);
}

/// How StepLimit divides a step, once it knows the limit of its world. This one has no springs, and is told.
inline int parts_of(ansatz::Quantity<ansatz::unit::Time> frame, ansatz::Quantity<ansatz::unit::Time> limit) {
    const ansatz::World world{ansatz::SemiImplicitEuler{}};
    using StepLimit = ansatz::StepLimit<ansatz::Divide>;
    StepLimit::Kept known;
    known.of = ansatz::stiffness_of(world);
    known.limit = limit;
    known.found = true;
    return StepLimit{}.parts(world, frame, known);
}

} // namespace exercise
