// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace ansatz;

namespace exercise {

/// A row of columns.
struct Surface {
    Quantity<unit::Length> width;                ///< of a column; column i stands at i times that
    std::vector<Quantity<unit::Length>> heights; ///< of the columns
    std::vector<Quantity<unit::Velocity>> rises; ///< how fast each goes up
};
/// What lies on it.
struct Body {
    VectorQuantity<unit::Length, 2> position; ///< of its middle: x along the surface, y up
    VectorQuantity<unit::Velocity, 2> velocity;
    Quantity<unit::Length> radius; ///< down to its lowest point, and of its footprint
};
/// The spring between both.
struct Contact {
    Quantity<unit::Stiffness> stiffness; ///< k
    Quantity<unit::Damping> damping;     ///< c
};
struct Forces {
    VectorQuantity<unit::Force, 2> on_body;
    std::vector<Quantity<unit::Force>> on_columns; ///< up
};

/// Of numbers by column.
template <class Q> Q mean(const std::vector<Q>& of, const std::vector<double>& weights) {
    Q sum{};
    for (std::size_t i = 0; i < of.size(); ++i) sum += weights[i] * of[i];
    return sum;
}

/// 7.4.3: how much each column counts for a body over x; 1 in all.
inline std::vector<double> weights(const Surface& surface, Quantity<unit::Length> x, Quantity<unit::Length> reach) {
    // task 1: return todo(1);
    std::vector<double> all;
    double sum = 0;
    for (std::size_t i = 0; i < surface.heights.size(); ++i) {
        const double away = (double(i) * surface.width - x) / reach;
        const double rest = std::max(0.0, 1 - away * away);
        all.push_back(rest * rest);
        sum += rest * rest;
    }
    if (sum > 0)
        for (double& weight : all) weight /= sum;
    return all;
    // end of task 1
}

/// 7.4.3: how fast the mean height rises with x.
inline double slope(const Surface& surface, Quantity<unit::Length> x, Quantity<unit::Length> reach) {
    // task 2: return todo(2);
    const auto level = mean(surface.heights, weights(surface, x, reach));
    double sum = 0;
    Quantity<unit::Length> rise{};
    for (std::size_t i = 0; i < surface.heights.size(); ++i) {
        const double away = (double(i) * surface.width - x) / reach;
        const double rest = std::max(0.0, 1 - away * away);
        sum += rest * rest;
        rise += 4 * rest * away * (surface.heights[i] - level); // R times the derivative of the weight
    }
    if (sum == 0) return 0;
    return rise / (reach * sum);
    // end of task 2
}

/// 7.4.3: what a body and the surface do to each other.
inline Forces carry(const Surface& surface, const Body& body, const Contact& contact) {
    // task 3: return todo(3);
    const auto at = x(body.position);
    const auto each = weights(surface, at, body.radius);
    Forces forces{newtons(0, 0), std::vector<Quantity<unit::Force>>(each.size(), 0.0 * newton)};
    const bool over = std::any_of(each.begin(), each.end(), [](double weight) { return weight > 0; });
    const auto depth = mean(surface.heights, each) - (y(body.position) - body.radius);
    if (!over || depth <= 0.0 * metre) return forces;
    const double rises = slope(surface, at, body.radius);
    const auto deepens = mean(surface.rises, each) + rises * x(body.velocity) - y(body.velocity);
    const Quantity<unit::Force> push = contact.stiffness * depth + contact.damping * deepens;
    if (push <= 0.0 * newton) return forces;
    forces.on_body = push * Eigen::Vector2d(-rises, 1);
    for (std::size_t i = 0; i < each.size(); ++i) forces.on_columns[i] = -each[i] * push;
    return forces;
    // end of task 3
}

} // namespace exercise
