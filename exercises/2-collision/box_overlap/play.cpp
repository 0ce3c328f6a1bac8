// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.1.1 with your test in it: balls in a cube, of which few touch.

#include "play.hpp"
#include "broadphase_scenes.hpp"
#include "subject.hpp"

using namespace ansatz;

int main() {
    workbook::Play table("400 balls, a quarter of one in each cubic metre; 79800 pairs",
                         {"boxes that touch", "balls that touch"});
    table.timed("ns a pair");
    const auto balls = scenes::uniform(400);
    const auto lanes = balls.boxes();
    std::vector<exercise::Box> boxes;
    const Vector<double, 3> half(balls.radius, balls.radius, balls.radius);
    for (const auto& centre : balls.centres) boxes.push_back({(centre - half) * metre, (centre + half) * metre});
    auto balls_of = [&](const auto& pairs) {
        double touching = 0;
        for (const auto& [i, j] : pairs) touching += balls.touch(i, j);
        return touching;
    };
    static volatile double sink = 0;
    const auto mine = exercise::touching_pairs(boxes);
    const auto theirs = find_pairs(BoundingBoxes{}, lanes);
    table.row("yours", {double(mine.size()), balls_of(mine)}, 79800,
              [&] { sink = sink + double(exercise::touching_pairs(boxes).size()); });
    table.row("library", {double(theirs.size()), balls_of(theirs)}, 79800,
              [&] { sink = sink + double(find_pairs(BoundingBoxes{}, lanes).size()); });
    return table.print();
}
