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
    // task 1: return todo(1);
    Part part = 0;
    for (int k = 0; k < 3; ++k)
        if (component(point, k) >= component(centre, k)) part |= 1u << k;
    return part;
    // end of task 1
}

/// 2.1.1.3: all children that a box reaches into: bit p is 1 where it reaches into child p.
inline unsigned parts_of(const Box& box, const Point& centre) {
    // task 2: return todo(2);
    unsigned parts = 0;
    for (Part part = 0; part < 8; ++part) {
        bool reaches = true;
        for (int k = 0; k < 3; ++k) {
            const bool upper = (part >> k) & 1u;
            reaches = reaches && (upper ? component(box.upper, k) >= component(centre, k)
                                        : component(box.lower, k) < component(centre, k));
        }
        if (reaches) parts |= 1u << part;
    }
    return parts;
    // end of task 2
}

/// Whether a cell is divided that holds `count` bodies and is `depth` divisions deep already.
inline bool divide(int count, int threshold, int depth, int deepest) {
    // task 3: return todo(3);
    return count > threshold && depth < deepest;
    // end of task 3
}

} // namespace exercise
