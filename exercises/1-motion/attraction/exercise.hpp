// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

using Mass = Quantity<unit::Mass>;
using Length = Quantity<unit::Length>;
using Acceleration = Quantity<unit::Acceleration>;
using Energy = Quantity<unit::Energy>;
using Place = VectorQuantity<unit::Length, 3>;
using Force = VectorQuantity<unit::Force, 3>;
using Constant = Quantity<unit::GravitationalConstant>;

/// A planet, or what else has a mass.
struct Body {
    Mass mass;
    Place place;
};

/// 1.9: what is left of g, which is that at the ground of a planet of this radius, at a height above the ground.
inline Acceleration gravity_at(Length height, Acceleration g, Length radius) {
    return todo(1);
}

/// What the first of two bodies holds, less than nothing, because the second attracts it; in J. `softening` is epsilon:
/// the distance r is taken for the root of r^2 + epsilon^2, so that nothing is divided by zero where two meet.
inline Energy potential_energy(const Body& first, const Body& second, Constant G, Length softening) {
    return todo(2);
}

/// The force of the second on the first, with the same softening: how fast that energy falls along each axis.
inline Force force_on_first(const Body& first, const Body& second, Constant G, Length softening) {
    return todo(3);
}

} // namespace exercise
