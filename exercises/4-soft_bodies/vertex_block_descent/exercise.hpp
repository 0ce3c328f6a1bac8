// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <Eigen/LU>

#include <vector>

using namespace ansatz;

namespace exercise {

using Place = VectorQuantity<unit::Length, 3>;

/// A body, and where it would be at the end of the step without any spring.
struct Body {
    Quantity<unit::Mass> mass;
    Place flown;
};
/// A spring from the body to a neighbour that stands still.
struct Spring {
    Place neighbour;
    Quantity<unit::Length> rest_length;
    Quantity<unit::Stiffness> stiffness;
};

/// 4.4: the gradient of the energy G, where the body is at x.
inline VectorQuantity<unit::Force, 3> slope(const Body& body, const Place& x, const std::vector<Spring>& springs,
                                            Quantity<unit::Time> h) {
    return todo(1);
}

/// 4.4: the second derivative of G, in N/m, without what is negative across a spring that is pressed together.
inline Eigen::Matrix3d curvature(const Body& body, const Place& x, const std::vector<Spring>& springs,
                                 Quantity<unit::Time> h) {
    return todo(2);
}

/// 4.4: where the body is after so many steps of Newton's method.
inline Place solve(const Body& body, const std::vector<Spring>& springs, Quantity<unit::Time> h, int iterations) {
    return todo(3);
}

} // namespace exercise
