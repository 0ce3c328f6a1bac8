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
    return todo(1);
}

/// 7.4.3: how fast the mean height rises with x.
inline double slope(const Surface& surface, Quantity<unit::Length> x, Quantity<unit::Length> reach) {
    return todo(2);
}

/// 7.4.3: what a body and the surface do to each other.
inline Forces carry(const Surface& surface, const Body& body, const Contact& contact) {
    return todo(3);
}

} // namespace exercise
