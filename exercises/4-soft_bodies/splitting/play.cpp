// SPDX-License-Identifier: BSL-1.0
// A sheet of paper in which more and more edges are cut at random, and every vertex is asked to split: yours, and the
// library's, which cuts by springs that break.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/triangle_mesh.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;

const std::size_t n = 16;
const auto mesh = TriangleMesh::grid(n, n, metres(0.2, 0, 0), metres(0, 0.3, 0));
const auto mass_of_vertex = 0.01 * kilogram;

/// Which edges are cut, of a hundred; those of more cuts are cut with more, too.
std::vector<bool> cuts(int percent) {
    std::mt19937 random(7);
    std::vector<bool> cut;
    for (std::size_t i = 0; i < mesh.edges().size(); ++i) cut.push_back(int(random() % 100) < percent);
    return cut;
}

struct Result {
    std::size_t vertices, pieces;
    double mass;
};
/// Of whole triangles: into how many pieces they fall.
Result result(std::size_t vertices, const std::vector<exercise::Corners>& triangles, double mass) {
    std::vector<std::uint32_t> root(vertices);
    std::iota(root.begin(), root.end(), 0U);
    auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const auto& [a, b, c] : triangles) root[find(b)] = root[find(a)], root[find(c)] = root[find(a)];
    std::vector<std::uint32_t> pieces;
    for (const auto& t : triangles) pieces.push_back(find(t[0]));
    std::sort(pieces.begin(), pieces.end());
    return {vertices, std::size_t(std::unique(pieces.begin(), pieces.end()) - pieces.begin()), mass};
}

exercise::Sheet torn_sheet(const std::vector<bool>& cut) {
    exercise::Sheet sheet;
    for (const auto& x : mesh.vertices()) sheet.vertices.push_back({x, metres_per_second(0, 0, 0), mass_of_vertex});
    for (const auto& t : mesh.triangles()) {
        bool whole = true;
        for (std::size_t i = 0; i < mesh.edges().size(); ++i)
            if (cut[i] && exercise::corner_of(t, mesh.edges()[i][0]) < 3 &&
                exercise::corner_of(t, mesh.edges()[i][1]) < 3)
                whole = false;
        if (whole) sheet.triangles.push_back(t);
    }
    return sheet;
}
Result yours(exercise::Sheet sheet) {
    for (std::uint32_t v = 0; v < n * n; ++v) exercise::split(sheet, v);
    double mass = 0;
    for (const auto& vertex : sheet.vertices) mass += vertex.mass.value();
    return result(sheet.vertices.size(), sheet.triangles, mass);
}

using Paper = World<SemiImplicitEuler, Springs<Breaking>, Tearing<Splitting>>;
Result library(Paper world, const std::vector<ElementHandle<TearableTriangle>>& triangles) {
    world.step(1e-30 * second);
    std::vector<exercise::Corners> whole;
    for (const auto t : triangles)
        if (!world.is_torn(t)) {
            const auto corners = world.get(t).corners;
            whole.push_back({corners[0].id, corners[1].id, corners[2].id});
        }
    double mass = 0;
    world.for_each([&](Handle body) { mass += 1 / world.inverse_mass(body).value(); });
    return result(world.size(), whole, mass);
}

int main() {
    workbook::Play table(
        "A sheet of 16 x 16 in which one edge in five is cut, after all that hangs by a point has split:",
        {"vertices", "pieces", "mass, kg"});
    table.timed("ns a sheet");
    workbook::Plot plot("play-soft_bodies.splitting", "Into how many pieces a sheet falls");
    plot.x("edges that are cut", "%").y("pieces");
    std::vector<double> percents, by_you, by_library;
    for (int percent = 0; percent <= 40; percent += 4) {
        const auto cut = cuts(percent);
        const auto sheet = torn_sheet(cut);
        Paper world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 2000}};
        std::vector<Handle> bodies;
        for (const auto& x : mesh.vertices()) bodies.push_back(world.add(position(x), mass(mass_of_vertex)));
        std::vector<ElementHandle<TearableTriangle>> triangles;
        for (const auto& [a, b, c] : mesh.triangles())
            triangles.push_back(world.add(TearableTriangle{{bodies[a], bodies[b], bodies[c]}}));
        for (std::size_t i = 0; i < mesh.edges().size(); ++i) { // a spring that is cut is too long by far
            const Spring edge{.first = bodies[mesh.edges()[i][0]],
                              .second = bodies[mesh.edges()[i][1]],
                              .rest_length = (cut[i] ? 0.001 : 0.1) * metre};
            if (cut[i]) world.add(edge, breaks_at(0.5));
            else world.add(edge);
        }
        const auto own = yours(sheet), of_library = library(world, triangles);
        percents.push_back(percent);
        by_you.push_back(double(own.pieces));
        by_library.push_back(double(of_library.pieces));
        if (percent != 20) continue;
        table.row("yours", {double(own.vertices), double(own.pieces), own.mass}, 1, [sheet] { yours(sheet); });
        table.row("library", {double(of_library.vertices), double(of_library.pieces), of_library.mass}, 1,
                  [world, triangles] { library(world, triangles); });
    }
    plot.line("yours", percents, by_you).line("library", percents, by_library);
    plot.write();
    return table.print();
}
