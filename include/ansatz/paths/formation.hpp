// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Formation`: one search for a whole group (notes 6.3). The path is found once, for the leader or the centre; where
/// each member stands follows from its offset. A member whose place is blocked, or cannot be reached in a straight line
/// from the leader, is told so: it may wait, close up to the leader, or search for itself.

#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/units.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// Where a member stands, in columns and rows from the leader or the centre.
struct Offset {
    /// Columns to the right.
    int x = 0, y = 0; ///< rows down
    friend bool operator==(Offset a, Offset b) { return a.x == b.x && a.y == b.y; }
};

/// Where a member should be.
struct Slot {
    std::size_t member = 0; ///< by its place among the offsets
    Cell cell;              ///< the leader's own where this member's is blocked
    bool blocked = false;   ///< its own place is a wall, outside, or behind a wall
};

/// A group by its offsets.
class Formation {
public:
    /// One member for each offset.
    explicit Formation(std::vector<Offset> offsets) : offsets_(std::move(offsets)) {}
    /// Of members at given places, around the centre of them all.
    /// \return the formation, and the tile of the centre
    static std::pair<Formation, Cell> around_centre(const std::vector<Cell>& members) {
        if (members.empty()) refuse_value("Formation", "the number of members", "0", "there must be one at least");
        std::size_t x = 0, y = 0;
        for (const Cell c : members) x += c.x, y += c.y;
        const std::size_t n = members.size();
        const Cell centre{std::uint16_t((x + n / 2) / n), std::uint16_t((y + n / 2) / n)};
        return {around(centre, members), centre};
    }
    /// Of members at given places, relative to a leader.
    static Formation around(Cell leader, const std::vector<Cell>& members) {
        std::vector<Offset> offsets;
        offsets.reserve(members.size());
        for (const Cell c : members) offsets.push_back({int(c.x) - leader.x, int(c.y) - leader.y});
        return Formation(std::move(offsets));
    }
    std::size_t size() const { return offsets_.size(); } ///< how many members
    /// Where each member stands.
    const std::vector<Offset>& offsets() const { return offsets_; }

    /// Where each member belongs while the leader, or the centre, is at this tile.
    /// \param slots one for each member, in their order; its memory is used again
    template <class Map> void at(const Map& map, Cell leader, std::vector<Slot>& slots) const {
        slots.clear();
        for (std::size_t i = 0; i < offsets_.size(); ++i) {
            const int x = int(leader.x) + offsets_[i].x, y = int(leader.y) + offsets_[i].y;
            Slot slot{i, leader, true};
            if (x >= 0 && y >= 0 && x < int(map.width()) && y < int(map.height())) {
                const Cell own{std::uint16_t(x), std::uint16_t(y)};
                if (map.passable(own) && line_of_sight(map, leader, own)) slot.cell = own, slot.blocked = false;
            }
            slots.push_back(slot);
        }
    }
    /// The same in memory of its own.
    template <class Map> std::vector<Slot> at(const Map& map, Cell leader) const {
        std::vector<Slot> slots;
        at(map, leader, slots);
        return slots;
    }

private:
    std::vector<Offset> offsets_;
};

} // namespace ansatz::paths
