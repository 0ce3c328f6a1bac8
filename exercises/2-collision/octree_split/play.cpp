// SPDX-License-Identifier: BSL-1.0
// The scene of section 2.1.1.3 with your division in it: balls in heaps.

#include "play.hpp"
#include "broadphase_scenes.hpp"
#include "subject.hpp"

using namespace ansatz;

struct Tree {
    double tests = 0, members = 0;

    void part(const std::vector<exercise::Box>& boxes, exercise::Point centre, double half, int depth) {
        if (!exercise::divide(int(boxes.size()), 24, depth, 16)) {
            tests += 0.5 * double(boxes.size()) * (double(boxes.size()) - 1);
            members += double(boxes.size());
            return;
        }
        std::vector<std::vector<exercise::Box>> parts(8);
        for (const auto& box : boxes)
            for (unsigned p = 0; p < 8; ++p)
                if (exercise::parts_of(box, centre) >> p & 1u) parts[p].push_back(box);
        for (unsigned p = 0; p < 8; ++p) {
            const double by = half / 2;
            part(parts[p], centre + metres(p & 1 ? by : -by, p & 2 ? by : -by, p & 4 ? by : -by), by, depth + 1);
        }
    }
};

int main() {
    workbook::Play table("1000 balls in heaps, a threshold of 24; all pairs would be 499.5 tests a body",
                         {"tests a body", "cells a body is in"});
    table.timed("ns a body");
    const auto balls = scenes::heaps(1000);
    const auto lanes = balls.boxes();
    std::vector<exercise::Box> boxes;
    const Vector<double, 3> half(balls.radius, balls.radius, balls.radius);
    for (const auto& centre : balls.centres) boxes.push_back({(centre - half) * metre, (centre + half) * metre});
    auto yours = [&] {
        Tree tree;
        tree.part(boxes, metres(0, 0, 0), 103, 0);
        return tree;
    };
    scenes::Work work;
    find_pairs(Octree<scenes::Counting>{24, 16, scenes::counted(work)}, lanes);
    static volatile double sink = 0;
    const Tree tree = yours();
    table.row("yours", {tree.tests / 1000, tree.members / 1000}, 1000, [&] { sink = sink + yours().tests; });
    table.row("library", {work.tests / 1000, work.members / 1000}, 1000,
              [&] { sink = sink + double(find_pairs(Octree{}, lanes).size()); });
    return table.print();
}
