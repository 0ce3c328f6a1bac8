// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;

/// Cells on an axis, from the first to the last; both belong to it.
struct Cells {
    std::int64_t first, last;
};

/// The number of the cell in which a coordinate is. Cell 0 begins at the origin, cell 1 one width further, cell -1 one
/// width before; a wall belongs to the cell that begins there.
inline std::int64_t cell_of(Length x, Length width) {
    return todo(1);
}

/// 2.1.1.2: all cells of an axis that a body reaches into, from its lower end to its upper one, ends included.
inline Cells cells_of(Length low, Length high, Length width) {
    return todo(2);
}

/// Two bodies that overlap may be in several cells together. In which of those is the pair told, so that it is told
/// once?
inline std::int64_t told_in(Length low_a, Length high_a, Length low_b, Length high_b, Length width) {
    return todo(3);
}

} // namespace exercise
