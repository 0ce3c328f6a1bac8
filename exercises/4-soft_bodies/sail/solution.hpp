// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <cstdint>
#include <vector>

using namespace ansatz;

namespace exercise {

using Position = VectorQuantity<unit::Length, 3>;
using Speed = VectorQuantity<unit::Velocity, 3>;
using Facing = VectorQuantity<unit::Area, 3>;
using Push = VectorQuantity<unit::Force, 3>;

/// The air, and how a sail feels it.
struct Air {
    Quantity<unit::Density> density;
    double drag; ///< c_D
    double lift; ///< c_L
};

struct Cloth {
    std::vector<Position> points;
    std::vector<Speed> velocities;                       ///< of the points
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< by point
};

/// 4.7: the area of a triangle, at right angles to it.
inline Facing area(const Position& a, const Position& b, const Position& c) {
    // task 1: return todo(1);
    return 0.5 * cross(b - a, c - a);
    // end of task 1
}

/// 4.7: the force on a sail past which the air moves with `w`.
inline Push force(const Facing& area, const Speed& w, const Air& air) {
    // task 2: return todo(2);
    const auto speed = norm(w);
    if (speed == 0.0 * metre_per_second) return newtons(0, 0, 0);
    const auto through = dot(area, w); // A u, with the sign of the side
    const double side = through < through * 0.0 ? -1 : 1;
    const Push drag = 0.5 * air.density * air.drag * side * through * w;
    const auto across = side * speed * area - side * through / speed * w; // A (|w| n - u w^)
    const Push lift = 0.5 * air.density * air.lift * (side * through / norm(area)) * across;
    return drag + lift;
    // end of task 2
}

/// 4.7: the force on each point of a cloth in the wind.
inline std::vector<Push> blow(const Cloth& cloth, const Speed& wind, const Air& air) {
    // task 3: return todo(3);
    const auto& [points, velocities, triangles] = cloth;
    std::vector<Push> forces(points.size(), newtons(0, 0, 0));
    for (const auto& [a, b, c] : triangles) {
        const Speed w = wind - (velocities[a] + velocities[b] + velocities[c]) / 3.0;
        const Push third = force(area(points[a], points[b], points[c]), w, air) / 3.0;
        forces[a] += third;
        forces[b] += third;
        forces[c] += third;
    }
    return forces;
    // end of task 3
}

} // namespace exercise
