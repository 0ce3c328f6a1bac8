// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/broadphase/bounding_boxes.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
struct Box {
    ansatz::VectorQuantity<ansatz::unit::Length, 3> lower, upper;
};
using Pair = ansatz::IndexPair;

/// The library keeps all boxes in lanes, one for each axis, so that many are tested in a row.
inline ansatz::Boxes<ansatz::Space<>> in_lanes(const std::vector<Box>& boxes) {
    ansatz::Boxes<ansatz::Space<>> lanes;
    for (const Box& box : boxes) lanes.push_back(box.lower, box.upper);
    lanes.set_active(lanes.size());
    return lanes;
}
inline bool touch(const Box& a, const Box& b) { return in_lanes({a, b}).touch(0, 1); }
/// It has no word for one axis; two boxes that differ on one alone tell the same.
inline bool overlap(Length low_a, Length high_a, Length low_b, Length high_b) {
    auto along = [](Length low, Length high) {
        return Box{ansatz::metres(low.value(), 0, 0), ansatz::metres(high.value(), 0, 0)};
    };
    return touch(along(low_a, high_a), along(low_b, high_b));
}
inline std::vector<Pair> touching_pairs(const std::vector<Box>& boxes) {
    return find_pairs(ansatz::BoundingBoxes{}, in_lanes(boxes));
}

} // namespace exercise
