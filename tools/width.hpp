// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How wide a text is where it is read.

#include <cstddef>
#include <string_view>

namespace ansatz::workbook {

/// What every terminal has at least.
inline constexpr std::size_t terminal_width = 80;

/// How many characters a reader sees: the bytes of UTF-8 that do not continue a character.
inline std::size_t visible_width(std::string_view text) {
    std::size_t width = 0;
    for (char c : text) width += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    return width;
}

} // namespace ansatz::workbook
