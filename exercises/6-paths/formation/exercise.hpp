// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace exercise {

/// A tile: column and row.
struct Tile {
    int x = 0, y = 0;
    bool operator==(const Tile&) const = default;
};
/// Columns to the right and rows down, from the leader or the centre.
struct Offset {
    int x = 0, y = 0;
    bool operator==(const Offset&) const = default;
};
/// Rows of '.' and '#'. Outside of them is nothing, no wall either.
struct Map {
    std::vector<std::string> rows;

    bool contains(Tile t) const { return t.x >= 0 && t.y >= 0 && t.y < int(rows.size()) && t.x < int(rows[0].size()); }
    bool wall(Tile t) const { return contains(t) && rows[std::size_t(t.y)][std::size_t(t.x)] == '#'; }
};
/// Whether no wall is on the straight way from one tile to another; none is at the other one, either. A line through
/// the corner of four tiles touches all four. It asks for walls and not for the edge of the map.
inline bool line_of_sight(const Map& map, Tile from, Tile to) {
    const int dx = std::abs(to.x - from.x), dy = std::abs(to.y - from.y);
    for (int columns = 0, rows = 0; columns < dx || rows < dy;) {
        const int column_line = (2 * columns + 1) * dy, row_line = (2 * rows + 1) * dx; // the lesser one comes next
        const Tile before = from;
        if (column_line <= row_line) from.x += to.x > from.x ? 1 : -1, ++columns;
        if (row_line <= column_line) from.y += to.y > from.y ? 1 : -1, ++rows;
        if (map.wall(from) || map.wall({from.x, before.y}) || map.wall({before.x, from.y})) return false;
    }
    return true;
}

/// Where a group is, and where each of its members stands in it.
struct Formation {
    Tile centre;
    std::vector<Offset> offsets; ///< one for each member, in their order
};
/// 6.3.2: the formation of members who stand somewhere. Its centre is the tile that is nearest to the mean of their
/// places; half a tile counts to the right, and down. There is one member at least, and no column or row is negative.
inline Formation around_centre(const std::vector<Tile>& members) {
    return todo(1);
}

/// Where a member should be.
struct Slot {
    Tile tile;
    bool blocked = false; ///< its own place is a wall, off the map, or behind a wall
    bool operator==(const Slot&) const = default;
};
/// Where everybody belongs while the leader, or the centre, is at a tile of the map that is no wall: each at its
/// offset; and whose place is blocked closes up, to the leader's tile. One for each member, in their order.
inline std::vector<Slot> slots_at(const Map& map, Tile leader, const std::vector<Offset>& offsets) {
    return todo(2);
}

/// The most tiles that each member must go while the leader goes one. `slots[k]` is where everybody is, in their order,
/// when the leader has gone k tiles; it may have gone none. A tile has eight neighbours, and walls are not tested.
inline std::vector<int> catch_up_speeds(const std::vector<std::vector<Slot>>& slots) {
    return todo(3);
}

} // namespace exercise
