// SPDX-License-Identifier: BSL-1.0
// 2.1.2.1 Sphere and sphere: a contact point, a normal, a depth

// Two spheres intersect where their centres are nearer than both radii. The notes give p = r1 + r2 - d and
// N = |S1 - S2|. A length is no direction: meant is (S1 - S2) / |S1 - S2|. The formula for the impulse survives the
// slip, because it divides by N . N; the contact point and the projection do not, and are wrong by more the further the
// centres are apart. Their point S1 - N (r1 - p) lies on the second sphere; taken halfway, it is the same whichever
// sphere comes first. (A part of 2.1.2.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"
#include "strokes.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/units/print.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

/// What the library says of two spheres in the plane: where, along what, how deep.
void draw_contact() {
    const scenes::Point s1(-0.55, 0.1), s2(0.35, -0.2);
    const Sphere first{0.5 * metre}, second{0.7 * metre};
    const auto touch = contact(first, metres(s1[0], s1[1]), second, metres(s2[0], s2[1]));
    const scenes::Point normal = touch->normal, point(in(x(touch->point), metre), in(y(touch->point), metre));
    const double depth = in(touch->depth, metre);
    workbook::Plot plot("2.1.2.1-contact", "A contact of two spheres: its point, its normal, its depth");
    plot.x("x", "m").y("y", "m").equal_axes();
    scenes::Strokes().circle(s1, 0.5).circle(s2, 0.7).draw(plot, "the spheres");
    scenes::Strokes().arrow(point, point + 0.3 * normal).draw(plot, "N, from the second to the first");
    // Beside the line of the centres, or it would lie under the normal.
    const scenes::Point beside = 0.09 * scenes::Point(-normal[1], normal[0]), half = 0.5 * depth * normal;
    scenes::Strokes()
        .line(point + beside - half, point + beside + half)
        .line(point + 0.5 * beside - half, point + 1.5 * beside - half)
        .line(point + 0.5 * beside + half, point + 1.5 * beside + half)
        .draw(plot, "p, by which they are moved apart");
    plot.note(s1[0], s1[1], "S1").note(s2[0], s2[1], "S2").note(point[0], point[1], "P").write();
}

} // namespace

int main() {
    workbook::Claims claim;
    //! [contact]
    const Sphere ball{0.5 * metre};
    const auto touch = contact(ball, metres(0, 0, 0), ball, metres(0.6, 0, 0));
    std::cout << "depth " << touch->depth << ", point " << touch->point << ", normal (" << touch->normal.transpose()
              << ")\n";
    //! [contact]
    const auto other = contact(ball, metres(0.6, 0, 0), ball, metres(0, 0, 0));
    claim("exchanged, the normal turns round", touch->normal == -other->normal);
    claim("and point and depth are the same, bit for bit",
          touch->point == other->point && touch->depth == other->depth);
    claim("spheres that only touch do not intersect", !contact(ball, metres(0, 0, 0), ball, metres(1, 0, 0)));

    // The contact point of the notes, S1 - N (r1 - p), from either side.
    //! [their point]
    const auto point_of_the_notes = [&](double s1, double s2) { // along x, m
        const double n = (s1 - s2) / std::abs(s1 - s2), p = 0.5 + 0.5 - std::abs(s1 - s2);
        return s1 - n * (0.5 - p);
    };
    //! [their point]
    const double from_one = point_of_the_notes(0, 0.6), from_other = point_of_the_notes(0.6, 0);
    workbook::say() << "With S1 - N (r1 - p) the point is at " << from_one << " m or at " << from_other
                    << " m, as one or the other sphere comes first\n";
    claim("the notes' two points are a depth apart, and the middle between them is the symmetric one",
          std::abs(from_other - from_one - 0.4) < 1e-12 &&
              std::abs(0.5 * (from_one + from_other) - in(x(touch->point), metre)) < 1e-12);

    // Move the first by p along each form of the normal: they should end one diameter apart.
    std::vector<double> distances;
    std::vector<Quantity<unit::Length>> unit_normal, difference;
    for (double size = 0.25; size <= 4; size *= 1.1) { // spheres of this radius, half of it deep in each other
        const Quantity<unit::Length> d = 1.5 * size * metre, p = 0.5 * size * metre;
        distances.push_back(1.5 * size);
        unit_normal.push_back(d + p * 1.0 - 2.0 * size * metre);
        difference.push_back(d + p * in(d, metre) - 2.0 * size * metre); // N = S1 - S2 is as long as d
    }
    const auto off = difference.back();
    std::cout << "With N = S1 - S2, spheres " << distances.back() << " m apart are moved " << off << " too far\n";
    claim("a unit vector moves them exactly until they touch", std::abs(in(unit_normal.back(), metre)) < 1e-12);
    claim("a difference does so at a distance of 1 m only", off > 1.0 * metre);

    draw_contact();
    workbook::Plot plot("2.1.2.1", "A normal that is no unit vector moves spheres by the wrong amount");
    plot.x("distance of the centres (m)").y("gap that is left");
    plot.line("N = (S1 - S2) / |S1 - S2|", distances, unit_normal).line("N = S1 - S2", distances, difference).write();
    return claim.result();
}
