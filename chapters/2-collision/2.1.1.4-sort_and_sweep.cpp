// SPDX-License-Identifier: BSL-1.0
// 2.1.1.4 Sort and sweep: on one axis only neighbours in the order can meet, and the order hardly changes

// All boxes are projected onto one axis and sorted by where they begin. From each the pass goes on to where it
// ends; what begins later cannot touch it. Which axis matters: the one along which the bodies are spread. The notes
// recommend it "in conjunction with any other method", inside the cells of a partition. What makes it cheap in a
// simulation they do not say: from one step to the next few bodies overtake each other, and an order that is nearly
// right is repaired by insertion. (One of the four methods that the notes describe in 2.1.1 without numbers.)

#include "broadphase_scenes.hpp"
#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"
#include "strokes.hpp"

#include <algorithm>
#include <iostream>
#include <numeric>
#include <vector>

using namespace ansatz;

namespace {

/// How many pairs overlap on one axis: what is left when one pass along it has culled the others.
std::size_t left_by_sweep(const Boxes<Space<>>& boxes, int axis) {
    //! [sweep]
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const double *low = boxes.lower(axis), *high = boxes.upper(axis);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low[a] < low[b]; });
    std::size_t left = 0;
    for (std::size_t p = 0; p < order.size(); ++p)
        for (std::size_t q = p + 1; q < order.size() && low[order[q]] <= high[order[p]]; ++q)
            ++left; // a pair to be tested further
    //! [sweep]
    return left;
}
/// How many places bodies are moved by an insertion sort that begins with the old order.
double moves_of_insertion(std::vector<double>& kept) {
    double moves = 0;
    //! [insertion]
    for (std::size_t p = 1; p < kept.size(); ++p)
        for (std::size_t q = p; q > 0 && kept[q] < kept[q - 1]; --q, ++moves) std::swap(kept[q], kept[q - 1]);
    //! [insertion]
    return moves;
}

/// Boxes above, and below them their intervals in the order of their beginnings.
void draw_intervals() {
    scenes::Dice dice(21);
    std::vector<scenes::Point> low, high;
    for (int i = 0; i < 9; ++i) {
        const double x = dice.between(0, 9), y = dice.between(0.3, 2.2), width = dice.between(0.8, 1.6);
        low.emplace_back(x, y);
        high.emplace_back(x + width, y + 0.8);
    }
    std::vector<std::size_t> order(low.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low[a][0] < low[b][0]; });
    scenes::Strokes boxes, intervals, overlaps;
    for (std::size_t p = 0; p < order.size(); ++p) {
        const std::size_t a = order[p];
        const auto row = [](std::size_t place) { return -0.4 - 0.3 * double(place); };
        boxes.box(low[a], high[a]);
        intervals.line({low[a][0], row(p)}, {high[a][0], row(p)});
        // Each that begins before this one ends: from its row down to theirs, where they begin.
        for (std::size_t q = p + 1; q < order.size() && low[order[q]][0] <= high[a][0]; ++q)
            overlaps.line({low[order[q]][0], row(p)}, {low[order[q]][0], row(q)});
    }
    workbook::Plot plot("2.1.1.4-intervals", "Sweep: from each interval down to those that begin before it ends");
    plot.x("x", "m").y("", "").equal_axes();
    boxes.draw(plot, "boxes");
    intervals.draw(plot, "their intervals, sorted");
    overlaps.draw(plot, "pairs that overlap on this axis");
    plot.write();
}

} // namespace

int main() {
    workbook::Claims claim;

    // A tower: 1000 balls in a shaft 3 m wide and 250 m high.
    scenes::Dice dice(4);
    scenes::Balls tower;
    for (int i = 0; i < 1000; ++i) {
        const double x = dice.between(-1.5, 1.5), y = dice.between(0, 250), z = dice.between(-1.5, 1.5);
        tower.centres.push_back({x, y, z});
    }
    const auto boxes = tower.boxes();
    const auto right = find_pairs(BoundingBoxes{}, boxes);
    //! [library]
    SortAndSweep::In<Space<>> broadphase(SortAndSweep{}); // kept from step to step, it keeps the order
    std::size_t pairs = 0;
    broadphase.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
    //! [library]
    const std::size_t across = left_by_sweep(boxes, 0), along = left_by_sweep(boxes, 1);
    workbook::say() << "A tower of 1000 balls: of 499500 pairs, " << across << " overlap on the x axis, " << along
                    << " on y, " << pairs << " on all three\n";
    claim("sort and sweep finds the very pairs that the box test finds",
          pairs == right.size() && find_pairs(SortAndSweep{}, boxes) == right);
    claim("along the tower it leaves less than a twentieth of what it leaves across", along < across / 20);
    claim("the library takes the axis along which the centres vary most", broadphase.axis() == 1);

    // In conjunction with any other method.
    const auto heaps = scenes::heaps(2000).boxes();
    //! [inside]
    const auto in_cells = find_pairs(UniformGrid<SortAndSweep>{}, heaps);
    const auto in_cubes = find_pairs(Octree<SortAndSweep>{}, heaps);
    //! [inside]
    claim("inside the cells of a grid or an octree it finds the same",
          in_cells == find_pairs(BoundingBoxes{}, heaps) && in_cubes == in_cells);

    // Coherence: how far bodies go in a step, and how far they move in the order.
    std::vector<double> ways, moves;
    for (double way = 0.001; way < 40; way *= 2) {
        std::vector<double> lower;
        for (const auto& c : tower.centres) lower.push_back(c[1]);
        std::sort(lower.begin(), lower.end());
        for (double& low : lower) low += dice.between(-way, way);
        ways.push_back(way);
        moves.push_back(moves_of_insertion(lower) / 1000);
        if (ways.size() % 4 == 1) std::cout << "Steps of up to " << way << " m: " << moves.back() << " moves a body\n";
    }
    claim("in small steps hardly anybody is overtaken: a move for a hundred bodies", moves.front() < 0.01);
    claim("in large ones the old order is worth little, and sorting anew is cheaper", moves.back() > 10);
    // Two at a distance d change places when their ways, each uniform in [-w, w], differ by more: of 4 a metre, w/3 * 4
    // a body.
    const double expected = 4 * ways[8] / 3;
    std::cout << "At " << ways[8] << " m a step: " << moves[8] << " moves a body, and the density says " << expected
              << '\n';
    claim("it is the density times a third of the way", std::abs(moves[8] / expected - 1) < 0.2);

    draw_intervals();
    workbook::Plot plot("2.1.1.4", "The less bodies move in a step, the cheaper it is to keep their order");
    plot.x("way in a step", "m").y("moves a body").log_x().log_y();
    plot.linked_points("insertion sort", ways, moves)
        .reference("density times w/3", ways, [](double w) { return 4 * w / 3; })
        .write();
    return claim.result();
}
