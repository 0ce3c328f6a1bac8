// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on height maps (notes 7.1).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Map;
using Normal = Vector<double, 3>;

template <class F> Map map_of(int points_x, int points_z, double dx, double dz, const F& f) {
    Map map{points_x, points_z, dx * metre, dz * metre, {}};
    for (int j = 0; j < points_z; ++j)
        for (int i = 0; i < points_x; ++i) map.heights.push_back(f(i * dx, j * dz) * metre);
    return map;
}
/// Powers of two apart, so that a point is exactly where it is asked for.
Map hills() {
    return map_of(5, 4, 0.5, 0.25,
                  [](double x, double z) { return 1 + std::sin(3.1 * x) * std::cos(5.3 * z) + 0.3 * z; });
}
Map plane() {
    return map_of(4, 6, 0.5, 2, [](double x, double z) { return 1.5 + 0.4 * x - 0.7 * z; });
}
/// A bilinear function: a straight line along x and along z, and curved in between.
double saddle_at(double x, double z) { return 0.3 + 0.2 * x - 0.1 * z + 0.6 * x * z; }
Map saddle() { return map_of(3, 5, 0.75, 0.5, saddle_at); }

struct Place {
    double part_x, part_z; // of the map
};
const Place places[] = {{0.13, 0.21}, {0.47, 0.83}, {0.91, 0.06}, {0.68, 0.55}, {0.29, 0.97}};
double wide(const Map& map) { return (map.points_x - 1) * map.dx.value(); }
double deep(const Map& map) { return (map.points_z - 1) * map.dz.value(); }
std::string said(const Map& map, double x, double z) {
    std::ostringstream text;
    text << "a map of " << map.points_x << " by " << map.points_z << " points, " << map.dx << " and " << map.dz
         << " apart, at x = " << x << " m, z = " << z << " m";
    return text.str();
}
auto height(const Map& map, double x, double z) { return exercise::height(map, x * metre, z * metre); }
auto shown(const Normal& n) { return metres(n[0], n[1], n[2]); }

} // namespace

TEST_CASE("at a point it is the height of the point", "[task-1][points]") {
    const Map map = hills();
    for (int j = 0; j < map.points_z; ++j)
        for (int i = 0; i < map.points_x; ++i) {
            const double x = i * map.dx.value(), z = j * map.dz.value();
            expect_near(
                said(map, x, z) + ": the height", height(map, x, z), map.heights[i + map.points_x * j], 1e-12 * metre,
                "Points are numbered with x fastest: number i + points_x * j. Those at the far border are points "
                "like all others.");
        }
}

TEST_CASE("a plane stays a plane", "[task-1][plane]") {
    const Map map = plane();
    for (const auto& p : places) {
        const double x = p.part_x * wide(map), z = p.part_z * deep(map);
        expect_near(said(map, x, z) + ": the height", height(map, x, z), (1.5 + 0.4 * x - 0.7 * z) * metre,
                    1e-12 * metre, "In the middle between two points it is the mean of both, and so on in proportion.");
    }
}

TEST_CASE("in a cell it is straight along x and along z, and along nothing else", "[task-1][saddle]") {
    const Map map = saddle();
    for (const auto& p : places) {
        const double x = p.part_x * wide(map), z = p.part_z * deep(map);
        expect_near(said(map, x, z) + ": the height", height(map, x, z), saddle_at(x, z) * metre, 1e-12 * metre,
                    "All four corners of a cell count, each by the area of the part that is opposite to it.");
    }
}

TEST_CASE("on a plane the normal is that of the plane", "[task-2][normal-of-a-plane]") {
    const Map map = plane();
    for (const auto& p : places) {
        const double x = p.part_x * wide(map), z = p.part_z * deep(map);
        expect_near(said(map, x, z) + ": the normal", shown(exercise::normal(map, x * metre, z * metre)),
                    shown(Normal(-0.4, 1, 0.7).normalized()), 1e-12 * metre,
                    "It leans away from where the surface rises: minus the slope along x, 1, minus the slope along z, "
                    "and then a length of 1.");
    }
}

TEST_CASE("it stands upright on the surface", "[task-2][upright]") {
    for (const Map& map : {hills(), saddle()})
        for (const auto& p : places) {
            const double x = p.part_x * wide(map), z = p.part_z * deep(map);
            const int i = int(x / map.dx.value()), j = int(z / map.dz.value()); // within a cell it is bilinear
            const double u = x / map.dx.value() - i, v = z / map.dz.value() - j;
            auto at = [&](int a, int b) { return map.heights[i + a + map.points_x * (j + b)].value(); };
            auto bilinear = [&](double a, double b) {
                return (1 - a) * (1 - b) * at(0, 0) + a * (1 - b) * at(1, 0) + (1 - a) * b * at(0, 1) +
                       a * b * at(1, 1);
            };
            const double by_x = (bilinear(1, v) - bilinear(0, v)) / map.dx.value(),
                         by_z = (bilinear(u, 1) - bilinear(u, 0)) / map.dz.value();
            const Normal mine = exercise::normal(map, x * metre, z * metre);
            expect_near(said(map, x, z) + ": the normal", shown(mine), shown(Normal(-by_x, 1, -by_z).normalized()),
                        1e-12 * metre,
                        "The slope along x is between those of the two sides of the cell, by how far z is from the one "
                        "and the other.");
        }
}

TEST_CASE("at the far border the normal is that of the last cell", "[task-2][border]") {
    const Map map = plane();
    expect_near(said(map, wide(map), deep(map)) + ": the normal",
                shown(exercise::normal(map, wide(map) * metre, deep(map) * metre)),
                shown(Normal(-0.4, 1, 0.7).normalized()), 1e-12 * metre, "There is no cell behind the last point.");
    expect_near(said(map, 0, 0) + ": the normal", shown(exercise::normal(map, 0.0 * metre, 0.0 * metre)),
                shown(Normal(-0.4, 1, 0.7).normalized()), 1e-12 * metre, "The first cell begins at the first point.");
}

TEST_CASE("tessellated, it has the points in between", "[task-3][points-between]") {
    const Map map = hills();
    for (const int factor : {1, 2, 4}) {
        const Map fine = exercise::tessellated(map, factor);
        std::ostringstream text;
        text << "a map of 5 by 4 points, tessellated by " << factor << ": yours has " << fine.points_x << " by "
             << fine.points_z << " points, and " << fine.heights.size()
             << " heights.\nThere are four cells along x and three along z, each divided; a last point closes the row.";
        expect(fine.points_x == 4 * factor + 1 && fine.points_z == 3 * factor + 1 &&
                   fine.heights.size() == std::size_t(fine.points_x) * std::size_t(fine.points_z),
               text.str());
    }
}

TEST_CASE("tessellated, it is the same surface", "[task-3][same-surface]") {
    for (const Map& map : {hills(), saddle()})
        for (const int factor : {2, 4}) {
            const Map fine = exercise::tessellated(map, factor);
            expect_near("the width of a map that was tessellated", double(fine.points_x - 1) * fine.dx,
                        wide(map) * metre, 1e-12 * metre, "It is as large as before.");
            expect_near("the depth of a map that was tessellated", double(fine.points_z - 1) * fine.dz,
                        deep(map) * metre, 1e-12 * metre, "It is as large as before.");
            for (const auto& p : places) {
                const double x = p.part_x * wide(map), z = p.part_z * deep(map);
                std::ostringstream text;
                text << said(map, x, z) << ", and tessellated by " << factor << ": the height";
                expect_agree(text.str(), "yours, of the map", height(map, x, z), "yours, tessellated",
                             height(fine, x, z), 1e-12 * metre,
                             "The new points lie on the surface that is there. Nothing becomes rounder.");
            }
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const Map& map : {hills(), saddle(), plane()}) {
        for (const auto& p : places) {
            const double x = p.part_x * wide(map), z = p.part_z * deep(map);
            if (task == 1) numbers.push_back(height(map, x, z).value());
            if (task == 2)
                for (int k = 0; k < 3; ++k) numbers.push_back(exercise::normal(map, x * metre, z * metre)[k]);
        }
        if (task == 3) {
            const Map fine = exercise::tessellated(map, 3);
            numbers.insert(numbers.end(),
                           {double(fine.points_x), double(fine.points_z), fine.dx.value(), fine.dz.value()});
            for (const auto& y : fine.heights) numbers.push_back(y.value());
        }
    }
    return numbers;
}
