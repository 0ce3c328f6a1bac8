// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.1.4 with your answer in it: a tower of balls.

#include "play.hpp"
#include "broadphase_scenes.hpp"
#include "subject.hpp"

using namespace ansatz;

int main() {
    workbook::Play table("A tower of 1000 balls, 3 m wide and 250 m high, of 499500 pairs",
                         {"axis", "pairs on the axis", "that touch on all"});
    table.timed("ns a body");
    scenes::Dice dice(4);
    scenes::Balls tower;
    for (int i = 0; i < 1000; ++i) {
        const double x = dice.between(-1.5, 1.5), y = dice.between(0, 250), z = dice.between(-1.5, 1.5);
        tower.centres.push_back({x, y, z});
    }
    const auto boxes = tower.boxes();
    std::vector<VectorQuantity<unit::Length, 3>> points;
    for (const auto& centre : tower.centres) points.push_back(centre * metre);
    auto yours = [&] {
        const int axis = exercise::widest_axis(points);
        std::vector<Quantity<unit::Length>> lower, upper;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            lower.push_back(boxes.lower(axis)[i] * metre), upper.push_back(boxes.upper(axis)[i] * metre);
        double on_axis = 0, touching = 0;
        for (const auto& [i, j] : exercise::sweep(exercise::sorted(lower), lower, upper, [] {}))
            ++on_axis, touching += boxes.touch(i, j);
        return std::vector<double>{double(axis), on_axis, touching};
    };
    SortAndSweep::In<Space<>> broadphase(SortAndSweep{});
    auto theirs = [&] {
        double pairs = 0;
        broadphase.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
        return pairs;
    };
    double on_axis = 0;
    const double touching = theirs();
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            on_axis += boxes.lower(broadphase.axis())[i] <= boxes.upper(broadphase.axis())[j] &&
                       boxes.lower(broadphase.axis())[j] <= boxes.upper(broadphase.axis())[i];
    static volatile double sink = 0;
    table.row("yours", yours(), 1000, [&] { sink = sink + yours()[2]; });
    table.row("library", {double(broadphase.axis()), on_axis, touching}, 1000, [&] { sink = sink + theirs(); });
    return table.print();
}
