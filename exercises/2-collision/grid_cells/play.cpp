// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.1.2 with your cells in it: balls in a line, each written down in every cell that it reaches
// into.

#include "play.hpp"
#include "broadphase_scenes.hpp"
#include "subject.hpp"

#include <map>

using namespace ansatz;

/// The pairs of a line of bodies by their cells: how many are told, and how many tests that took.
std::pair<double, double> by_cells(const std::vector<double>& places) {
    const auto width = 1.0 * metre, half = 0.25 * metre;
    std::map<std::int64_t, std::vector<Quantity<unit::Length>>> cells;
    for (const double place : places) {
        const auto reach = exercise::cells_of(place * metre - half, place * metre + half, width);
        for (auto c = reach.first; c <= reach.last; ++c) cells[c].push_back(place * metre);
    }
    double pairs = 0, tests = 0;
    for (const auto& [cell, bodies] : cells)
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = i + 1; j < bodies.size(); ++j, ++tests)
                if (abs(bodies[i] - bodies[j]) <= 2.0 * half)
                    pairs += exercise::told_in(bodies[i] - half, bodies[i] + half, bodies[j] - half, bodies[j] + half,
                                               width) == cell;
    return {pairs, tests};
}

int main() {
    workbook::Play table("1000 bodies of 0.5 m on 500 m, cells of 1 m; all pairs would be 499500 tests",
                         {"pairs told", "tests"});
    table.timed("ns a body");
    std::vector<double> places;
    scenes::Dice dice(3);
    for (int i = 0; i < 1000; ++i) places.push_back(dice.between(-250, 250));
    Boxes<Space<>> boxes;
    for (const double place : places) boxes.push_back(metres(place - 0.25, 0, 0), metres(place + 0.25, 0, 0));
    boxes.set_active(boxes.size());
    scenes::Work work;
    const UniformGrid<scenes::Counting> counting{1.0 * metre, scenes::counted(work)};
    const double theirs = double(find_pairs(counting, boxes).size());
    static volatile double sink = 0;
    const auto [pairs, tests] = by_cells(places);
    table.row("yours", {pairs, tests}, 1000, [&] { sink = sink + by_cells(places).first; });
    table.row("library", {theirs, work.tests}, 1000,
              [&] { sink = sink + double(find_pairs(UniformGrid{1.0 * metre}, boxes).size()); });
    return table.print();
}
