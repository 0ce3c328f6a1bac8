// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of chapter 2 share: worlds of every integrator and response, and the bodies that meet in them.

#include <ansatz/collision.hpp>

#include "tests/motion/support.hpp"
#include "tests/refusal.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace collision_tests {

using namespace motion_tests;
using ansatz::test::refusal;

/// A world in which spheres, planes and boxes collide.
template <class... P> auto world_of(P... policies) {
    return World{policies..., BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{}};
}

/// Two spheres of radius 0.5 m on the first axis that overlap by 0.1 m, with these velocities and masses.
template <class World_>
std::pair<Handle, Handle> two_spheres(World_& world, double va, double vb, double ma = 1, double mb = 1, double e = 0) {
    using S = typename World_::S;
    auto add = [&](double x, double v, double m) {
        if constexpr (World_::composition::template stores<Restitution>)
            return world.add(Sphere{0.5 * metre}, at<S>(x), going<S>(v), mass(m * kilogram), restitution(e));
        else return world.add(Sphere{0.5 * metre}, at<S>(x), going<S>(v), mass(m * kilogram));
    };
    const auto a = add(0, va, ma), b = add(0.9, vb, mb);
    return {a, b};
}
template <class World_> double x_of(const World_& world, Handle body) {
    return double(world.position(body).value()[0]);
}
template <class World_> double height_of(const World_& world, Handle body) {
    return double(world.position(body).value()[1]);
}
template <class World_> double speed_along(const World_& world, Handle body, int axis = 0) {
    return double(world.velocity(body).value()[axis]);
}

/// What a scalar can tell apart, times a size.
template <class S> double rounding(double size) {
    return size * double(std::numeric_limits<typename S::Scalar>::epsilon());
}

} // namespace collision_tests
