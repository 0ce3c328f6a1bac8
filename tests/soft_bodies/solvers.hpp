// SPDX-License-Identifier: BSL-1.0
// Worlds that the tests of soft bodies share.
#pragma once

#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace soft_bodies_tests {

using namespace ansatz;

inline constexpr auto frame = 1.0 / 60 * second;

/// A world that hangs together by a solver, or by the forces of its springs where none is given.
template <class Scalar, int Dim = 3, class... Solver> auto world_of(const Solver&... solver) {
    return World{Space<Scalar, Dim>{}, SemiImplicitEuler{}, Gravity{}, Springs<>{}, solver...};
}

/// A chain that hangs from a fixed body: `length` apart, all of one mass.
template <class World_>
std::vector<Handle> hang_chain(World_& world, int bodies, double each, double stiffness, double damping = 0,
                               double length = 0.1) {
    std::vector<Handle> all{world.add(position(metres(0, 0, 0)), fixed)};
    for (int n = 1; n <= bodies; ++n) {
        all.push_back(world.add(position(metres(0, -length * n, 0)), mass(each * kilogram)));
        world.add(Spring{all[std::size_t(n) - 1], all.back(), stiffness * newton_per_metre,
                         damping * newton_second_per_metre});
    }
    return all;
}

/// A horizontal sheet of n x n bodies, with springs along its edges and across its cells.
template <class World_>
std::vector<Handle> lay_sheet(World_& world, int n, double side, double height, double each, double stiffness,
                              double damping, auto&&... property) {
    std::vector<Handle> all;
    const double apart = side / (n - 1);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            all.push_back(
                world.add(position(metres(apart * i, height, apart * j)), mass(each * kilogram), property...));
    const auto join = [&](int a, int b) {
        world.add(Spring{all[std::size_t(a)], all[std::size_t(b)], stiffness * newton_per_metre,
                         damping * newton_second_per_metre});
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const int here = i * n + j;
            if (i + 1 < n) join(here, here + n);
            if (j + 1 < n) join(here, here + 1);
            if (i + 1 < n && j + 1 < n) {
                join(here, here + n + 1);
                join(here + 1, here + n);
            }
        }
    return all;
}

} // namespace soft_bodies_tests
