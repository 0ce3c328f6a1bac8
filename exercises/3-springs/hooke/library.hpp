// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs/hooke.hpp>
#include <ansatz/world.hpp>

namespace exercise {

using ansatz::springs::energy;
using ansatz::springs::force;

/// The library knows the tension of a spring by its length, and the force in a plane or in space. On a line it takes a
/// sign.
inline ansatz::Quantity<ansatz::unit::Force> force_on_first(ansatz::Quantity<ansatz::unit::Length> first,
                                                            ansatz::Quantity<ansatz::unit::Length> second,
                                                            ansatz::Quantity<ansatz::unit::Length> rest_length,
                                                            ansatz::Quantity<ansatz::unit::Stiffness> stiffness) {
    const auto still = 0.0 * ansatz::metre_per_second;
    const auto undamped = 0.0 * ansatz::newton_second_per_metre;
    const auto pull = ansatz::springs::tension(ansatz::abs(second - first), rest_length, still, stiffness, undamped);
    return second > first ? pull : -pull;
}

} // namespace exercise
