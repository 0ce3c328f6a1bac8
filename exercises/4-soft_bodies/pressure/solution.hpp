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
    // task 1: return todo(1);
    const auto from = points[0];
    Quantity<unit::Volume> sum = 0.0 * cubic_metre;
    for (const auto& [a, b, c] : triangles) sum += dot(points[a] - from, cross(points[b] - from, points[c] - from));
    return sum / 6.0;
    // end of task 1
}

/// A gas, and what is around it.
struct Gas {
    Quantity<unit::Pressure> inside;  ///< of the gas, while its volume is `filled`
    Quantity<unit::Volume> filled;    ///< that volume
    Quantity<unit::Pressure> outside; ///< around the surface
};

/// 4.5: by how much more the inside presses than the outside, in Pa.
inline Quantity<unit::Pressure> pressure(const Gas& gas, Quantity<unit::Volume> volume) {
    // task 2: return todo(2);
    return gas.inside * gas.filled / volume - gas.outside;
    // end of task 2
}

/// 4.5: the force on each vertex, in N.
inline std::vector<VectorQuantity<unit::Force, 3>> forces(const Points& points, const Triangles& triangles,
                                                          Quantity<unit::Pressure> pressure) {
    // task 3: return todo(3);
    std::vector<VectorQuantity<unit::Force, 3>> all(points.size(), newtons(0, 0, 0));
    for (const auto& [a, b, c] : triangles) {
        const auto twice = cross(points[b] - points[a], points[c] - points[a]);
        const VectorQuantity<unit::Force, 3> share = pressure / 6.0 * twice;
        all[a] += share;
        all[b] += share;
        all[c] += share;
    }
    return all;
    // end of task 3
}

} // namespace exercise
