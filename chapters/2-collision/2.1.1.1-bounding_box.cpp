// SPDX-License-Identifier: BSL-1.0
// 2.1.1.1 The bounding box test: a few comparisons in place of a complex check, and never a collision less

// A bounding box is "defined by the extremes of an entity in each axis". Two boxes touch when they do on every axis;
// where they are apart on one of them, nothing inside can touch. The other way round it does not hold: boxes touch at
// their corners, where balls are not. The notes promise the method for "low numbers of entities": each check has become
// cheap, but there are still N (N - 1) / 2 of them. (One of the four methods that the notes describe in 2.1.1 without
// numbers.)

#include "broadphase_scenes.hpp"
#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;

    //! [by hand]
    Boxes<Space<>> boxes;
    boxes.push_back(metres(0, 0, 0), metres(1, 1, 1));
    boxes.push_back(metres(0.9, 0.9, 0.9), metres(2, 2, 2)); // overlaps the first at a corner
    boxes.push_back(metres(2, 0, 1.5), metres(3, 1, 3));     // beside the second: they share a part of a face
    boxes.push_back(metres(0, 5, 0), metres(1, 6, 1));       // apart on one axis: that is enough
    boxes.set_active(boxes.size());                          // all four may move
    for (const auto& [i, j] : find_pairs(BoundingBoxes{}, boxes))
        std::cout << "boxes " << i << " and " << j << " touch\n";
    //! [by hand]
    claim("one overlap and one shared face; boxes are closed", find_pairs(BoundingBoxes{}, boxes).size() == 2);

    std::vector<double> numbers, all, by_boxes, truly;
    double checks_of_boxes = 0, collisions = 0;
    bool none_lost = true;
    workbook::Columns table({"balls", "pairs", "whose boxes touch", "that touch"});
    for (const int n : {25, 50, 100, 200, 400, 800, 1600}) {
        //! [two steps]
        const auto balls = scenes::uniform(n);
        const auto pairs = find_pairs(BoundingBoxes{}, balls.boxes()); // the cheap test for all
        std::size_t touching = 0;
        for (const auto& [i, j] : pairs) touching += balls.touch(i, j); // the complex one for those that are left
        //! [two steps]
        std::size_t right = 0;
        for (std::size_t i = 0; i < balls.centres.size(); ++i)
            for (std::size_t j = i + 1; j < balls.centres.size(); ++j) right += balls.touch(i, j);
        none_lost = none_lost && right == touching;
        numbers.push_back(n);
        all.push_back(double(find_pairs(AllPairs{}, balls.boxes()).size()));
        by_boxes.push_back(double(pairs.size()));
        truly.push_back(double(right));
        checks_of_boxes += double(pairs.size()), collisions += double(right);
        table.row(n, all.back(), pairs.size(), right);
    }
    std::cout << table;
    claim("no collision is lost", none_lost);
    claim("at 1600 balls fewer than one check in 500 is left", by_boxes.back() < all.back() / 500);
    claim("but the box tests are N (N - 1) / 2, as the checks were", all.back() == 1600.0 * 1599 / 2);

    // How many boxes touch without their balls: a cube of side 4r around a centre, against a ball of radius 2r in it.
    const double expected = 64 / (4.0 / 3 * M_PI * 8);
    workbook::say() << "Of boxes that touch there are " << checks_of_boxes / collisions
                    << " for each collision; the volumes say " << expected << '\n';
    claim("that is 6/pi, the volume of a cube by that of its ball",
          std::abs(checks_of_boxes / collisions / expected - 1) < 0.1);

    workbook::Plot plot("2.1.1.1", "The box test leaves few checks, but is itself made for every pair");
    plot.x("balls").y("pairs").log_x().log_y();
    plot.linked_points("box tests", numbers, all)
        .linked_points("boxes that touch", numbers, by_boxes)
        .linked_points("collisions", numbers, truly)
        .write();
    return claim.result();
}
