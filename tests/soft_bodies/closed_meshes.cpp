// SPDX-License-Identifier: BSL-1.0
// Boxes and balls of triangles: counts, closed forms of volume and area, symmetry.

#include <ansatz/soft_bodies/closed_meshes.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <cmath>

using namespace ansatz;
using ansatz::test::refusal;
using Catch::Approx;

namespace {
/// Euler: V - E + F = 2 for every surface like a sphere's; a closed one has 3 sides for 2 edges.
void check_closed(const TriangleMesh& mesh) {
    CHECK(mesh.is_closed());
    CHECK(mesh.is_oriented());
    CHECK(mesh.vertices().size() + mesh.triangles().size() == mesh.edges().size() + 2);
    CHECK(mesh.inner_edges().size() == mesh.edges().size());
    CHECK(2 * mesh.edges().size() == 3 * mesh.triangles().size());
}
} // namespace

TEST_CASE("the surface of a box: its corners, its counts, its volume and its area", "[soft_bodies]") {
    for (const auto& [nx, ny, nz] : {std::array<std::size_t, 3>{1, 1, 1}, {2, 3, 4}, {5, 1, 2}}) {
        INFO(nx << " x " << ny << " x " << nz);
        const auto box = box_mesh(metres(1, 2, 3), nx, ny, nz, metres(10, 20, 30));
        check_closed(box);
        CHECK(box.vertices().size() == (nx + 1) * (ny + 1) * (nz + 1) - (nx - 1) * (ny - 1) * (nz - 1));
        CHECK(box.triangles().size() == 4 * (nx * ny + ny * nz + nz * nx));
        CHECK(box.volume().value() == Approx(6).epsilon(1e-12)); // greater than zero: it faces outwards
        CHECK(box.area().value() == Approx(22).epsilon(1e-12));
        CHECK(box.vertices()[0] == metres(9.5, 19, 28.5));
        CHECK(box.vertices()[box.vertices().size() - 1] == metres(10.5, 21, 31.5));
    }
}

TEST_CASE("a ball of triangles: an octahedron that nears the sphere, with each vertex its opposite one",
          "[soft_bodies]") {
    const double r = 0.5, sphere = 4.0 / 3 * std::acos(-1.0) * r * r * r;
    CHECK(ball_mesh(r * metre, 0).volume().value() == Approx(4.0 / 3 * r * r * r).epsilon(1e-12));
    double last = 0;
    for (int divisions = 0; divisions <= 4; ++divisions) {
        INFO(divisions << " divisions");
        const auto ball = ball_mesh(r * metre, divisions, metres(1, 2, 3));
        check_closed(ball);
        CHECK(ball.vertices().size() == 2 + (std::size_t(4) << (2 * divisions)));
        CHECK(ball.triangles().size() == std::size_t(8) << (2 * divisions));
        for (const auto& x : ball.vertices()) {
            CHECK(norm(x - metres(1, 2, 3)).value() == Approx(r).epsilon(1e-14));
            const auto opposite = metres(2, 4, 6) - x;
            CHECK(std::any_of(ball.vertices().begin(), ball.vertices().end(),
                              [&](const auto& y) { return norm(y - opposite).value() < 1e-14; }));
        }
        // Inside of the sphere, and with edges of half the length the gap becomes a quarter, in the limit.
        const double gap = sphere - ball.volume().value();
        CHECK(gap > 0);
        if (divisions >= 3) CHECK(last / gap == Approx(4).epsilon(0.1));
        last = gap;
    }
}

TEST_CASE("boxes and balls that cannot be are refused", "[soft_bodies]") {
    CHECK(refusal([] { box_mesh(metres(1, 0, 1)); }) ==
          "box_mesh: size along y is 0 m; it must be finite and greater than zero");
    CHECK(refusal([] { box_mesh(metres(1, 1, 1), 1, 1, 0); }) ==
          "box_mesh: the number of cells along z is 0; it is at least 1, and 10000 at most");
    CHECK(refusal([] { ball_mesh(-1.0 * metre); }) ==
          "ball_mesh: radius is -1 m; it must be finite and greater than zero");
    CHECK(refusal([] { ball_mesh(1.0 * metre, 9); }) == "ball_mesh: divisions is 9; 0 to 8 of them are made");
    CHECK(refusal([] { ball_mesh(1.0 * metre, -1); }) == "ball_mesh: divisions is -1; 0 to 8 of them are made");
}
