// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: columns plus rows, where one may walk diagonally
// Why:     A diagonal step does a column and a row at once, for less than two. The sum is an overestimate, and the
//          path may be worse than the best.
// Read:    6.1.1, 6.3
// Fails:   exact-eight, never-more

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace exercise {

/// 6.3: the least that it costs to come dx columns and dy rows away, in steps to one of four neighbours for 1 each.
inline double four_neighbours(int dx, int dy) { return std::abs(dx) + std::abs(dy); }

/// The same in steps to one of eight neighbours: 1 across a side, the square root of 2 across a corner.
inline double eight_neighbours(int dx, int dy) { return std::abs(dx) + std::abs(dy); }

} // namespace exercise
