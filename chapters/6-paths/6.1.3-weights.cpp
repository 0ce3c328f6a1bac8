// SPDX-License-Identifier: BSL-1.0
// 6.1.3 Weights: mud, roads and speeds, and a path in metres and seconds

// "Edges can have weights adjusted to represent the cost of traversing them (e.g. to reflect difficulty in traversing a
// certain type of terrain)", say the notes. A weight is how many times longer its tile takes than an even one; the
// cheapest path is then the quickest, and not the shortest. Between way points a road has a length and a speed, and the
// two questions are two types: a search by length, in metres, and a search by time, in seconds. (A part of section 6.1,
// which the notes do not divide.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;

    // Tiles of two metres, a swamp of weight 4 between start and goal.
    //! [mud]
    const std::vector<std::string_view> rows{"..............", "....444444....", "....444444....",
                                             "....444444....", "....444444....", ".............."};
    const auto swamp = grid_from<Grid<Eight<>, Terrain>>(rows, 2.0 * metre);
    const Cell start{1, 3}, goal{12, 3};
    AStar quickest{swamp, Octile{}};
    quickest.find(start, goal);
    const auto speed = 1.5 * metre_per_second; // on ground of weight 1
    std::cout << "Around the swamp: " << swamp.length(quickest.path()) << " in "
              << swamp.travel_time(quickest.path(), speed) << '\n';
    //! [mud]
    std::vector<Cell> straight;
    for (std::uint16_t x = start.x; x <= goal.x; ++x) straight.push_back({x, 3});
    std::cout << "Through it:       " << swamp.length(straight) << " in " << swamp.travel_time(straight, speed) << '\n';
    auto drawn = drawing::map_of(swamp, [&](Cell c) {
        return c == start ? 'S' : c == goal ? 'G' : swamp.weight(c) > 1 ? '~' : '.';
    });
    drawing::print(drawing::with_path(drawn, quickest.path()));
    claim("the quickest path is not the shortest",
          swamp.length(quickest.path()) > swamp.length(straight) &&
              swamp.travel_time(quickest.path(), speed) < swamp.travel_time(straight, speed));

    //! [smooth]
    const std::vector<Cell> corners = smooth(swamp, quickest.path());
    //! [smooth]
    std::cout << "Its corners, from which one can walk straight on:\n ";
    for (const Cell c : corners) std::cout << ' ' << name_of(c);
    std::cout << "; " << straight_tiles(corners) * swamp.tile() << '\n';
    claim("smoothed it is shorter, and keeps out of the swamp", straight_tiles(corners) < swamp.tiles(quickest.path()));

    try {
        auto wrong = swamp;
        //! [refused]
        wrong.set_weight(Cell{3, 3}, -1.0);
        //! [refused]
        claim("a negative weight is refused", false);
    } catch (const std::invalid_argument& error) {
        workbook::say() << error.what() << '\n';
        claim("a negative weight is refused when it is set, not when a search meets it", true);
    }

    // Way points: a straight track and a motorway.
    //! [waypoints]
    Waypoints<ByLength> by_length;
    Waypoints<ByTime> by_time;
    const auto village = metres(0, 0, 0), ramp = metres(0, 4000, 0), exit = metres(9000, 4000, 0),
               town = metres(9000, 0, 0);
    for (const auto& place : {village, ramp, exit, town}) by_length.add(place), by_time.add(place);
    by_length.connect(0, 3), by_length.connect(0, 1), by_length.connect(1, 2), by_length.connect(2, 3);
    by_time.connect(0, 3, 10.0 * metre_per_second); // the track
    by_time.connect(0, 1, 20.0 * metre_per_second), by_time.connect(1, 2, 35.0 * metre_per_second),
        by_time.connect(2, 3, 20.0 * metre_per_second);

    AStar shortest{by_length}; // Euclid, from the coordinates
    AStar fastest{by_time};    // Euclid over the highest speed there is
    shortest.find(0, 3);
    fastest.find(0, 3);
    std::cout << "Shortest: " << by_length.length(shortest.path()) << "; quickest: " << by_time.length(fastest.path())
              << " in " << by_time.travel_time(fastest.path()) << '\n';
    //! [waypoints]
    claim("by length it takes the track, by time the motorway",
          shortest.path().size() == 2 && fastest.path().size() == 4);
    const auto expected = 8000.0 * metre / (20.0 * metre_per_second) + 9000.0 * metre / (35.0 * metre_per_second);
    claim("its time is that of the four and nine and four kilometres",
          abs(by_time.travel_time(fastest.path()) - expected) < 1e-9 * second);
    claim("straight line over highest speed never overestimates", !check_heuristic(by_time, Euclid{}, 3));

    workbook::Plot plot("6.1.3", "Around a swamp: the path on the tiles, and pulled straight");
    std::vector<Cell> mud;
    for (std::uint16_t y = 0; y < swamp.height(); ++y)
        for (std::uint16_t x = 0; x < swamp.width(); ++x)
            if (swamp.weight(Cell{x, y}) > 1) mud.push_back({x, y});
    const auto pulled = drawing::places(swamp, corners);
    drawing::fill(drawing::on_map(plot, swamp), swamp, "swamp, weight 4", mud);
    drawing::way(plot, swamp, "path", quickest.path());
    plot.reference("smoothed", pulled.east, pulled.north);
    drawing::with_ends(plot, swamp, quickest.path().front(), quickest.path().back()).write();
    return claim.result();
}
