// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Cell`: a tile of a grid, by column and row; the vertex of `Grid`. Its eight directions, and a step along one.

#include <ansatz/core/compiler_flags.hpp>

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace ansatz::paths {

/// A tile: column x from the left, row y from the top, both from 0.
struct alignas(4) Cell { // aligned, so that it is moved in one piece
    /// The column.
    std::uint16_t x = 0, y = 0; ///< the row
    friend constexpr bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
    /// Row by row.
    friend constexpr auto operator<=>(Cell a, Cell b) { // row by row, as they lie in memory
        return a.y != b.y ? a.y <=> b.y : a.x <=> b.x;
    }
};
/// "(3, 4)".
[[gnu::cold]] inline std::string name_of(Cell c) {
    return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
}

namespace detail {

/// Directions 0 to 3 are east, south, west and north (rows grow to the south), 4 to 7 lie between: 4 is south-east.
inline constexpr int direction_x[8] = {1, 0, -1, 0, 1, -1, -1, 1};
inline constexpr int direction_y[8] = {0, 1, 0, -1, 1, 1, -1, -1};

/// A step as one addition on both coordinates at once. It holds only between tiles of one grid: no edge leads out of
/// it.
inline constexpr std::uint32_t one_x = std::bit_cast<std::uint32_t>(Cell{1, 0});
inline constexpr std::uint32_t one_y = std::bit_cast<std::uint32_t>(Cell{0, 1});
/// Columns and rows out of the one word that a Cell is. (Asked for its members, g++ goes through a vector register.)
[[gnu::always_inline]] constexpr std::uint32_t column(Cell c) {
    const auto word = std::bit_cast<std::uint32_t>(c);
    return std::endian::native == std::endian::little ? word & 0xffff : word >> 16;
}
[[gnu::always_inline]] constexpr std::uint32_t row(Cell c) {
    const auto word = std::bit_cast<std::uint32_t>(c);
    return std::endian::native == std::endian::little ? word >> 16 : word & 0xffff;
}
struct Offsets {
    std::uint32_t of[8]{};
    constexpr Offsets() {
        for (int d = 0; d < 8; ++d)
            of[d] = std::uint32_t(direction_x[d]) * one_x + std::uint32_t(direction_y[d]) * one_y;
    }
};
inline constexpr Offsets offsets{};
[[gnu::always_inline]] constexpr Cell step(Cell from, unsigned direction) {
    return std::bit_cast<Cell>(std::bit_cast<std::uint32_t>(from) + offsets.of[direction]);
}

} // namespace detail
} // namespace ansatz::paths

template <> struct std::hash<ansatz::paths::Cell> {
    std::size_t operator()(ansatz::paths::Cell c) const noexcept { return std::bit_cast<std::uint32_t>(c); }
};
