// SPDX-License-Identifier: BSL-1.0
// 6.3.9 Any angle: paths that go straight from corner to corner, found and not smoothed afterwards

// A grid's best path turns by 45 degrees, and of all those that cost the same the search takes any. To take the zigzag
// out of it afterwards (`smooth`) makes it as straight as its tiles allow, and no straighter: it stays on the side of a
// wall on which it was found. `LazyTheta` lets the parent of a node be any tile from which it can be seen, so that the
// search itself compares straight lines. In open country that is shorter; among many stones smoothing is, and neither
// always. `AnyAngle` does both and takes the shorter one. (A part of section 6.3, beyond the notes.)

#include "claims.hpp"
#include "columns.hpp"
#include "drawing.hpp"

#include <ansatz/paths.hpp>

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <random>
#include <utility>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    workbook::Claims claim;
    Grid<> map(32, 20);
    for (const auto& [x, y] : {std::pair(6, 0), std::pair(13, 7), std::pair(20, 1)})
        for (int k = 0; k < 12; ++k)
            for (int i = 0; i < 2; ++i) map.set_passable(Cell{std::uint16_t(x + i), std::uint16_t(y + k)}, false);
    const Cell start{1, 4}, goal{30, 9};

    //! [find]
    AnyAngle search{map};
    search.find(start, goal);
    for (const Cell corner : search.path()) std::cout << name_of(corner) << ' ';
    //! [find]
    std::cout << "\n" << std::fixed << std::setprecision(2);
    const double along = map.tiles(search.a_star().path()), smoothed = straight_tiles(search.smoothed());
    std::cout << "Along the tiles " << along << ", smoothed " << smoothed << ", by LazyTheta "
              << straight_tiles(search.theta().path()) << " tiles\n";
    claim("smoothing makes the path shorter", smoothed < along);
    claim("AnyAngle's is no longer than either", search.tiles() <= smoothed);

    // It may be used alone, and watched as any search.
    //! [alone]
    AStar theta{map, LazyTheta{}};
    theta.find(start, goal);
    //! [alone]
    std::cout << "LazyTheta expanded " << theta.expanded() << " nodes, A* " << search.a_star().expanded() << '\n';

    // How often is which the shorter? Maps of 48 x 48 tiles, a share of them blocked.
    bool both = true, never_longer = true, sees = true;
    int in_the_open = 0, among_stones = 0; // by how many paths more LazyTheta is the shorter
    std::cout << "How often each is the shorter, and what it saves of the way along the tiles\n";
    workbook::Columns table({"blocked", "paths", "LazyTheta's", "saves", "smoothed", "saves", "the shorter"});
    const auto percent = [](double left) { return workbook::printed(100 * (1 - left), " %"); };
    for (const int share : {5, 10, 20, 30}) {
        std::mt19937 random(5);
        int paths = 0, theta_shorter = 0, smooth_shorter = 0;
        double tiles = 0, by_smoothing = 0, by_theta = 0, shorter = 0;
        for (int i = 0; i < 300; ++i) {
            Grid<> moor(48, 48);
            for (int k = 0; k < 48 * 48 * share / 100; ++k)
                moor.set_passable(Cell{std::uint16_t(random() % 48), std::uint16_t(random() % 48)}, false);
            AnyAngle each{moor};
            const Cell from{std::uint16_t(random() % 48), std::uint16_t(random() % 48)};
            const Cell to{std::uint16_t(random() % 48), std::uint16_t(random() % 48)};
            if (each.find(from, to) != Outcome::found) continue;
            ++paths;
            const double a = straight_tiles(each.smoothed()), b = straight_tiles(each.theta().path());
            theta_shorter += b < a - 1e-9, smooth_shorter += a < b - 1e-9;
            tiles += moor.tiles(each.a_star().path()), by_smoothing += a, by_theta += b, shorter += each.tiles();
            never_longer = never_longer && each.tiles() <= std::min(a, b);
            for (std::size_t k = 1; k < each.path().size(); ++k)
                sees = sees && line_of_sight(moor, each.path()[k - 1], each.path()[k]);
        }
        table.row(workbook::printed(share, " %"), paths, theta_shorter, percent(by_theta / tiles), smooth_shorter,
                  percent(by_smoothing / tiles), percent(shorter / tiles));
        (share == 5 ? in_the_open : among_stones) = theta_shorter - smooth_shorter;
        both = both && theta_shorter > 0 && smooth_shorter > 0;
    }
    std::cout << table;
    claim("in the open LazyTheta is mostly the shorter, among stones smoothing is",
          in_the_open > 0 && among_stones < 0);
    claim("each is sometimes the shorter one", both);
    claim("AnyAngle's is never longer than either, and crosses no wall", never_longer && sees);

    workbook::Plot plot("6.3.9", "Three paths: along the tiles, smoothed, and of any angle");
    const auto tiles = drawing::places(map, search.a_star().path());
    const auto corners = drawing::places(map, search.smoothed());
    const auto straight = drawing::places(map, search.theta().path());
    drawing::with_walls(plot, map)
        .reference("along the tiles", tiles.east, tiles.north)
        .line("smoothed", corners.east, corners.north)
        .line("LazyTheta", straight.east, straight.north);
    drawing::with_ends(plot, map, start, goal).write();
    return claim.result();
}
