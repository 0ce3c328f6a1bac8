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
    return todo(1);
}

/// By how many radians for each metre of its way a corner changes the angle.
using Gradient = VectorQuantity<unit::InverseLength, 3>;

/// 4.6: the gradient of the angle with respect to each of a, b, c and d, in 1/m.
inline std::array<Gradient, 4> gradient(const Corners& at) {
    return todo(2);
}

/// 4.6: the force on each of a, b, c and d, of a hinge with the energy k (theta - theta_0)^2 / 2.
/// \param stiffness k, in J for a squared radian
/// \param rest      theta_0, from -pi to pi
inline std::array<VectorQuantity<unit::Force, 3>, 4> forces(const Corners& at, Quantity<unit::Energy> stiffness,
                                                            Angle rest) {
    return todo(3);
}

} // namespace exercise
