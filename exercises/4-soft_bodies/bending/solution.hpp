// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <cstddef>

using namespace ansatz;

namespace exercise {

/// Where the corners of a hinge are: a and b, the ends of the edge, then c and d, the third corners of the two
/// triangles. As you look from a to b with the normals upwards, c is on the left and d on the right.
using Corners = std::array<VectorQuantity<unit::Length, 3>, 4>;
using Angle = Quantity<unit::PlaneAngle>;

/// 4.6: the angle of the hinge, from -pi to pi: 0 flat, positive on a ridge.
inline Angle angle(const Corners& at) {
    // task 1: return todo(1);
    const auto& [a, b, c, d] = at;
    const auto e = b - a;
    const auto n1 = cross(e, c - a), n2 = cross(d - a, e);
    return atan2(dot(cross(n1, n2), e) / norm(e), dot(n1, n2));
    // end of task 1
}

/// By how many radians for each metre of its way a corner changes the angle.
using Gradient = VectorQuantity<unit::InverseLength, 3>;

/// 4.6: the gradient of the angle with respect to each of a, b, c and d, in 1/m.
inline std::array<Gradient, 4> gradient(const Corners& at) {
    // task 2: return todo(2);
    const auto& [a, b, c, d] = at;
    const auto e = b - a;
    const auto left = cross(e, c - a), right = cross(d - a, e);
    const Gradient up_left = norm(e) / dot(left, left) * left; // the unit normal over the height
    const Gradient up_right = norm(e) / dot(right, right) * right;
    const double s = dot(c - a, e) / dot(e, e); // where the foot of the height lies: 0 at a, 1 at b
    const double t = dot(d - a, e) / dot(e, e);
    return {(1 - s) * up_left + (1 - t) * up_right, s * up_left + t * up_right, -up_left, -up_right};
    // end of task 2
}

/// 4.6: the force on each of a, b, c and d, of a hinge with the energy k (theta - theta_0)^2 / 2.
/// \param stiffness k, in J for a squared radian
/// \param rest      theta_0, from -pi to pi
inline std::array<VectorQuantity<unit::Force, 3>, 4> forces(const Corners& at, Quantity<unit::Energy> stiffness,
                                                            Angle rest) {
    // task 3: return todo(3);
    const Angle turn = degrees(360.0);
    Angle off = angle(at) - rest;
    if (off > turn / 2.0) off -= turn;
    else if (off < -turn / 2.0) off += turn;
    const auto of_angle = gradient(at);
    std::array<VectorQuantity<unit::Force, 3>, 4> all;
    for (std::size_t i = 0; i < 4; ++i) all[i] = -stiffness * double(off / radian) * of_angle[i];
    return all;
    // end of task 3
}

} // namespace exercise
