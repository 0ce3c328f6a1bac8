// SPDX-License-Identifier: BSL-1.0
// 6.3.12 From gate to gate: long paths on large maps

// The time of a search grows with what it expands, and on a map of a quarter of a million tiles that is a lot. HPA*
// cuts the map into squares and keeps, for each, the ways between the gates through which one enters and leaves it. A
// search then goes from gate to gate, and what it finds is filled in from what is known. The path is not the best, but
// near it; and a change of the map concerns the squares that it lies in. (A part of section 6.3, beyond the notes.)

#include "claims.hpp"
#include "drawing.hpp"
#include "rooms.hpp"

#include <ansatz/paths.hpp>

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;
    std::mt19937 random(7);

    // From corner to corner of larger and larger maps.
    std::cout << "nodes expanded: A*, from gate to gate; how much longer that path is\n";
    bool near_it = true;
    double saved = 0;
    for (const std::size_t side : {96, 192, 384, 768}) {
        auto map = rooms_with_doors(side, random);
        //! [find]
        GateSearch search{map}; // once for a map
        const Cell start{2, 2}, goal{std::uint16_t(side - 8), std::uint16_t(side - 8)};
        const bool found = search.find(start, goal) == Outcome::found;
        //! [find]
        AStar tiles{map};
        if (!found || tiles.find(start, goal) != Outcome::found) {
            claim("there is a way across", false);
            continue;
        }
        const double longer = search.cost() / map.cost(tiles.path()) - 1;
        saved = double(tiles.expanded()) / double(search.expanded());
        near_it = near_it && longer < 0.05;
        std::cout << "  " << std::setw(3) << side << " x " << std::setw(3) << side << ": " << std::setw(6)
                  << tiles.expanded() << ", " << std::setw(5) << search.expanded() << "; " << std::fixed
                  << std::setprecision(1) << 100 * longer << " %\n"
                  << std::defaultfloat << std::setprecision(6);
        if (side == 96) {
            workbook::Plot plot("6.3.12", "From gate to gate, and then tile by tile");
            drawing::with_walls_and_path(plot, map, search.path()).write();
        }
        if (side != 384) continue;
        // Somebody shuts a door: the squares that it touches are made again.
        //! [change]
        const Cell door = *std::find_if(search.path().begin(), search.path().end(),
                                        [](Cell c) { return c.x % 12 == 11 && c.x > 190; });
        map.set_passable(door, false);
        search.find(start, goal);
        std::cout << "  a door shut: " << search.remade() << " of " << search.clusters().squares()
                  << " squares made again\n";
        //! [change]
        claim("a change is local", search.remade() <= 4);
        claim("and the search as it would be with all made again", [&] {
            GateSearch anew{map};
            anew.find(start, goal);
            return std::equal(anew.path().begin(), anew.path().end(), search.path().begin(), search.path().end());
        }());
    }
    claim("the paths are less than 5 % longer than the best", near_it);
    claim("on the largest map a tenth is expanded, or less", saved > 10);
    return claim.result();
}
