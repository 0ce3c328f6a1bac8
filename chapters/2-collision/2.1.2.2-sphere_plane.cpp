// SPDX-License-Identifier: BSL-1.0
// 2.1.2.2 Sphere and plane: how high the centre is above the surface

// With the plane's equation N . x + d = 0 the height of a centre S is s = N . S + d, and the sphere intersects the
// plane where s < r, by p = r - s. The notes call d "the distance from the centre of the sphere" two lines after it was
// the plane's own constant. Read so, the depth depends on where the world has its origin: move plane and sphere
// together along N, and it changes. (A part of 2.1.2.)

#include "claims.hpp"
#include "plot.hpp"
#include "strokes.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/units/print.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

/// A sphere that is partly below a slope, and what the library says of it.
void draw_contact() {
    const scenes::Point normal = scenes::Point(-0.4, 1).normalized(), along(normal[1], -normal[0]), centre(-0.25, 0.2);
    const Plane slope{Eigen::Vector3d(-0.4, 1, 0)}; // it makes a unit vector of it
    const auto touch = contact(Sphere{0.5 * metre}, metres(centre[0], centre[1]), slope, metres(0, 0));
    const scenes::Point point(in(x(touch->point), metre), in(y(touch->point), metre));
    const scenes::Point foot = centre - centre.dot(normal) * normal;
    const scenes::Point lowest = foot - in(touch->depth, metre) * normal;
    workbook::Plot plot("2.1.2.2-contact", "A contact of a sphere and a plane: s is how high the centre is above it");
    plot.x("x", "m").y("y", "m").equal_axes();
    scenes::Strokes().circle(centre, 0.5).draw(plot, "the sphere");
    scenes::Strokes surface;
    surface.line(-0.9 * along, 1.3 * along);
    for (double at = -0.9; at < 1.25; at += 0.1) surface.line(at * along, (at - 0.06) * along - 0.08 * normal);
    surface.draw(plot, "the plane");
    scenes::Strokes().line(foot, centre).draw(plot, "s");
    scenes::Strokes().line(lowest, foot).draw(plot, "p = r - s");
    scenes::Strokes().arrow(0.9 * along, 0.9 * along + 0.4 * normal).draw(plot, "N");
    plot.note(centre[0], centre[1], "S").note(point[0], point[1], "P").write();
}

} // namespace

int main() {
    workbook::Claims claim;
    //! [plane]
    const auto touch = contact(Sphere{0.5 * metre}, metres(0, 2.4, 0), Plane::ground(2.0 * metre), metres(0, 0, 0));
    std::cout << "A ball of 0.5 m at 2.4 m over ground at 2 m: " << touch->depth << " deep, at " << touch->point
              << '\n';
    //! [plane]
    claim("p = r - s", std::abs(in(touch->depth, metre) - 0.1) < 1e-12);

    std::vector<Quantity<unit::Length>> heights, depths, misread;
    for (double h = 0; h <= 10; h += 0.5) {
        heights.push_back(h * metre);
        depths.push_back(
            contact(Sphere{0.5 * metre}, metres(0, h + 0.4, 0), Plane::ground(h * metre), metres(0, 0, 0))->depth);
        const double distance = 0.4; // read as "the distance from the centre of the sphere"
        misread.push_back((0.5 - (h + 0.4 + distance)) * metre);
    }
    double off = 0;
    for (const auto& p : depths) off = std::max(off, std::abs(in(p, metre) - 0.1));
    claim("moved along N together, ball and plane keep their depth", off < 1e-12);
    claim("with d as a distance they do not", std::abs(in(misread.back() - misread.front(), metre)) > 9);

    //! [below]
    const auto below = contact(Sphere{0.5 * metre}, metres(0, -3, 0), Plane::ground(), metres(0, 0, 0));
    //! [below]
    std::cout << "3 m below the ground it is still pushed out: " << below->depth << " along ("
              << below->normal.transpose() << ")\n";
    claim("a plane is a half-space: whoever is below is pushed out along N",
          below->depth == 3.5 * metre && below->normal[1] == 1);

    draw_contact();
    workbook::Plot plot("2.1.2.2", "The depth does not depend on where the origin is");
    plot.x("height of the plane").y("depth");
    plot.line("s = N . S + d", heights, depths).line("d read as a distance", heights, misread).write();
    return claim.result();
}
