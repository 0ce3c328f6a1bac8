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
    return todo(1);
}

/// 4.4: one correction of a spring: moves both ends, corrects their velocities, and returns the multiplier afterwards.
inline Multiplier hold(End& first, End& second, const Spring& spring, Multiplier multiplier, Quantity<unit::Time> h) {
    return todo(2);
}

/// 4.4: a step of dt, in so many substeps, in each of which the spring is corrected so many times.
inline void step(End& first, End& second, const Spring& spring, const VectorQuantity<unit::Acceleration, 3>& gravity,
                 Quantity<unit::Time> dt, int substeps, int iterations) {
    todo(3);
}

} // namespace exercise
