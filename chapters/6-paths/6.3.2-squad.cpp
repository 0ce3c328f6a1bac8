// SPDX-License-Identifier: BSL-1.0
// 6.3.2 A squad: one search for the whole group, and each member at its offset from the leader

// For "groups of objects that move in an identical path together (e.g. squads in an RTS) only one instance of the path
// finding must be performed for the entire group", say the notes, and the others' places are "computed using positions
// relative to the centre, leader, etc." That is one search in place of five. What it does not know is the others'
// ground: where a member's place is a wall, or behind one, it must be told, and here closes up to the leader. (A part
// of section 6.3.)

#include "claims.hpp"
#include "drawing.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/formation.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;

    const auto map = grid_from<Grid<>>({"..........#.........", "..........#.........", "....................",
                                        "..........#.........", "..........#.........", "..........#........."});
    //! [squad]
    AStar search{map, Octile{}};
    const Cell start{2, 3}, goal{17, 2};
    search.find(start, goal); // for all five

    const Formation squad{{{0, 0}, {-1, -1}, {-1, 1}, {-2, 0}, {0, 2}}}; // the leader first
    std::vector<Slot> slots;
    for (const Cell leader : search.path()) {
        squad.at(map, leader, slots); // where everybody belongs
        //! [squad]
        if (leader.x != 3 && leader.x != 10 && leader.x != 16) continue;
        auto rows = drawing::map_of(map, [](Cell) { return '.'; });
        std::size_t told = 0;
        for (std::size_t i = slots.size(); i-- > 0;)
            rows[slots[i].cell.y][slots[i].cell.x] = char('1' + slots[i].member);
        for (const Slot& slot : slots) told += slot.blocked;
        std::cout << "The leader (1) is at " << name_of(leader) << "; " << told << " of 5 have no place of their own\n";
        drawing::print(rows);
    }
    bool own_places_are_free = true, leader_always = true;
    std::size_t closest = 0;
    for (const Cell leader : search.path()) {
        squad.at(map, leader, slots);
        std::size_t told = 0;
        for (const Slot& slot : slots) {
            own_places_are_free = own_places_are_free && map.passable(slot.cell);
            if (slot.blocked) ++told, leader_always = leader_always && slot.cell == leader;
        }
        closest = std::max(closest, told);
    }
    claim("nobody is ever put into a wall", own_places_are_free);
    claim("whose place is blocked is told, and closes up to the leader", leader_always && closest >= 2);

    const std::size_t once = search.expanded();
    std::size_t each = 0;
    for (const Offset o : squad.offsets()) {
        const Cell from{std::uint16_t(start.x + o.x), std::uint16_t(start.y + o.y)},
            to{std::uint16_t(goal.x + o.x), std::uint16_t(goal.y + o.y)};
        search.find(from, to);
        each += search.expanded();
    }
    std::cout << "One search for all: " << once << " nodes expanded; one for each of the five: " << each << '\n';
    claim("the search of one does for all", once < each);
    search.find(start, goal);

    workbook::Plot plot("6.3.2", "One path, five walkers");
    drawing::with_walls(plot, map);
    for (std::size_t member = 0; member < squad.size(); ++member) {
        std::vector<Cell> way;
        for (const Cell leader : search.path()) way.push_back(squad.at(map, leader)[member].cell);
        const auto track = drawing::places(map, way);
        if (member == 0) plot.reference("the leader", track.east, track.north);
        else plot.line("member " + std::to_string(member + 1), track.east, track.north);
    }
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
