// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <cstdint>
#include <vector>

using namespace ansatz;

namespace exercise {

using Points = std::vector<VectorQuantity<unit::Length, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>; ///< by vertex, anticlockwise as seen from outside

/// 4.5: the volume that a closed surface encloses, in m^3.
inline Quantity<unit::Volume> volume(const Points& points, const Triangles& triangles) {
    return todo(1);
}

/// A gas, and what is around it.
struct Gas {
    Quantity<unit::Pressure> inside;  ///< of the gas, while its volume is `filled`
    Quantity<unit::Volume> filled;    ///< that volume
    Quantity<unit::Pressure> outside; ///< around the surface
};

/// 4.5: by how much more the inside presses than the outside, in Pa.
inline Quantity<unit::Pressure> pressure(const Gas& gas, Quantity<unit::Volume> volume) {
    return todo(2);
}

/// 4.5: the force on each vertex, in N.
inline std::vector<VectorQuantity<unit::Force, 3>> forces(const Points& points, const Triangles& triangles,
                                                          Quantity<unit::Pressure> pressure) {
    return todo(3);
}

} // namespace exercise
