// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

namespace exercise {

using ansatz::SemiImplicitEuler;

/// Nothing of this name is in the library; what it states is measured on the library's integrator instead. A linear map
/// that keeps areas keeps the area between a state and its image, and this is that area over dt.
inline ansatz::Quantity<ansatz::unit::SpecificEnergy> kept_energy(ansatz::Quantity<ansatz::unit::Length> x,
                                                                  ansatz::Quantity<ansatz::unit::Velocity> v,
                                                                  ansatz::Quantity<ansatz::unit::Frequency> omega,
                                                                  ansatz::Quantity<ansatz::unit::Time> dt) {
    auto next_x = x;
    auto next_v = v;
    SemiImplicitEuler::advance(ansatz::Stage<0>{}, next_x, next_v, -omega * omega * x, dt);
    return 0.5 * (v * next_x - x * next_v) / dt;
}

/// Measured too: the step at which the matrix of one step of the library's integrator has the eigenvalue -1, by
/// bisection.
inline ansatz::Quantity<ansatz::unit::Time> largest_step(ansatz::Quantity<ansatz::unit::Frequency> omega,
                                                         ansatz::Quantity<ansatz::unit::Frequency> c) {
    const auto metre = 1.0 * ansatz::metre;
    const auto speed = 1.0 * ansatz::metre_per_second;
    auto stable = [&](ansatz::Quantity<ansatz::unit::Time> dt) {
        auto xx = metre, xv = 0.0 * metre;
        auto vx = 0.0 * speed, vv = speed;
        SemiImplicitEuler::advance(ansatz::Stage<0>{}, xx, vx, -omega * omega * metre, dt);
        SemiImplicitEuler::advance(ansatz::Stage<0>{}, xv, vv, -c * speed, dt);
        const double trace = xx / metre + vv / speed;
        const double determinant = xx * vv / (metre * speed) - xv * vx / (metre * speed);
        return 1 + trace + determinant > 0;
    };
    auto inside = 0.0 / omega, outside = 3.0 / omega;
    for (int i = 0; i < 60; ++i) {
        const auto middle = 0.5 * (inside + outside);
        (stable(middle) ? inside : outside) = middle;
    }
    return inside;
}

} // namespace exercise
