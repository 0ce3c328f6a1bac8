// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One body in one pool, for the tests of what water does to bodies and bodies to water.

#include <ansatz/water.hpp>
#include <ansatz/water/bodies_in_water.hpp>
#include <ansatz/water/buoyancy.hpp>
#include <ansatz/water/floating.hpp>
#include <ansatz/world.hpp>

#include "tests/water/support.hpp"

namespace water_tests {

inline constexpr double g = 9.81;
using Lake = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Buoyancy>;
inline const WaterColumns calm{3.0 * mps, 0.5 / second};

/// A body in a pool.
struct BodyInPool {
    Lake world{{}, {}, {}, {}};
    PoolHandle<WaterColumns> pool;
    Handle body;
    FloatingHandle floating;

    BodyInPool(const ColumnGrid& grid, double level, Floating by, double kilograms, double x, double y, double z,
               const WaterColumns& policy = calm) {
        pool = world.add(Pool{Surface{policy, grid, level * metre}});
        body = world.add(position(metres(x, y, z)), mass(kilograms * kilogram));
        by.body = body;
        floating = world.add(by);
    }
    void steps(int n, double dt) {
        for (int i = 0; i < n; ++i) world.step(dt * second);
    }
    double y() const { return world.position(body).value()[1]; }
    double v() const { return world.velocity(body).value()[1]; }
    auto now() const { return world.afloat(floating); }
    double level() const { return now().level.value(); }
};
inline ColumnGrid pond() { return ColumnGrid(20, 20, 0.5 * metre); } // 10 m x 10 m
inline Floating only(const std::variant<Sphere, Box, FixedLift, SurfaceSpring>& by, double damping = 0,
                     double drag = 0) {
    return {{}, by, drag, damping / second, false};
}
inline Floating pressing(const std::variant<Sphere, Box, FixedLift, SurfaceSpring>& by, double damping = 2) {
    return {{}, by, 0, damping / second, true};
}
inline const Box cube{metres(0.5, 0.5, 0.5)};
inline const Sphere ball{0.5 * metre};
inline constexpr double ball_volume = 4.0 / 3 * pi * 0.125;

} // namespace water_tests
