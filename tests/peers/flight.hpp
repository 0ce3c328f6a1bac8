// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The scene that `peers scale` and `peers threads` have in common.

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include <random>

namespace peers {

/// Bodies that fly through air.
/// \param execution what runs the loops of a step, if anything does
auto flight(int n, auto... execution) {
    using namespace ansatz;
    World world{Space<float, 3>{}, RungeKutta4{}, Gravity{}, Drag{0.1 / second}, execution...};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> at(-100, 100);
    for (int i = 0; i < n; ++i) {
        const double x = at(random), y = at(random), z = at(random);
        world.add(position(metres(x, y, z)), velocity(metres_per_second(z / 10, x / 10, y / 10)));
    }
    return world;
}

} // namespace peers
