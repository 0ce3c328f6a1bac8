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
    return todo(1);
}

/// 4.7: the force on a sail past which the air moves with `w`.
inline Push force(const Facing& area, const Speed& w, const Air& air) {
    return todo(2);
}

/// 4.7: the force on each point of a cloth in the wind.
inline std::vector<Push> blow(const Cloth& cloth, const Speed& wind, const Air& air) {
    return todo(3);
}

} // namespace exercise
