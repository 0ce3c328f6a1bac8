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
    // task 1: return todo(1);
    const int i = std::min(int(double(x / map.dx)), map.points_x - 2);
    const int j = std::min(int(double(z / map.dz)), map.points_z - 2);
    const double u = double(x / map.dx) - i, v = double(z / map.dz) - j;
    const auto* low = &map.heights[i + map.points_x * j];
    const auto* high = low + map.points_x;
    return (1 - v) * ((1 - u) * low[0] + u * low[1]) + v * ((1 - u) * high[0] + u * high[1]);
    // end of task 1
}

/// 7.1: the normal of that surface, upwards, of length 1.
inline Vector<double, 3> normal(const Map& map, Quantity<unit::Length> x, Quantity<unit::Length> z) {
    // task 2: return todo(2);
    const int i = std::min(int(double(x / map.dx)), map.points_x - 2);
    const int j = std::min(int(double(z / map.dz)), map.points_z - 2);
    const double u = double(x / map.dx) - i, v = double(z / map.dz) - j;
    const auto* low = &map.heights[i + map.points_x * j];
    const auto* high = low + map.points_x;
    const double by_x = ((1 - v) * (low[1] - low[0]) + v * (high[1] - high[0])) / map.dx;
    const double by_z = ((1 - u) * (high[0] - low[0]) + u * (high[1] - low[1])) / map.dz;
    return Vector<double, 3>(-by_x, 1, -by_z).normalized();
    // end of task 2
}

/// 7.4: the same surface with the sides of its cells divided into so many lengths.
inline Map tessellated(const Map& map, int factor) {
    // task 3: return todo(3);
    Map fine = map;
    fine.points_x = (map.points_x - 1) * factor + 1;
    fine.points_z = (map.points_z - 1) * factor + 1;
    fine.dx = map.dx / double(factor);
    fine.dz = map.dz / double(factor);
    fine.heights.clear();
    for (int j = 0; j < fine.points_z; ++j)
        for (int i = 0; i < fine.points_x; ++i) {
            const auto x = min(double(i) * fine.dx, double(map.points_x - 1) * map.dx);
            const auto z = min(double(j) * fine.dz, double(map.points_z - 1) * map.dz);
            fine.heights.push_back(height(map, x, z));
        }
    return fine;
    // end of task 3
}

} // namespace exercise
