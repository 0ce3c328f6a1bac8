// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the straight distance
// Why:     It is never too much, so the path is right. But nobody walks along it on tiles, and A* looks at more
//          nodes than it needs.
// Read:    6.3
// Fails:   exact-four, exact-eight

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace exercise {

/// 6.3: the least that it costs to come dx columns and dy rows away, in steps to one of four neighbours for 1 each.
inline double four_neighbours(int dx, int dy) { return std::hypot(dx, dy); }

/// The same in steps to one of eight neighbours: 1 across a side, the square root of 2 across a corner.
inline double eight_neighbours(int dx, int dy) { return std::hypot(dx, dy); }

} // namespace exercise
