// SPDX-License-Identifier: BSL-1.0
// Shapes that are apart by up to a margin: found if they are, as far apart as they are, with a point halfway between
// them. A response that stops bodies before they intersect believes it, and what is told too near is pushed away.

#include <ansatz/collision/narrowphase/narrowphase.hpp>

#include "tests/collision/support.hpp"

#include <ansatz/collision.hpp>

#include <random>

using namespace collision_tests;

namespace {

using Shapes3 = Narrowphase<Sphere, Plane, Box>;

/// How far a point is outside of a shape at the origin, m; for a box, not within.
double outside(const Sphere& sphere, const Eigen::Vector3d& x) { return x.norm() - sphere.radius.value(); }
double outside(const Plane& plane, const Eigen::Vector3d& x) {
    return plane.normal.value().normalized().dot(x) - plane.offset.value();
}
double outside(const Box& box, const Eigen::Vector3d& x) {
    return (x.cwiseAbs() - box.half.value()).cwiseMax(0).norm();
}
/// How far two shapes are apart, m, by the distance of the first one's centre or nearest corner.
double apart(const Sphere& one, const auto& other, const Eigen::Vector3d& x) {
    return outside(other, x) - one.radius.value();
}
double apart(const Box& one, const Plane& other, const Eigen::Vector3d& x) {
    return outside(other, x) - other.normal.value().normalized().cwiseAbs().dot(one.half.value());
}

/// Tests two shapes, the second at the origin, in both orders.
template <class S, class A, class B>
void look(const A& a, const B& b, const Eigen::Vector3d& x, double margin, int& found) {
    const double gap = apart(a, b, x), bound = rounding<S>(20);
    if (std::abs(gap - margin) < bound) return; // either
    const auto xa = vector_in<S, unit::Length>(x[0], x[1], x[2]), xb = vector_in<S, unit::Length>(0, 0, 0);
    typename Shapes3::template Shapes<S> shapes;
    shapes.set(0, a, typename A::template In<S>(a));
    shapes.set(1, b, typename B::template In<S>(b));
    for (const bool turned : {false, true}) {
        Touch<S> touch;
        const auto by = S::Length::from_value(typename S::Scalar(margin));
        const bool there = turned ? Shapes3::nearly_collide<S>(shapes, 1, xb, 0, xa, by, touch)
                                  : Shapes3::nearly_collide<S>(shapes, 0, xa, 1, xb, by, touch);
        CAPTURE(A::name, B::name, x.transpose(), margin, gap, turned);
        REQUIRE(there == (gap < margin));
        if (!there || gap < bound) continue;
        ++found;
        REQUIRE(std::abs(double(touch.depth.value()) + gap) <= bound);
        const Eigen::Vector3d point = touch.point.value().template cast<double>(),
                              normal = touch.normal.template cast<double>() * (turned ? -1 : 1);
        REQUIRE(std::abs(normal.norm() - 1) <= bound);
        REQUIRE(std::abs(outside(b, point) - gap / 2) <= bound);
        REQUIRE(std::abs(outside(b, point + gap / 2 * normal) - gap) <= bound);
        REQUIRE(std::abs(outside(b, point - gap / 2 * normal)) <= bound);
    }
}

} // namespace

TEST_CASE("shapes that nearly touch are as far apart as they are, whichever is made larger to find it",
          "[collision][narrowphase]") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1, 1), size(0.2, 1), far(0, 1.5);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        const double radius = size(random), other = size(random), margin = far(random);
        const double a = size(random), b = size(random), c = size(random);
        const double u = number(random), v = number(random), w = number(random);
        const double x = 2 * number(random), y = 2 * number(random), z = 2 * number(random);
        const Sphere sphere{radius * metre};
        const Box box{metres(a, b, c)};
        const Plane plane{Eigen::Vector3d(u, v, w), 0.3 * metre};
        const Eigen::Vector3d at(x, y, z);
        look<Space<double, 3>>(sphere, Sphere{other * metre}, at, margin, found);
        look<Space<double, 3>>(sphere, plane, at, margin, found);
        look<Space<double, 3>>(sphere, box, at, margin, found);
        look<Space<double, 3>>(box, plane, at, margin, found);
        look<Space<float, 3>>(sphere, box, at, margin, found);
        look<Space<float, 3>>(box, plane, at, margin, found);
    }
    CHECK(found > 5000);
}

TEMPLATE_TEST_CASE("a body that passes the edge of a box is not pushed by it", "[collision]", Penalty, SoftSubsteps<>) {
    // Both fall abreast; the ball is 6 mm from an edge that it never touches.
    World world{SemiImplicitEuler{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Box>{}, TestType{}};
    const auto box = world.add(Box{metres(0.3, 0.3, 0.3)}, position(metres(2.7, 0, 0)), mass(1.0 * kilogram));
    const auto ball = world.add(Sphere{0.8 * metre}, position(metres(2, 0, 1)), mass(1.0 * kilogram));
    for (const double dt : {0.5, 0.1, 1.0 / 60}) {
        world.step(dt * second);
        CHECK(world.contacts().empty());
        CHECK(world.velocity(box) == world.velocity(ball));
    }
    // And the one goes by the other, 20 m/s, 6 mm beside it.
    world.set_velocity(ball, world.velocity(ball) + metres_per_second(0, 20, 0));
    const auto before = world.velocity(box);
    for (int i = 0; i < 12; ++i) world.step(1.0 / 240 * second);
    CHECK(world.velocity(box).value()[0] == before.value()[0]);
    CHECK(world.velocity(ball).value()[2] == 0);
}
