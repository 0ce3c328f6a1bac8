// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of chapter 4 share: sheets in worlds of any scalar and dimension, and what is measured on them.

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace soft_tests {

using namespace ansatz;
using ansatz::test::refusal;
using Catch::Approx;

inline constexpr auto N_per_m = 1.0 * newton_per_metre;
inline constexpr auto N_s_per_m = 1.0 * newton_second_per_metre;
inline constexpr auto kg_per_m2 = kilogram / square_metre;

/// A sheet of n x m vertices, 0.1 m apart, in the plane of x and y: row 0 at the bottom.
inline TriangleMesh sheet(std::size_t n, std::size_t m) {
    return TriangleMesh::grid(n, m, metres(0.1 * double(n - 1), 0, 0), metres(0, 0.1 * double(m - 1), 0));
}
/// The same with springs of all three kinds, of which none is like another.
inline Cloth woven(std::size_t n, std::size_t m) {
    return {.mesh = sheet(n, m),
            .mass_per_area = 0.15 * kg_per_m2,
            .structural = {20.0 * N_per_m, 0.02 * N_s_per_m},
            .shear = {7.0 * N_per_m, 0.01 * N_s_per_m},
            .bend = {3.0 * N_per_m, 0.03 * N_s_per_m}};
}
/// The largest tension of a spring, N, without its sign.
template <class Policy = Springs<>, class World_> double largest_tension(const World_& world) {
    double largest = 0;
    typename Policy::template In<typename World_::S>(world.template get<Policy>())
        .tensions(world.template view<Policy>(), [&](std::uint32_t, const auto& tension, const auto&) {
            largest = std::max(largest, std::abs(double(tension.value())));
        });
    return largest;
}
template <class World_> double mass_of_all(const World_& world) {
    double sum = 0;
    for (const auto weight : world.template lane<InverseMass>())
        if (weight > 0) sum += 1 / double(weight);
    return sum;
}
template <class World_> void run(World_& world, int steps, double dt) {
    for (int i = 0; i < steps; ++i) world.step(dt * second);
}

} // namespace soft_tests
