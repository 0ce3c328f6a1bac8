// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/broadphase/cells.hpp>
#include <ansatz/world.hpp>

#include <cstdint>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
struct Cells {
    std::int64_t first, last;
};

inline std::int64_t cell_of(Length x, Length width) { return ansatz::detail::floor_of(x / width); }
/// The grid of the library writes a body down once, in its first cell, and searches for it in those around; an octree
/// writes it down in all.
inline Cells cells_of(Length low, Length high, Length width) { return {cell_of(low, width), cell_of(high, width)}; }
/// What the octree and the binary split do: the lower corner of what two boxes have in common.
inline std::int64_t told_in(Length low_a, Length, Length low_b, Length, Length width) {
    return cell_of(low_a < low_b ? low_b : low_a, width);
}

} // namespace exercise
