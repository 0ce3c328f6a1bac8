// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How far places of a map are from its walls, by testing all of them.

#include <ansatz/paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace paths_tests {

using namespace ansatz;
using namespace ansatz::paths;

/// How far a place is from all blocked tiles, and from what lies beyond the map; in tiles, up to 4.
template <class Map> double clearance(const Map& map, double x, double y) {
    double least = 4;
    for (int i = int(std::floor(x)) - 4; i <= int(std::floor(x)) + 4; ++i)
        for (int k = int(std::floor(y)) - 4; k <= int(std::floor(y)) + 4; ++k) {
            const bool free = i >= 0 && k >= 0 && i < int(map.width()) && k < int(map.height()) &&
                              map.passable(Cell{std::uint16_t(i), std::uint16_t(k)});
            if (!free)
                least =
                    std::min(least, std::hypot(std::max({i - x, 0.0, x - i - 1}), std::max({k - y, 0.0, y - k - 1})));
        }
    return least;
}

} // namespace paths_tests
