// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the angle of a hinge (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Corners;
using Length3 = VectorQuantity<unit::Length, 3>;
using Plain = Vector<double, 3>;
const char* const names[] = {"a", "b", "c", "d"};
const auto per_metre = 1.0 / metre;
const double whole_turn = 2 * std::acos(-1.0);

Length3 in_metres(const Plain& x) { return Length3::from_value(x); }

/// A hinge that is folded on purpose: the left wing lies level, and the right one hangs down by the angle.
struct Fold {
    double angle;               // rad
    double edge;                // m
    double left_foot, left;     // of the left wing: where its height stands on the edge, and the height, m
    double right_foot, right;   // of the right one
    std::array<double, 3> away; // where a is, m
    std::array<double, 3> towards, beside;

    Plain from() const { return {away[0], away[1], away[2]}; }
    Plain along() const { return Plain(towards[0], towards[1], towards[2]).normalized(); }
    Plain up() const { return along().cross(Plain(beside[0], beside[1], beside[2])).normalized(); }
    Plain to_the_left() const { return up().cross(along()); }
    /// Upwards on the right wing.
    Plain right_up() const { return std::cos(angle) * up() - std::sin(angle) * to_the_left(); }
    Corners corners() const {
        const Plain out = -std::cos(angle) * to_the_left() - std::sin(angle) * up();
        return {in_metres(from()), in_metres(from() + edge * along()),
                in_metres(from() + left_foot * along() + left * to_the_left()),
                in_metres(from() + right_foot * along() + right * out)};
    }
};
const Fold folds[] = {
    {0.35, 0.7, 0.2, 0.45, 0.5, 0.3, {0.4, -1.2, 0.6}, {0.3, -0.5, 0.8}, {0.7, 0.2, -0.4}},
    {-0.82, 1.6, 1.1, 0.9, -0.3, 1.3, {-2.1, 0.7, 1.4}, {-0.6, 0.4, 0.5}, {0.2, 0.9, 0.3}},
    {1.23, 0.4, 0.15, 0.6, 0.32, 0.25, {0.2, 0.3, -0.9}, {0.8, 0.5, -0.3}, {-0.4, 0.6, 0.7}},
    {2.41, 1.3, 1.7, 0.5, 0.4, 0.8, {1.5, -0.4, 0.3}, {-0.2, -0.7, 0.6}, {0.5, 0.4, 0.8}},
    {-2.74, 0.55, 0.37, 0.35, 0.13, 0.7, {-0.6, 1.9, -1.3}, {0.5, 0.3, 0.9}, {0.6, -0.8, 0.2}},
};
std::string said(const Fold& f) {
    std::ostringstream text;
    text << "an edge of " << f.edge << " m, wings of " << f.left << " m and " << f.right << " m that stand on it at "
         << f.left_foot << " m and " << f.right_foot << " m, folded by " << f.angle << " rad";
    return text.str();
}

/// The angle that corners have, rad: what of the wings lies across the edge, as arms that turn about it.
double turned(const Corners& at) {
    const Plain e = (at[1] - at[0]).value().normalized();
    Plain left = (at[2] - at[0]).value(), right = (at[0] - at[3]).value();
    left -= left.dot(e) * e;
    right -= right.dot(e) * e;
    return std::atan2(e.dot(left.cross(right)), left.dot(right));
}
/// By how much a function of the corners changes for each metre that a corner is moved.
Plain slope(const Corners& at, std::size_t corner, auto&& f) {
    const double small = 1e-5;
    Plain all;
    for (int k = 0; k < 3; ++k) {
        Corners plus = at, minus = at;
        plus[corner] += in_metres(small * Plain::Unit(k));
        minus[corner] -= in_metres(small * Plain::Unit(k));
        all[k] = (f(plus) - f(minus)) / (2 * small);
    }
    return all;
}

struct Spring {
    double stiffness, rest;
    double off(double angle) const { return std::remainder(angle - rest, whole_turn); }
};
const Spring springs[] = {{0.4, 0.17}, {3.5, -0.6}, {0.07, 1.9}};
auto forces_of(const Fold& f, const Spring& s) {
    return exercise::forces(f.corners(), s.stiffness * joule, radians(s.rest));
}
std::string said(const Fold& f, const Spring& s) {
    std::ostringstream text;
    text << said(f) << ", a hinge of " << s.stiffness << " J that rests at " << s.rest << " rad";
    return text.str();
}

} // namespace

TEST_CASE("a folded square has the angle that it was folded by", "[task-1][square]") {
    for (const double degree : {15.0, -15.0, 90.0, -90.0, 150.0, -150.0}) {
        Fold square = folds[0];
        square.angle = degrees(degree).value();
        square.edge = 0.3 * std::sqrt(2.0);
        square.left_foot = square.right_foot = square.left = square.right = square.edge / 2;
        std::ostringstream text;
        text << "a square of 0.3 m folded along its diagonal by " << degree << " degrees";
        expect_near(text.str(), exercise::angle(square.corners()), degrees(degree), 1e-13 * radian,
                    "It is the angle between the two normals, and positive where the wings hang down from the edge.");
    }
}

TEST_CASE("any two triangles have the angle that they were folded by", "[task-1][folded]") {
    for (const Fold& f : folds)
        expect_near(said(f), exercise::angle(f.corners()), radians(f.angle), 1e-13 * radian,
                    "It is the angle between the normals, whatever the triangles look like; positive on a ridge, "
                    "negative in a valley, and more than a right angle where the wings are folded that far.");
}

TEST_CASE("a gentle fold keeps its digits", "[task-1][gentle]") {
    for (Fold f : folds)
        for (const double gentle : {1e-7, -3e-6}) {
            f.angle = gentle;
            expect_near(said(f), exercise::angle(f.corners()), radians(gentle), 1e-13 * radian,
                        "The cosine of a small angle is 1 to all its digits. Take the angle from its sine as well, and "
                        "its sign with it.");
        }
}

TEST_CASE("a hinge that is moved and turned keeps its angle", "[task-1][moved]") {
    for (const Fold& f : folds) {
        Fold moved = f;
        moved.away = {f.away[2] + 3, f.away[0] - 2, f.away[1] + 0.7};
        moved.towards = {f.beside[1], -f.towards[0], f.towards[2]};
        moved.beside = {-f.towards[2], f.beside[0], f.towards[1]};
        expect_agree(said(f) + ", and the same elsewhere, turned", "yours, here", exercise::angle(f.corners()),
                     "yours, there", exercise::angle(moved.corners()), 1e-13 * radian,
                     "The angle belongs to the hinge alone: there is no axis of the world in it.");
    }
}

TEST_CASE("seen from the other end it is as folded", "[task-1][other-end]") {
    for (const Fold& f : folds) {
        const auto [a, b, c, d] = f.corners();
        expect_agree(said(f) + ", and with both ends and both wings exchanged", "yours, from a to b",
                     exercise::angle({a, b, c, d}), "yours, from b to a", exercise::angle({b, a, d, c}), 1e-13 * radian,
                     "Walk along a ridge in the other direction: left and right are exchanged, and it is a ridge "
                     "still.");
    }
}

TEST_CASE("a gradient is what a small way changes", "[task-2][differences]") {
    for (const Fold& f : folds) {
        const auto yours = exercise::gradient(f.corners());
        for (std::size_t i = 0; i < 4; ++i)
            expect_near(said(f) + ": the gradient of " + names[i], yours[i],
                        exercise::Gradient::from_value(slope(f.corners(), i, turned)), 1e-6 * per_metre,
                        "Right is the angle of a corner moved by a hundredth of a millimetre to and fro, over that "
                        "way, along each axis.");
    }
}

TEST_CASE("a hinge that is moved as a whole keeps its angle", "[task-2][sum]") {
    for (const Fold& f : folds) {
        const auto yours = exercise::gradient(f.corners());
        expect_near(said(f) + ": the four gradients in sum", yours[0] + yours[1] + yours[2] + yours[3],
                    exercise::Gradient::from_value(Plain::Zero()), 1e-12 * per_metre,
                    "Move all four corners by the same way, and the angle stays: the gradients are none in sum.");
    }
}

TEST_CASE("a hinge that is turned as a whole keeps its angle", "[task-2][turn]") {
    for (const Fold& f : folds) {
        const auto yours = exercise::gradient(f.corners());
        Plain sum = Plain::Zero();
        for (std::size_t i = 0; i < 4; ++i) sum += (f.corners()[i] - f.corners()[0]).value().cross(yours[i].value());
        expect_near(said(f) + ": the lever from a crossed with the gradient, in sum over the corners", sum.norm(), 0.0,
                    1e-12,
                    "Turn all four corners together, and the angle stays: the gradients have no torque. Each wing "
                    "pushes back on the edge at the foot of its height.");
    }
}

TEST_CASE("a wing turns by its way over its height", "[task-2][wing]") {
    for (const Fold& f : folds) {
        const auto yours = exercise::gradient(f.corners());
        const char* why = "A tip that is raised by a small way turns its wing about the edge by that way over the "
                          "triangle's height, out of the ridge. Moved within its triangle it changes nothing.";
        expect_near(said(f) + ": the gradient of c", yours[2], exercise::Gradient::from_value(-f.up() / f.left),
                    1e-12 * per_metre, why);
        expect_near(said(f) + ": the gradient of d", yours[3], exercise::Gradient::from_value(-f.right_up() / f.right),
                    1e-12 * per_metre, why);
    }
}

TEST_CASE("a force is what the energy loses", "[task-3][energy]") {
    for (const Fold& f : folds)
        for (const Spring& s : springs) {
            const auto yours = forces_of(f, s);
            const auto energy = [&](const Corners& at) {
                return 0.5 * s.stiffness * s.off(turned(at)) * s.off(turned(at));
            };
            for (std::size_t i = 0; i < 4; ++i)
                expect_near(said(f, s) + ": the force on " + names[i], yours[i],
                            VectorQuantity<unit::Force, 3>::from_value(-slope(f.corners(), i, energy)), 1e-5 * newton,
                            "Right is what half of k (theta - theta_0)^2 loses for each metre that the corner is "
                            "moved.");
        }
}

TEST_CASE("a hinge at rest does nothing", "[task-3][rest]") {
    for (const Fold& f : folds) {
        const auto yours = forces_of(f, {2.3, f.angle});
        for (std::size_t i = 0; i < 4; ++i)
            expect_near(said(f, {2.3, f.angle}) + ": the force on " + names[i], yours[i], newtons(0, 0, 0),
                        1e-11 * newton, "It is as folded as it wants to be. A crease is a hinge that rests folded.");
    }
}

TEST_CASE("a hinge goes the shorter way", "[task-3][shorter-way]") {
    for (Fold f : folds)
        for (const double side : {-1.0, 1.0}) {
            f.angle = side * 2.9;
            const Spring s{0.6, -side * 2.7};
            const double torque = 0.6 * side * (2.9 + 2.7 - whole_turn); // as long as it lies beyond half a turn
            const auto yours = forces_of(f, s);
            expect_near(said(f, s) + ": the force on c", yours[2],
                        VectorQuantity<unit::Force, 3>::from_value(torque / f.left * f.up()), 1e-11 * newton,
                        "The two angles are 0.68 rad apart, through the closed hinge, and not 5.6 rad. The force on a "
                        "tip is the stiffness times that, over the height.");
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const Fold& f : folds) {
        if (task == 1) numbers.push_back(exercise::angle(f.corners()).value());
        if (task == 2)
            for (const auto& g : exercise::gradient(f.corners()))
                numbers.insert(numbers.end(), {g.value()[0], g.value()[1], g.value()[2]});
        if (task == 3)
            for (const Spring& s : {Spring{0.7, 0.21}, Spring{0.9, -1.3}, Spring{0.3, 2.6}})
                for (const auto& force : forces_of(f, s))
                    numbers.insert(numbers.end(), {force.value()[0], force.value()[1], force.value()[2]});
    }
    return numbers;
}
