// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs/hooke.hpp>

#include <optional>

namespace exercise {

using Mass = ansatz::Quantity<ansatz::unit::Mass>;
using Length = ansatz::Quantity<ansatz::unit::Length>;
using Velocity = ansatz::Quantity<ansatz::unit::Velocity>;
using Acceleration = ansatz::Quantity<ansatz::unit::Acceleration>;
using Force = ansatz::Quantity<ansatz::unit::Force>;
using Stiffness = ansatz::Quantity<ansatz::unit::Stiffness>;
using Damping = ansatz::Quantity<ansatz::unit::Damping>;

inline Force pull(Length length, Length rest_length, Velocity lengthens, Stiffness stiffness, Damping damping) {
    return ansatz::springs::tension<ansatz::springs::Acts::pulling>(length, rest_length, lengthens, stiffness, damping);
}

/// The library lets the load fall. Here: how far the rope is stretched when it holds all that the fall and
/// the weight have given.
inline Force peak_pull(Mass mass, Acceleration g, Velocity speed, Stiffness stiffness) {
    Length less = mass * g / stiffness, more = 1e6 * ansatz::metre;
    for (int i = 0; i < 200; ++i) {
        const Length x = 0.5 * (less + more);
        (ansatz::springs::energy(stiffness, x) < 0.5 * mass * speed * speed + mass * g * x ? less : more) = x;
    }
    return -ansatz::springs::force(stiffness, less);
}
inline std::optional<Length> highest_fall(Mass mass, Acceleration g, Length rest_length, Force per_strain,
                                          Force strength) {
    const Length x = strength / per_strain * rest_length; // how far it is stretched when it pulls as hard as it may
    const auto held = ansatz::springs::energy(Stiffness(per_strain / rest_length), x);
    const Length from = held / (mass * g) - x; // all of it came from falling, x of it on the rope
    return from < 0.0 * ansatz::metre ? std::nullopt : std::optional<Length>(from);
}

} // namespace exercise
