// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The map of 6.3.12, which chapter 6 is also timed on.

#include <ansatz/paths/grid/grid.hpp>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

/// A map of rooms of 12 x 12 tiles whose walls have a door of two tiles each, but for some that have none.
inline ansatz::paths::Grid<> rooms_with_doors(std::size_t side, std::mt19937& random) {
    ansatz::paths::Grid<> map(side, side);
    std::vector<std::uint8_t> free(map.size(), 1);
    const std::size_t room = 12;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            if (x % room == room - 1 || y % room == room - 1) free[y * side + x] = 0;
    for (std::size_t y = 0; y + room <= side; y += room)
        for (std::size_t x = 0; x + room <= side; x += room)
            for (const bool east : {true, false}) {
                if (random() % 5 == 0) continue;
                const std::size_t door = random() % (room - 3);
                for (std::size_t k = door; k < door + 2; ++k)
                    free[east ? (y + k) * side + x + room - 1 : (y + room - 1) * side + x + k] = 1;
            }
    map.set_passable(free);
    return map;
}
