// SPDX-License-Identifier: BSL-1.0
// 2.1.1.2 World partitioning: many small n^2 in place of one large N^2, unless all bodies are in one place

// The world is divided into cells, and only what shares a cell is compared. The notes name what goes wrong with it: an
// entity on a boundary is in more than one partition, and where all are in the same one nothing is won. The first is
// about being right: sorting bodies by their centres and searching each cell alone loses every pair across a wall. The
// second is about time. (One of the four methods that the notes describe in 2.1.1 without numbers.)

#include "broadphase_scenes.hpp"
#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"
#include "strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

using namespace ansatz;
using scenes::Counting;
using scenes::Work;

namespace {

/// The wrong form: each body in the cell of its centre, and no search beyond the walls.
std::size_t pairs_inside_cells(const scenes::Balls& balls, double cell) {
    std::size_t pairs = 0;
    auto cell_of = [&](std::size_t i) {
        std::array<double, 3> of{};
        for (int k = 0; k < 3; ++k) of[std::size_t(k)] = std::floor(balls.centres[i][k] / cell);
        return of;
    };
    const auto boxes = balls.boxes();
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j) pairs += cell_of(i) == cell_of(j) && boxes.touch(i, j);
    return pairs;
}

/// A slice of a world: which pairs a search of each cell alone finds, and which it loses at the walls.
void draw_cells() {
    scenes::Dice dice(11);
    Boxes<Space<double, 2>> boxes;
    std::vector<scenes::Point> centres;
    for (int i = 0; i < 27; ++i) {
        const double x = dice.between(0.5, 9.5), y = dice.between(0.5, 5.5);
        centres.emplace_back(x, y);
        boxes.push_back(metres(x - 0.5, y - 0.5), metres(x + 0.5, y + 0.5));
    }
    boxes.set_active(boxes.size());
    scenes::Strokes walls, balls, found, lost;
    for (double at = 0; at <= 10; at += 2) walls.line({at, 0}, {at, 6});
    for (double at = 0; at <= 6; at += 2) walls.line({0, at}, {10, at});
    for (const auto& centre : centres) balls.circle(centre, 0.5);
    const auto cell = [](const scenes::Point& x) { return std::pair(std::floor(x[0] / 2), std::floor(x[1] / 2)); };
    for (const auto& [i, j] : find_pairs(UniformGrid{2.0 * metre}, boxes))
        (cell(centres[i]) == cell(centres[j]) ? found : lost).line(centres[i], centres[j]);
    workbook::Plot plot("2.1.1.2-cells",
                        "Cells of 2 m: the pairs across walls are lost to a search of each cell alone");
    plot.x("x", "m").y("y", "m").equal_axes();
    balls.draw(plot, "balls");
    lost.draw(plot, "pairs across a wall");
    found.draw(plot, "pairs within a cell");
    walls.draw(plot, "walls of the cells");
    plot.write();
}

} // namespace

int main() {
    workbook::Claims claim;

    // Bodies on boundaries.
    const auto balls = scenes::uniform(1000);
    //! [grid]
    const auto boxes = balls.boxes();
    const auto right = find_pairs(BoundingBoxes{}, boxes);
    const auto by_cells =
        find_pairs(UniformGrid{2.0 * metre}, boxes); // or UniformGrid{}, which chooses the width itself
    //! [grid]
    const std::size_t inside = pairs_inside_cells(balls, 2);
    workbook::say() << "1000 balls, cells of 2 m: " << right.size() << " pairs touch; searching each cell alone finds "
                    << inside << " of them\n";
    claim("without provision for boundaries more than half of the pairs are lost", 2 * inside < right.size());
    claim("the grid finds the very pairs that the box test finds", by_cells == right);
    bool same = true;
    for (const double cell : {0.1, 0.7, 1.0, 5.0, 80.0})
        same = same && find_pairs(UniformGrid{cell * metre}, boxes) == right;
    claim("whatever the width of its cells", same);

    // How many tests, as there are more and more bodies.
    std::vector<double> numbers, all, by_grid, crowded;
    workbook::Columns table({"N", "tests by boxes", "by cells", "by cells, all in one"});
    for (const int n : {50, 100, 200, 400, 800, 1600, 3200}) {
        Work work, one_place;
        //! [count]
        find_pairs(UniformGrid<Counting>{{}, scenes::counted(work)}, scenes::uniform(n).boxes());
        find_pairs(UniformGrid<Counting>{1000.0 * metre, scenes::counted(one_place)},
                   scenes::uniform(n).boxes()); // one cell holds them all
        //! [count]
        numbers.push_back(n);
        all.push_back(0.5 * n * (n - 1));
        by_grid.push_back(work.tests);
        crowded.push_back(one_place.tests);
        table.row(n, all.back(), work.tests, one_place.tests);
    }
    std::cout << table;
    const double growth = by_grid.back() / by_grid[by_grid.size() - 2];
    std::cout << "Twice as many bodies, " << growth << " times as many tests\n";
    claim("twice as many bodies are about twice as many tests, not four times", growth > 1.7 && growth < 2.4);
    claim("at 3200 bodies fewer than one test in 100 is left", by_grid.back() < all.back() / 100);
    // The origin is a corner: the eight cells around it hold all, and each two of them are neighbours.
    claim("where all share one place it saves nothing: N (N - 1) / 2 again", crowded.back() == all.back());

    draw_cells();
    workbook::Plot plot("2.1.1.2", "Cells make the tests grow with N, not with its square, if the bodies are spread");
    plot.x("bodies").y("box tests").log_x().log_y();
    plot.linked_points("every pair", numbers, all)
        .linked_points("by cells", numbers, by_grid)
        .points("by cells, all in one place", numbers, crowded);
    plot.reference("in proportion to N", numbers, [&](double n) { return by_grid.front() * n / numbers.front(); })
        .write();
    return claim.result();
}
