// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Shapes as plainly as they can be written, to hold the library's contacts against.

#include "tests/fuzz/operation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz {

inline double norm(const Numbers& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

struct Body {
    Shape shape;
    int axis;
    double size; // m: a radius, half a width, or how far a plane is above its place
    Numbers place;
};
/// How deep two bodies are in each other, m; negative where they are apart. Two planes, and what has no shape, never
/// are.
inline double depth_of(const Body& a, const Body& b, int dimension) {
    constexpr double never = -std::numeric_limits<double>::infinity();
    if (a.shape == Shape::none || b.shape == Shape::none) return never;
    if (a.shape == Shape::plane && b.shape == Shape::plane) return never;
    // Both reach as far along an axis: a ball's radius, half a box.
    if (a.shape == Shape::plane) return b.size - (b.place[std::size_t(a.axis)] - a.place[std::size_t(a.axis)] - a.size);
    if (b.shape == Shape::plane) return depth_of(b, a, dimension);
    if (a.shape == Shape::box && b.shape == Shape::sphere) return depth_of(b, a, dimension);
    double between = 0, least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < dimension; ++k) {
        const double apart = std::abs(a.place[std::size_t(k)] - b.place[std::size_t(k)]);
        if (a.shape == Shape::sphere) {
            const double beyond = b.shape == Shape::box ? std::max(apart - b.size, 0.0) : apart;
            between += beyond * beyond;
        } else {
            least = std::min(least, a.size + b.size - apart);
        }
    }
    if (a.shape == Shape::box) return least;
    return a.size + (b.shape == Shape::sphere ? b.size : 0) - std::sqrt(between);
}

} // namespace fuzz
