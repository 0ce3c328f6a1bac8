// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/world.hpp>

#include <bit>

namespace exercise {

using Point = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
struct Box {
    Point lower, upper;
};
using Part = unsigned;

/// The library's recursion divides at any planes; an octree takes those of the centre.
inline unsigned parts_of(const Box& box, const Point& centre) {
    using S = ansatz::Space<>;
    ansatz::Boxes<S> boxes;
    boxes.push_back(box.lower, box.upper);
    const ansatz::detail::Division<S> at{7u, {centre.value()[0], centre.value()[1], centre.value()[2]}};
    return ansatz::detail::Recursion<S, ansatz::BoundingBoxes>::sides_of(boxes, 0, at);
}
/// A point is a box of no size, which is in one part.
inline Part part_of(const Point& point, const Point& centre) {
    return Part(std::countr_zero(parts_of({point, point}, centre)));
}
/// In the library the depth counts down to 0.
inline bool divide(int count, int threshold, int depth, int deepest) {
    return count > threshold && deepest - depth > 0;
}

} // namespace exercise
