// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

using Point = VectorQuantity<unit::Length, 3>;

/// A bounding box, with its faces.
struct Box {
    Point lower, upper;
};

/// The eight children of a cube, by a number of three bits: bit 0 for x, bit 1 for y, bit 2 for z. A bit is 1 on the
/// upper side. Child 5 is 101: the upper side in x, the lower in y, the upper in z.
using Part = unsigned;

/// The child that a point is in, when a cube is divided at its centre. A plane belongs to the upper side.
inline Part part_of(const Point& point, const Point& centre) {
    return todo(1);
}

/// 2.1.1.3: all children that a box reaches into: bit p is 1 where it reaches into child p.
inline unsigned parts_of(const Box& box, const Point& centre) {
    return todo(2);
}

/// Whether a cell is divided that holds `count` bodies and is `depth` divisions deep already.
inline bool divide(int count, int threshold, int depth, int deepest) {
    return todo(3);
}

} // namespace exercise
