// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// One end of a spring.
struct End {
    VectorQuantity<unit::Length, 3> position;
    VectorQuantity<unit::Velocity, 3> velocity;
    Quantity<unit::InverseMass> inverse_mass; ///< zero where it is held
};
struct Spring {
    Quantity<unit::Length> rest_length;
    Quantity<unit::Stiffness> stiffness;
};
/// A force times the square of a time: N s^2, which is kg m.
using Multiplier = decltype(Quantity<unit::Mass>() * Quantity<unit::Length>());

/// 4.4: by how much the multiplier of a spring changes in one correction.
/// \param stretch    how much longer than at rest it is
/// \param multiplier what it has given in this step already
/// \param weights    the sum of 1/m of both ends
/// \param h          the length of the step
inline Multiplier change(Quantity<unit::Length> stretch, Multiplier multiplier, Quantity<unit::Stiffness> stiffness,
                         Quantity<unit::InverseMass> weights, Quantity<unit::Time> h) {
    // task 1: return todo(1);
    const Quantity<unit::Mass> k = h * h * stiffness;
    return -(multiplier + k * stretch) / (1.0 + k * weights);
    // end of task 1
}

/// 4.4: one correction of a spring: moves both ends, corrects their velocities, and returns the multiplier afterwards.
inline Multiplier hold(End& first, End& second, const Spring& spring, Multiplier multiplier, Quantity<unit::Time> h) {
    // task 2: return todo(2);
    const VectorQuantity<unit::Length, 3> to = second.position - first.position;
    const auto by = change(norm(to) - spring.rest_length, multiplier, spring.stiffness,
                           first.inverse_mass + second.inverse_mass, h);
    const VectorQuantity<unit::Length, 3> way_of_first = -first.inverse_mass * by * (to / norm(to));
    const VectorQuantity<unit::Length, 3> way_of_second = second.inverse_mass * by * (to / norm(to));
    first.position += way_of_first;
    second.position += way_of_second;
    first.velocity += way_of_first / h;
    second.velocity += way_of_second / h;
    return multiplier + by;
    // end of task 2
}

/// 4.4: a step of dt, in so many substeps, in each of which the spring is corrected so many times.
inline void step(End& first, End& second, const Spring& spring, const VectorQuantity<unit::Acceleration, 3>& gravity,
                 Quantity<unit::Time> dt, int substeps, int iterations) {
    // task 3: todo(3);
    const auto h = dt / double(substeps);
    for (int part = 0; part < substeps; ++part) {
        for (End* end : {&first, &second}) {
            if (end->inverse_mass > 0.0 / kilogram) end->velocity += h * gravity;
            end->position += h * end->velocity;
        }
        Multiplier multiplier = 0.0 * kilogram * metre;
        for (int i = 0; i < iterations; ++i) multiplier = hold(first, second, spring, multiplier, h);
    }
    // end of task 3
}

} // namespace exercise
