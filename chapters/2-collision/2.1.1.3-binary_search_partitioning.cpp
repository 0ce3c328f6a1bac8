// SPDX-License-Identifier: BSL-1.0
// 2.1.1.3 Binary search partitioning: cells are divided where bodies are, and the threshold can be wrong at both ends

// Cells of one width do not suit a world of heaps and empty space. Divide a cell only while it holds more bodies than a
// threshold, and the cells are small where it is crowded. An octree halves the cell on each axis; a binary split halves
// the bodies, along the longest axis. Of the threshold the notes say: too high and there is no benefit, too low and the
// sorting takes over. Both ends can be counted: the tests inside the cells, and the bodies that were handed to a cell.
// (One of the four methods that the notes describe in 2.1.1 without numbers.)

#include "broadphase_scenes.hpp"
#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "strokes.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

using namespace ansatz;
using scenes::Counting;
using scenes::Work;

namespace {

/// A square with the boxes that reach into it, divided while it holds more than `threshold`, as Octree does in two
/// dimensions.
struct Quadtree {
    const Boxes<Space<double, 2>>& boxes;
    std::size_t threshold;
    scenes::Strokes walls;
    std::size_t members = 0; ///< bodies in the lists of cells, all lists together

    void divide(const scenes::Point& low, double side, const std::vector<std::size_t>& inside) {
        if (inside.size() <= threshold) {
            members += inside.size();
            walls.box(low, low + scenes::Point(side, side));
            return;
        }
        for (const double right : {0.0, 0.5})
            for (const double up : {0.0, 0.5}) {
                const scenes::Point corner = low + side * scenes::Point(right, up);
                std::vector<std::size_t> part;
                for (const std::size_t i : inside) {
                    bool reaches = true;
                    for (int k = 0; k < 2; ++k)
                        reaches =
                            reaches && boxes.lower(k)[i] <= corner[k] + side / 2 && corner[k] <= boxes.upper(k)[i];
                    if (reaches) part.push_back(i);
                }
                divide(corner, side / 2, part);
            }
    }
};

/// Two crowds and a few bodies that stand alone.
void draw_cells() {
    scenes::Dice dice(8);
    Boxes<Space<double, 2>> boxes;
    std::vector<std::size_t> all;
    scenes::Strokes balls;
    for (int i = 0; i < 110; ++i) {
        const double spread = i < 60 ? 9 : i < 100 ? 12 : 44;
        const double middle_x = i < 60 ? 17 : i < 100 ? 74 : 50, middle_y = i < 60 ? 26 : i < 100 ? 66 : 50;
        const double x = middle_x + dice.between(-spread, spread), y = middle_y + dice.between(-spread, spread);
        boxes.push_back(metres(x - 1, y - 1), metres(x + 1, y + 1));
        balls.circle({x, y}, 1, 24);
        all.push_back(std::size_t(i));
    }
    Quadtree tree{boxes, 8, {}};
    tree.divide({0, 0}, 100, all);
    workbook::Plot plot("2.1.1.3-cells", "A quadtree: a square with more than 8 bodies is divided into four");
    plot.x("x", "m").y("y", "m").equal_axes();
    tree.walls.draw(plot, "squares");
    balls.draw(plot, "bodies");
    plot.write();
}

} // namespace

int main() {
    workbook::Claims claim;
    const int n = 2000;
    const auto boxes = scenes::heaps(n).boxes();
    const auto right = find_pairs(BoundingBoxes{}, boxes);

    //! [octree]
    const auto by_cubes = find_pairs(Octree{}, boxes);
    const auto by_halves = find_pairs(BinarySplit{}, boxes);
    //! [octree]
    std::cout << n << " balls in heaps: " << right.size() << " pairs touch\n";
    claim("the octree and the binary split find the very pairs that the box test finds",
          by_cubes == right && by_halves == right);

    // As many equal cells as the world has room for, against cells where they are needed.
    Work cells, cubes;
    find_pairs(UniformGrid<Counting>{25.0 * metre, scenes::counted(cells)}, boxes); // 8 x 8 x 8 cells for 200 m
    //! [count]
    find_pairs(Octree<Counting>{.threshold = 16, .depth = 16, .inside = scenes::counted(cubes)}, boxes);
    //! [count]
    std::cout << "Cells of 25 m make " << cells.tests << " tests, an octree " << cubes.tests << '\n';
    claim("an uneven world takes less than a third of the tests of equal cells", cubes.tests < cells.tests / 3);

    // The threshold, from one body a cell to all in one.
    std::vector<double> thresholds, tests, members, sum;
    workbook::Columns table({"threshold", "tests a body", "cells a body is in"});
    for (int threshold = 1; threshold <= 4096; threshold *= 2) {
        Work work;
        //! [threshold]
        find_pairs(Octree<Counting>{.threshold = threshold, .depth = 16, .inside = scenes::counted(work)}, boxes);
        //! [threshold]
        thresholds.push_back(threshold);
        tests.push_back(work.tests / n);
        members.push_back(work.members / n);
        table.row(threshold, tests.back(), members.back());
    }
    std::cout << table;
    claim("too high, and there is no benefit: (N - 1) / 2 tests a body",
          tests.back() == 0.5 * (n - 1) && members.back() == 1);
    // It would be worse still, if the octree did not refuse a division that hands on twice as many bodies as there are.
    claim("too low, and bodies are sorted into several cells each, for hardly fewer tests",
          members.front() > 1.4 * members[5] && tests.front() > 0.8 * tests[5]);
    claim("from 16 to 64 the tests grow by less than half, and the cells of a body fall to about half",
          tests[6] < 1.5 * tests[4] && members[6] < 0.55 * members[4]);

    draw_cells();
    workbook::Plot plot("2.1.1.3", "The threshold of an octree: too low is sorting, too high is testing");
    plot.x("threshold").y("for each body").log_x().log_y();
    plot.linked_points("tests", thresholds, tests)
        .linked_points("cells that it is sorted into", thresholds, members)
        .write();
    return claim.result();
}
