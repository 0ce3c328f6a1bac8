// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on wind on a triangle (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Point = VectorQuantity<unit::Length, 3>;
using Way = VectorQuantity<unit::Velocity, 3>;
using Area = VectorQuantity<unit::Area, 3>;
using Newtons = VectorQuantity<unit::Force, 3>;

const exercise::Air air{1.3 * kilogram_per_cubic_metre, 1.1, 0.7}, no_lift{1.3 * kilogram_per_cubic_metre, 1.1, 0},
    no_drag{1.3 * kilogram_per_cubic_metre, 0, 0.7};
const double half_density = 0.65; // kg/m^3

struct Triangle {
    Point a, b, c;
};
const Triangle triangles[] = {{metres(0.3, -0.2, 0.7), metres(1.4, 0.3, 0.9), metres(0.6, 1.2, 0.4)},
                              {metres(-2.1, 0.4, 3.3), metres(-1.6, 0.1, 2.7), metres(-2.4, 0.9, 2.9)},
                              {metres(0.7, 5.1, -0.3), metres(0.2, 4.4, 0.8), metres(1.9, 4.7, 0.6)}};
const Area areas[] = {square_metre * Eigen::Vector3d(0.4, -0.7, 0.3), square_metre* Eigen::Vector3d(-1.1, 0.2, 0.6)};
const Way winds[] = {metres_per_second(5, 1.5, -2), metres_per_second(-3, 2.2, 4.1), metres_per_second(0.6, -7, 1.3)};

Area area(const Triangle& t) { return exercise::area(t.a, t.b, t.c); }
template <class Q> std::string said(const Q& q) {
    std::ostringstream text;
    text << q;
    return text.str();
}
std::string of(const Area& a, const Way& w) { return "an area of " + said(a) + " in a wind of " + said(w) + ": "; }
/// As long as one says, and turned out of the direction of x by an angle.
Area turned(double size, double angle) {
    return square_metre * Eigen::Vector3d(size * std::cos(angle), size * std::sin(angle), 0);
}
/// Two triangles with a side in common, whose points all move.
exercise::Cloth kite() {
    return {{metres(0.1, 0.2, 0.3), metres(1.2, 0.1, 0.5), metres(1.4, 1.3, 0.2), metres(-0.1, 1.1, 0.8)},
            {metres_per_second(0.4, -1.1, 0.3), metres_per_second(-0.7, 0.6, 1.9), metres_per_second(1.3, 0.2, -0.8),
             metres_per_second(0.9, 1.7, 0.1)},
            {{0, 1, 2}, {0, 2, 3}}};
}
exercise::Cloth part(exercise::Cloth cloth, std::size_t triangle) {
    cloth.triangles = {cloth.triangles[triangle]};
    return cloth;
}
const Newtons none = newtons(0, 0, 0);

} // namespace

TEST_CASE("as long as the triangle is large", "[task-1][size]") {
    for (const Triangle& t : triangles) {
        const double p = norm(t.b - t.a).value(), q = norm(t.c - t.b).value(), r = norm(t.a - t.c).value(),
                     s = (p + q + r) / 2;
        expect_near("the length of the area of a triangle with sides of " + std::to_string(p) + ", " +
                        std::to_string(q) + " and " + std::to_string(r) + " m",
                    norm(area(t)), std::sqrt(s * (s - p) * (s - q) * (s - r)) * square_metre, 1e-9 * square_metre,
                    "Heron: the root of s (s - p) (s - q) (s - r), with half of the sum of the sides for s.");
    }
}

TEST_CASE("to the side from which the corners go anticlockwise", "[task-1][side]") {
    expect_near("the area of a triangle from (0, 0, 2) m to (3, 0, 2) m and to (0, 4, 2) m",
                exercise::area(metres(0, 0, 2), metres(3, 0, 2), metres(0, 4, 2)),
                Area(square_metre * Eigen::Vector3d(0, 0, 6)), 1e-12 * square_metre,
                "Seen from above, from where z comes, the corners go anticlockwise.");
}

TEST_CASE("wherever it is", "[task-1][moved]") {
    const auto by = metres(3, -2, 7);
    for (const Triangle& t : triangles)
        expect_agree("the area of a triangle", "at its place", area(t), "3 m, -2 m and 7 m further",
                     area({t.a + by, t.b + by, t.c + by}), 1e-9 * square_metre, "An area knows no origin.");
}

TEST_CASE("a sail that faces the wind is pushed along", "[task-2][front]") {
    for (const double speed : {0.8, 3.0, 11.0})
        expect_near("1.7 m^2 across a wind of " + std::to_string(speed) + " m/s",
                    exercise::force(turned(1.7, 0), metres_per_second(speed, 0, 0), air),
                    newtons(half_density * 1.7 * 1.1 * speed * speed, 0, 0), 1e-9 * newton,
                    "Half of the density times the area, c_D and the square of the speed. There is no lift.");
}

TEST_CASE("one that is turned out of it, along and across", "[task-2][turned]") {
    for (const double degrees : {15.0, 40.0, 75.0, 130.0, 220.0, 305.0}) {
        const double angle = degrees * std::acos(-1) / 180, c = std::abs(std::cos(angle));
        // The normal on the lee side is turned by the angle, or by half a turn more.
        const double s = std::cos(angle) < 0 ? -std::sin(angle) : std::sin(angle);
        const double all = half_density * 1.7 * 16;
        expect_near(
            "1.7 m^2, turned out of a wind of 4 m/s by " + std::to_string(degrees) + " degrees",
            exercise::force(turned(1.7, angle), metres_per_second(4, 0, 0), air),
            newtons(all * 1.1 * c, all * 0.7 * c * s, 0), 1e-9 * newton,
            "Along the wind: c_D times the cosine of the angle. Across: c_L times the product of sine and cosine, "
            "to the lee side.");
    }
}

TEST_CASE("a sail along the wind feels nothing", "[task-2][edge]") {
    for (const Way& w : winds) {
        const auto along = cross(w, metres(0.3, 0.5, -0.2)) * (1.0 * second);
        expect_near(of(along, w) + "the force", exercise::force(along, w, air), none, 1e-9 * newton,
                    "Nothing of the wind goes through it.");
    }
}

TEST_CASE("both sides are alike", "[task-2][sides]") {
    for (const Area& a : areas)
        for (const Way& w : winds)
            expect_agree(of(a, w) + "the force", "as it is", exercise::force(a, w, air), "with the other side in front",
                         exercise::force(-a, w, air), 1e-9 * newton, "A sail has no front.");
}

TEST_CASE("lift does no work, and grows with the square as drag does", "[task-2][work]") {
    for (const Area& a : areas)
        for (const Way& w : winds) {
            const auto lift = exercise::force(a, w, no_drag);
            expect_near(of(a, w) + "the power of the lift alone", dot(lift, w), 0.0 * watt, 1e-9 * watt,
                        "It is across the wind.");
            expect_near(of(a, w) + "the lift in three times the wind", exercise::force(a, 3.0 * w, no_drag), 9.0 * lift,
                        1e-9 * newton, "With the square of the speed.");
            expect_near(of(a, w) + "the drag alone", exercise::force(a, w, no_lift),
                        Newtons(half_density * 1.1 * std::abs(a.value().dot(w.value())) * w.value() * newton),
                        1e-9 * newton, "Half of the density times c_D, and what goes through the area, times w.");
        }
}

TEST_CASE("in still air there is none", "[task-2][still]") {
    expect_near("the force on a sail in still air", exercise::force(areas[0], metres_per_second(0, 0, 0), air), none,
                1e-12 * newton, "No wind has no direction, either: nothing may be divided by its speed.");
}

TEST_CASE("each corner has a third", "[task-3][third]") {
    for (std::size_t n = 0; n < 2; ++n) {
        auto cloth = part(kite(), n);
        for (auto& v : cloth.velocities) v = metres_per_second(0.4, -0.3, 0.9);
        const auto forces = exercise::blow(cloth, winds[0], air);
        const auto& [a, b, c] = cloth.triangles[0];
        const auto right = exercise::force(area({cloth.points[a], cloth.points[b], cloth.points[c]}),
                                           winds[0] - cloth.velocities[0], air);
        for (const auto corner : {a, b, c})
            expect_near("the force on corner " + std::to_string(corner) + " of a triangle", forces[corner], right / 3.0,
                        1e-9 * newton, "The force on the triangle, at its middle.");
    }
}

TEST_CASE("who drifts with the wind feels nothing", "[task-3][drift]") {
    auto cloth = kite();
    for (auto& v : cloth.velocities) v = winds[1];
    for (const auto& f : exercise::blow(cloth, winds[1], air))
        expect_near("the force on a point of a cloth that drifts with the wind", f, none, 1e-12 * newton,
                    "The air does not move past it.");
}

TEST_CASE("to fall in still air is to be blown at from below", "[task-3][fall]") {
    auto falls = kite(), rests = kite();
    const auto still = metres_per_second(0, 0, 0);
    for (auto& v : falls.velocities) v = winds[2];
    for (auto& v : rests.velocities) v = still;
    const auto one = exercise::blow(falls, still, air), other = exercise::blow(rests, -winds[2], air);
    for (std::size_t i = 0; i < one.size(); ++i)
        expect_agree("the force on point " + std::to_string(i), "of a cloth that moves in still air", one[i],
                     "of one at rest in a wind against it", other[i], 1e-9 * newton,
                     "What counts is how the air moves past it.");
}

TEST_CASE("a triangle that only turns is at rest as a whole", "[task-3][spin]") {
    auto cloth = part(kite(), 0);
    const auto rest = exercise::blow({cloth.points, {4, metres_per_second(0, 0, 0)}, cloth.triangles}, winds[0], air);
    const auto spin = VectorQuantity<unit::Frequency, 3>::from_value({0.7, -0.4, 1.1});
    const Point middle = (cloth.points[0] + cloth.points[1] + cloth.points[2]) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) cloth.velocities[i] = cross(spin, cloth.points[i] - middle);
    const auto spins = exercise::blow(cloth, winds[0], air);
    for (std::size_t i = 0; i < 3; ++i)
        expect_agree("the force on point " + std::to_string(i), "of a triangle that turns about its middle", spins[i],
                     "of one at rest", rest[i], 1e-9 * newton,
                     "Its velocity is the mean of its corners': none, where it turns about its middle.");
}

TEST_CASE("a point has something from each of its triangles", "[task-3][sum]") {
    const auto cloth = kite();
    const auto all = exercise::blow(cloth, winds[0], air), one = exercise::blow(part(cloth, 0), winds[0], air),
               other = exercise::blow(part(cloth, 1), winds[0], air);
    for (std::size_t i = 0; i < all.size(); ++i)
        expect_near("the force on point " + std::to_string(i) + " of two triangles", all[i], one[i] + other[i],
                    1e-9 * newton, "Of both together it is what it is of one and what it is of the other.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const auto& vector) {
        for (int k = 0; k < 3; ++k) numbers.push_back(vector.value()[k]);
    };
    if (task == 1)
        for (const Triangle& t : triangles) add(area(t));
    if (task == 2) {
        for (const Area& a : areas)
            for (const Way& w : winds) add(exercise::force(a, w, air));
        add(exercise::force(areas[0], metres_per_second(0, 0, 0), air));
    }
    if (task == 3)
        for (const Way& w : winds)
            for (const auto& f : exercise::blow(kite(), w, air)) add(f);
    return numbers;
}
