// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;

namespace exercise {

/// Heights at the points of a grid, the first of which is at x = 0 and z = 0.
struct Map {
    int points_x, points_z; ///< how many, at least 2 each
    Quantity<unit::Length> dx, dz;
    std::vector<Quantity<unit::Length>> heights; ///< of point i along x and j along z: number i + points_x * j
};

/// 7.1: the bilinear height of a place on the map.
inline Quantity<unit::Length> height(const Map& map, Quantity<unit::Length> x, Quantity<unit::Length> z) {
    return todo(1);
}

/// 7.1: the normal of that surface, upwards, of length 1.
inline Vector<double, 3> normal(const Map& map, Quantity<unit::Length> x, Quantity<unit::Length> z) {
    return todo(2);
}

/// 7.4: the same surface with the sides of its cells divided into so many lengths.
inline Map tessellated(const Map& map, int factor) {
    return todo(3);
}

} // namespace exercise
