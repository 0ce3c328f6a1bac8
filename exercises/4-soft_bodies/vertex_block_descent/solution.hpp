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
    // task 1: return todo(1);
    VectorQuantity<unit::Force, 3> sum = body.mass / (h * h) * (x - body.flown);
    for (const Spring& spring : springs) {
        const Place from = x - spring.neighbour;
        sum += spring.stiffness * (norm(from) - spring.rest_length) * (from / norm(from));
    }
    return sum;
    // end of task 1
}

/// 4.4: the second derivative of G, in N/m, without what is negative across a spring that is pressed together.
inline Eigen::Matrix3d curvature(const Body& body, const Place& x, const std::vector<Spring>& springs,
                                 Quantity<unit::Time> h) {
    // task 2: return todo(2);
    Eigen::Matrix3d sum = (body.mass / (h * h)).value() * Eigen::Matrix3d::Identity();
    for (const Spring& spring : springs) {
        const Place from = x - spring.neighbour;
        const double length = norm(from).value(), k = spring.stiffness.value();
        const Eigen::Vector3d axis = from.value() / length;
        const Eigen::Matrix3d along = axis * axis.transpose();
        const double stretch = std::max(0.0, length - spring.rest_length.value());
        sum += k * along;
        sum += k * stretch / length * (Eigen::Matrix3d::Identity() - along);
    }
    return sum;
    // end of task 2
}

/// 4.4: where the body is after so many steps of Newton's method.
inline Place solve(const Body& body, const std::vector<Spring>& springs, Quantity<unit::Time> h, int iterations) {
    // task 3: return todo(3);
    Place x = body.flown;
    for (int n = 0; n < iterations; ++n) {
        const Eigen::Vector3d downhill = -slope(body, x, springs, h).value();
        x += Place::from_value(curvature(body, x, springs, h).inverse() * downhill);
    }
    return x;
    // end of task 3
}

} // namespace exercise
