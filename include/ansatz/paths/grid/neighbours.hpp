// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Which tiles of a grid are neighbours: `Four`, or `Eight` with a rule for corners.
///
/// | corner rule  | a diagonal step is possible where                          | for                                       |
/// |--------------|------------------------------------------------------------|-------------------------------------------|
/// | `BothFree`   | both tiles beside it are free (the default; MovingAI's)    | bodies as wide as a tile                  |
/// | `OneFree`    | one of them is                                             | bodies that may brush a corner            |
/// | `NoneFree`   | always                                                     | points, that pass between touching walls  |

#include <ansatz/core/compiler_flags.hpp>

namespace ansatz::paths {

/// Only between two free tiles: for bodies as wide as a tile.
struct BothFree {
    static constexpr bool passes(bool a, bool b) { return a && b; } ///< between tiles that are free, or not
};
/// Past a free tile at least: for bodies that may brush a corner.
struct OneFree {
    static constexpr bool passes(bool a, bool b) { return a || b; } ///< between tiles that are free, or not
};
/// Always: for points, that pass between touching walls.
struct NoneFree {
    static constexpr bool passes(bool, bool) { return true; } ///< between tiles that are free, or not
};

/// East, south, west and north.
struct Four {
    static constexpr int directions = 4; ///< how many neighbours
    /// Whether it steps between two tiles that are free, or not: never.
    static constexpr bool diagonal(bool, bool) { return false; }
};
/// Those and the four between.
template <class Corners = BothFree> struct Eight {
    static constexpr int directions = 8; ///< how many neighbours
    /// Whether it steps between two tiles that are free, or not.
    static constexpr bool diagonal(bool a, bool b) { return Corners::passes(a, b); }
};

} // namespace ansatz::paths
