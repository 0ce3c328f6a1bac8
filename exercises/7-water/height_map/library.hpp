// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/water/height_map.hpp>
#include <ansatz/world.hpp>

#include <vector>

namespace exercise {

struct Map {
    int points_x, points_z;
    ansatz::Quantity<ansatz::unit::Length> dx, dz;
    std::vector<ansatz::Quantity<ansatz::unit::Length>> heights;
};

inline ansatz::HeightMap<double> made(const Map& map) {
    ansatz::HeightMap<double> all(std::size_t(map.points_x), std::size_t(map.points_z), map.dx, map.dz);
    for (std::size_t j = 0; j < all.points_z(); ++j)
        for (std::size_t i = 0; i < all.points_x(); ++i) all.set(i, j, map.heights[i + all.points_x() * j]);
    return all;
}

inline ansatz::Quantity<ansatz::unit::Length> height(const Map& map, ansatz::Quantity<ansatz::unit::Length> x,
                                                     ansatz::Quantity<ansatz::unit::Length> z) {
    return made(map).height(x, z);
}

inline ansatz::Vector<double, 3> normal(const Map& map, ansatz::Quantity<ansatz::unit::Length> x,
                                        ansatz::Quantity<ansatz::unit::Length> z) {
    return made(map).normal(x, z);
}

inline Map tessellated(const Map& map, int factor) {
    const auto fine = made(map).tessellated(std::size_t(factor));
    Map all{int(fine.points_x()), int(fine.points_z()), fine.dx(), fine.dz(), {}};
    for (const double y : fine.heights()) all.heights.push_back(y * ansatz::metre);
    return all;
}

} // namespace exercise
