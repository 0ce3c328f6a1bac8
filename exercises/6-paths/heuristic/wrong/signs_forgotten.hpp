// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the signs forgotten
// Why:     To the left and upwards the differences are negative, and so is the estimate. The path is still the
//          best, for a negative number is an underestimate; the search is not.
// Read:    6.3
// Fails:   sides-four, sides-eight

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace exercise {

/// 6.3: the least that it costs to come dx columns and dy rows away, in steps to one of four neighbours for 1 each.
inline double four_neighbours(int dx, int dy) { return dx + dy; }

/// The same in steps to one of eight neighbours: 1 across a side, the square root of 2 across a corner.
inline double eight_neighbours(int dx, int dy) {
    const int less = std::min(dx, dy), more = std::max(dx, dy);
    return std::sqrt(2.0) * less + (more - less);
}

} // namespace exercise
