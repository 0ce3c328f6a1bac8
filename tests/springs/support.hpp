// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of chapter 3 share: chains, and springs in worlds of any scalar and dimension.

#include <ansatz/motion/integrators/cholesky.hpp>
#include <ansatz/springs.hpp>

#include "tests/motion/support.hpp"

#include <vector>

namespace spring_tests {

using namespace motion_tests;

inline constexpr auto N_per_m = 1.0 * newton_per_metre;
inline constexpr auto N_s_per_m = 1.0 * newton_second_per_metre;
using ImplicitEulerDirect = ImplicitEulerBy<Cholesky>;

/// A point of the space of a world.
template <class World_> auto point(const World_&, double x, double y = 0) {
    return vector_in<typename World_::S, unit::Length>(x, y);
}

/// Links of one stiffness below each other, the first at the origin: bodies at y = -length, -2 length, ...
template <class World_>
std::vector<Handle> hang_chain(World_& world, int links, double kilograms, double k, double c, double length,
                               double last_kilograms = 0) {
    using S = typename World_::S;
    std::vector<Handle> bodies;
    for (int i = 1; i <= links; ++i) {
        const double m = i == links && last_kilograms > 0 ? last_kilograms : kilograms;
        bodies.push_back(world.add(at<S>(0, -i * length), mass(m * kilogram)));
        Spring link{.first = bodies.back(),
                    .second = point(world, 0),
                    .stiffness = k * N_per_m,
                    .damping = c * N_s_per_m,
                    .rest_length = length * metre};
        if (i > 1) link.second = bodies[std::size_t(i) - 2];
        world.add(link);
    }
    return bodies;
}
/// What broke in the last step.
template <class E, class World_> auto broken(const World_& world) { return world.template elements<E>().broken(); }
template <class World_> double height(const World_& world, Handle body) {
    return double(world.position(body).value()[1]);
}

} // namespace spring_tests
