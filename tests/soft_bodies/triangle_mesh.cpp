// SPDX-License-Identifier: BSL-1.0
// Meshes of triangles: counts by formula, edges against brute force, areas and volumes by closed forms, and what is
// refused.

#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/triangle_mesh.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

using namespace ansatz;
using ansatz::test::refusal;
using ansatz::test::sentence;
using Catch::Approx;

namespace {

using Mesh = TriangleMesh;
using Points = std::vector<Mesh::Point>;
using Triangles = std::vector<Mesh::Triangle>;

/// Edges, found the long way: every pair of vertices, every triangle.
void check_against_brute_force(const Mesh& mesh) {
    std::map<Mesh::Edge, std::vector<std::uint32_t>> sides; // the triangles of each edge
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        for (const auto a : mesh.triangles()[t])
            for (const auto b : mesh.triangles()[t])
                if (a < b) sides[{a, b}].push_back(t);
    std::vector<Mesh::Edge> edges, boundary;
    std::size_t inner = 0;
    for (const auto& [ends, triangles] : sides) {
        edges.push_back(ends);
        if (triangles.size() == 1) boundary.push_back(ends);
        if (triangles.size() != 2) continue;
        REQUIRE(inner < mesh.inner_edges().size());
        const auto& edge = mesh.inner_edges()[inner++];
        REQUIRE(edge.ends == ends);
        for (std::size_t side = 0; side < 2; ++side) {
            REQUIRE(edge.triangles[side] == triangles[side]);
            for (const auto v : mesh.triangles()[triangles[side]])
                if (v != ends[0] && v != ends[1]) REQUIRE(edge.opposite[side] == v);
        }
    }
    REQUIRE(inner == mesh.inner_edges().size());
    REQUIRE(std::equal(edges.begin(), edges.end(), mesh.edges().begin(), mesh.edges().end()));
    REQUIRE(std::equal(boundary.begin(), boundary.end(), mesh.boundary().begin(), mesh.boundary().end()));
    CHECK(mesh.is_closed() == boundary.empty());
}
double sum_of(const std::vector<Quantity<unit::Area>>& shares) {
    double sum = 0;
    for (const auto& share : shares) sum += share.value();
    return sum;
}
/// The surface of a tetrahedron with legs of 1 m, which faces outwards.
Mesh tetrahedron() {
    return {Points{metres(0, 0, 0), metres(1, 0, 0), metres(0, 1, 0), metres(0, 0, 1)},
            Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

} // namespace

TEST_CASE("a grid has the vertices, edges and triangles of its formulas", "[soft_bodies]") {
    for (const std::size_t n : {2, 3, 7})
        for (const std::size_t m : {2, 4, 9}) {
            INFO(n << " x " << m);
            const Mesh sheet = Mesh::grid(n, m, metres(2, 0, 0), metres(0, 0, 3), metres(1, 1, 1));
            CHECK(sheet.vertices().size() == n * m);
            CHECK(sheet.triangles().size() == 2 * (n - 1) * (m - 1));
            CHECK(sheet.edges().size() == (n - 1) * m + n * (m - 1) + (n - 1) * (m - 1));
            CHECK(sheet.boundary().size() == 2 * (n - 1) + 2 * (m - 1));
            CHECK(sheet.inner_edges().size() == sheet.edges().size() - sheet.boundary().size());
            CHECK(sheet.is_oriented());
            CHECK_FALSE(sheet.is_closed());
            REQUIRE(sheet.grid_shape());
            CHECK(sheet.grid_shape()->columns == n);
            CHECK(sheet.grid_shape()->rows == m);
            CHECK(sheet.vertices()[0] == metres(1, 1, 1));
            CHECK(sheet.vertices()[n - 1] == metres(3, 1, 1));
            CHECK(sheet.vertices()[n * m - 1] == metres(3, 1, 4));
            CHECK(sheet.area().value() == Approx(6).epsilon(1e-14));
            check_against_brute_force(sheet);
        }
}

TEST_CASE("the shares of the vertices make up the area, and those of a grid are quarters of its cells",
          "[soft_bodies]") {
    const Mesh sheet = Mesh::grid(4, 5, metres(3, 0, 0), metres(0, 4, 0));
    const auto shares = sheet.vertex_areas();
    CHECK(sum_of(shares) == Approx(12).epsilon(1e-14));
    for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(shares[i + 4 * j].value() ==
                  Approx((i == 0 || i == 3 ? 0.5 : 1) * (j == 0 || j == 4 ? 0.5 : 1)).epsilon(1e-14));
    const Mesh tip = tetrahedron();
    const auto of_tip = tip.vertex_areas();
    CHECK(of_tip[0].value() == Approx(1.5 / 3).epsilon(1e-14));
    CHECK(of_tip[1].value() == Approx((1 + std::sqrt(0.75)) / 3).epsilon(1e-14));
    CHECK(sum_of(of_tip) == Approx(tip.area().value()).epsilon(1e-14));
    CHECK(tip.area(2).value() == Approx(std::sqrt(0.75)).epsilon(1e-14));
    CHECK(sentence<std::out_of_range>([&] { tip.area(4); }) ==
          "TriangleMesh::area: triangle 4 does not exist; there are 4");
}

TEST_CASE("a volume is that of the closed form, wherever the surface lies and however its vertices are numbered",
          "[soft_bodies]") {
    CHECK(tetrahedron().volume().value() == Approx(1.0 / 6).epsilon(1e-15));
    CHECK(tetrahedron().moved(metres(1e6, -1e6, 3)).volume().value() == Approx(1.0 / 6).epsilon(1e-9));
    // Turned inside out it is negative.
    const Mesh tip = tetrahedron();
    Triangles inwards;
    for (const auto& [a, b, c] : tip.triangles()) inwards.push_back({a, c, b});
    const auto there = tip.vertices();
    CHECK(Mesh({there.begin(), there.end()}, inwards).volume().value() == Approx(-1.0 / 6).epsilon(1e-15));
    // One triangle turned: closed, but of no side.
    std::swap(inwards[2][0], inwards[2][1]);
    const Mesh turned({there.begin(), there.end()}, inwards);
    CHECK(turned.is_closed());
    CHECK_FALSE(turned.is_oriented());
    CHECK(refusal([&] { turned.volume(); }) ==
          "TriangleMesh::volume: the surface is not oriented; all triangles must face the same side");
    CHECK(refusal([] { Mesh::grid(2, 2, metres(1, 0, 0), metres(0, 1, 0)).volume(); }) ==
          "TriangleMesh::volume: the boundary is 4 edges; only a closed surface has a volume");
}

TEST_CASE("meshes with holes, in pieces and in any order have the edges that brute force finds", "[soft_bodies]") {
    std::mt19937 random(4);
    for (int round = 0; round < 60; ++round) {
        INFO("round " << round);
        const auto n = std::size_t(2 + random() % 6), m = std::size_t(2 + random() % 6);
        const Mesh whole = Mesh::grid(n, m, metres(1, 0, 0.2), metres(0, 1, 0));
        Triangles kept;
        for (Mesh::Triangle t : whole.triangles()) {
            std::rotate(t.begin(), t.begin() + random() % 3, t.end());
            if (random() % 4 != 0) kept.push_back(t);
        }
        if (kept.empty()) continue;
        std::shuffle(kept.begin(), kept.end(), random);
        // Vertices of no triangle are left out, and the others renumbered at random.
        std::set<std::uint32_t> used;
        for (const auto& t : kept) used.insert(t.begin(), t.end());
        std::vector<std::uint32_t> order(used.begin(), used.end());
        std::shuffle(order.begin(), order.end(), random);
        std::map<std::uint32_t, std::uint32_t> number;
        Points places;
        for (const auto v : order) {
            number[v] = std::uint32_t(places.size());
            places.push_back(whole.vertices()[v]);
        }
        for (auto& t : kept)
            for (auto& v : t) v = number[v];
        const Mesh mesh(places, kept);
        check_against_brute_force(mesh);
        CHECK(mesh.is_oriented());
        CHECK_FALSE(mesh.grid_shape());
        CHECK(sum_of(mesh.vertex_areas()) == Approx(mesh.area().value()).epsilon(1e-13));
    }
}

TEST_CASE("what is no surface is refused by name, index and value", "[soft_bodies]") {
    const Points square{metres(0, 0, 0), metres(1, 0, 0), metres(1, 1, 0), metres(0, 1, 0)};
    CHECK(refusal([&] { Mesh(square, {}); }) == "TriangleMesh: the number of triangles is 0; a mesh has at least one");
    CHECK(refusal([&] {
              Mesh(square, {{0, 1, 2}, {0, 2, 4}});
          }) == "TriangleMesh: triangle 1 is {0, 2, 4}; vertex 4 does not exist; there are 4, from 0");
    CHECK(refusal([&] {
              Mesh(square, {{0, 1, 1}});
          }) == "TriangleMesh: triangle 0 is {0, 1, 1}; its vertices are three different ones");
    CHECK(refusal([&] {
              Mesh(square, {{0, 1, 2}, {0, 2, 3}, {2, 0, 1}});
          }) == "TriangleMesh: triangle 2 is {2, 0, 1}; triangle 0 has the same vertices; each is given once");
    CHECK(refusal([&] {
              Mesh(square, {{0, 1, 2}, {1, 0, 2}});
          }) == // facing the other way it is the same one
          "TriangleMesh: triangle 1 is {1, 0, 2}; triangle 0 has the same vertices; each is given once");
    CHECK(refusal([&] {
              Mesh(square, {{0, 1, 2}});
          }) == "TriangleMesh: vertex 3 is in no triangle; each belongs to one, or it would have no mass");
    Points fan = square;
    fan.push_back(metres(0, 0, 1));
    CHECK(refusal([&] {
              Mesh(fan, {{0, 2, 1}, {0, 2, 3}, {0, 2, 4}});
          }) ==
          "TriangleMesh: edge {0, 2} is a side of 3 triangles (0, 1, 2); an edge belongs to one triangle or to two");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([&] {
              Mesh({metres(0, 0, 0), metres(1, nan, 0), metres(1, 1, 0)}, {{0, 1, 2}});
          }) == "TriangleMesh: vertex 1 is (1, nan, 0) m; it must be finite");
    const std::string flat = "its vertices lie in a line or in one place; a triangle has an area";
    CHECK(refusal([&] {
              Mesh({metres(0, 0, 0), metres(1, 0, 0), metres(3, 0, 0)}, {{0, 1, 2}});
          }) == "TriangleMesh: the area of triangle 0 {0, 1, 2} is 0 m^2; " + flat);
    // In a line but for rounding, near and far away; two vertices in one place.
    for (const double far : {0.0, 1e6})
        CHECK_THAT(refusal([&] {
                       Mesh({metres(far, 0.1, 0), metres(far + 0.1, 0.2, 0), metres(far + 0.7, 0.8, 0)}, {{0, 1, 2}});
                   }),
                   Catch::Matchers::EndsWith(flat));
    CHECK_THAT(refusal([&] {
                   Mesh({metres(1, 2, 3), metres(1, 2, 3), metres(2, 2, 3)}, {{0, 1, 2}});
               }),
               Catch::Matchers::EndsWith(flat));
    // Small and slender ones are triangles.
    CHECK(Mesh({metres(0, 0, 0), metres(1e-9, 0, 0), metres(0, 1e-9, 0)}, {{0, 1, 2}}).area().value() ==
          Approx(5e-19).epsilon(1e-14));
    CHECK(Mesh({metres(0, 0, 0), metres(1, 0, 0), metres(0.5, 1e-9, 0)}, {{0, 1, 2}}).area().value() ==
          Approx(5e-10).epsilon(1e-14));
    CHECK_THAT(refusal([&] {
                   Mesh({metres(0, 0, 0), metres(1e300, 0, 0), metres(0, 1e300, 0)}, {{0, 1, 2}});
               }),
               Catch::Matchers::EndsWith("is inf m^2; it must be finite"));
}

TEST_CASE("grids and moved meshes refuse what they cannot be", "[soft_bodies]") {
    const auto along = metres(1, 0, 0), across = metres(0, 1, 0);
    CHECK(refusal([&] { Mesh::grid(1, 3, along, across); }) ==
          "TriangleMesh::grid: columns is 1; a grid has at least 2, and 2^31 at most");
    CHECK(refusal([&] { Mesh::grid(3, 0, along, across); }) ==
          "TriangleMesh::grid: rows is 0; a grid has at least 2, and 2^31 at most");
    CHECK(refusal([&] { Mesh::grid(1000000, 1000000, along, across); }) ==
          "TriangleMesh::grid: columns times rows is 1000000 x 1000000; a mesh has at most 2^31 vertices");
    CHECK_THAT(refusal([&] { Mesh::grid(3, 3, along, 2.0 * along); }),
               Catch::Matchers::EndsWith("a triangle has an area"));
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] { tetrahedron().moved(metres(0, infinity, 0)); }) ==
          "TriangleMesh: vertex 0 is (0, inf, 0) m; it must be finite");
    const Mesh there = tetrahedron().moved(metres(0, 2, 0));
    CHECK(there.vertices()[1] == metres(1, 2, 0));
    CHECK(there.edges().size() == 6);
}
