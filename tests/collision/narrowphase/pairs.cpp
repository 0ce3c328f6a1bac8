// SPDX-License-Identifier: BSL-1.0
// Two shapes: closed forms, hard cases C11 to C14, C15 and C17, symmetry under a swap, and a brute-force oracle.

#include "tests/collision/support.hpp"

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/narrowphase/box_box.hpp>
#include <ansatz/collision/narrowphase/box_plane.hpp>
#include <ansatz/collision/narrowphase/narrowphase.hpp>
#include <ansatz/collision/narrowphase/sphere_box.hpp>
#include <ansatz/collision/narrowphase/sphere_plane.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>
#include <ansatz/collision/plane.hpp>
#include <ansatz/collision/shapes.hpp>
#include <ansatz/collision/sphere.hpp>

using namespace collision_tests;

namespace {
template <class S> auto x3(double x, double y = 0, double z = 0) { return vector_in<S, unit::Length>(x, y, z); }
constexpr auto half = 0.5 * metre;

/// What must hold for every contact: a unit normal, a positive depth, and the mirror image for the exchanged order.
template <class S, class A, class B>
void check_swap(const A& a, const typename S::Position& xa, const B& b, const typename S::Position& xb) {
    const auto one = contact(a, xa, b, xb), other = contact(b, xb, a, xa);
    REQUIRE(one.has_value() == other.has_value());
    if (!one) return;
    CHECK(double(one->depth.value()) > 0);
    CHECK(std::abs(double(one->normal.norm()) - 1) <= rounding<S>(4));
    CHECK(one->depth == other->depth);
    CHECK(one->point == other->point); // to the bit
    if (!(xa == xb)) CHECK((one->normal == -other->normal));
}
} // namespace

TEST_CASE("two spheres: depth, normal from the second to the first, the point between the surfaces",
          "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (const double d : {0.5, 0.8, 0.99}) {
            const auto touch = contact(Sphere{half}, x3<S>(0), Sphere{half}, x3<S>(d));
            REQUIRE(touch);
            CHECK(std::abs(double(touch->depth.value()) - (1 - d)) <= rounding<S>(2));
            CHECK(touch->normal[0] == -1);
            CHECK(std::abs(double(touch->point.value()[0]) - d / 2) <= rounding<S>(2));
        }
        CHECK_FALSE(contact(Sphere{half}, x3<S>(0), Sphere{half}, x3<S>(2)));
    });
}

TEST_CASE("C11: spheres with one centre part along the second axis, as deep as both radii",
          "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        const auto touch = contact(Sphere{half}, x3<S>(1, 2), Sphere{0.25 * metre}, x3<S>(1, 2));
        REQUIRE(touch);
        CHECK(touch->normal[1] == 1);
        CHECK(touch->normal.norm() == 1);
        CHECK(double(touch->depth.value()) == 0.75);
    });
}

TEST_CASE("C12: what only touches does not intersect, whichever comes first", "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        using Scalar = typename S::Scalar;
        auto at_distance = [](Scalar d) { return x3<S>(double(d)); };
        const Scalar less = std::nextafter(Scalar(1), Scalar(0)), more = std::nextafter(Scalar(1), Scalar(2));
        for (const bool swap : {false, true}) {
            auto there = [&](Scalar d) {
                return (swap ? contact(Sphere{half}, at_distance(d), Sphere{half}, x3<S>(0))
                             : contact(Sphere{half}, x3<S>(0), Sphere{half}, at_distance(d)))
                    .has_value();
            };
            CHECK(there(less));
            CHECK_FALSE(there(1));
            CHECK_FALSE(there(more));
        }
    });
}

TEST_CASE("C13: distances from the smallest to the largest that the scalar holds", "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (const double d : {1e-30, 1e-20, 1e-10, 1.0, 1e10, 1e20, 1e30}) {
            const auto touch = contact(Sphere{d * metre}, x3<S>(0), Sphere{d * metre}, x3<S>(0.6 * d, 0.8 * d));
            INFO("distance " << d);
            REQUIRE(touch);
            CHECK(std::abs(double(touch->normal[0]) + 0.6) <= 1e-6);
            CHECK(std::abs(double(touch->normal[1]) + 0.8) <= 1e-6);
            CHECK(std::abs(double(touch->depth.value()) / d - 1) <= 1e-6);
        }
    });
}

TEST_CASE("C14: exchanged, the normal turns round and everything else stays, to the bit", "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        std::mt19937_64 engine(14);
        auto number = [&](double from, double to) { return from + (to - from) * double(engine() >> 11) * 0x1p-53; };
        for (int i = 0; i < 2000; ++i) {
            const auto xa = x3<S>(number(-1, 1), number(-1, 1), number(-1, 1)),
                       xb = x3<S>(number(-1, 1), number(-1, 1), number(-1, 1));
            const Sphere sphere{number(0.1, 1) * metre}, other{number(0.1, 1) * metre};
            const Box box{S::dimension == 2 ? metres(number(0.1, 1), number(0.1, 1), 0)
                                            : metres(number(0.1, 1), number(0.1, 1), number(0.1, 1))};
            const Box crate{S::dimension == 2 ? metres(0.3, 0.4, 0) : metres(0.3, 0.4, 0.5)};
            const Plane plane{Eigen::Vector3d(number(-1, 1), number(-1, 1), S::dimension == 2 ? 0 : number(-1, 1)),
                              number(-1, 1) * metre};
            check_swap<S>(sphere, xa, other, xb);
            check_swap<S>(sphere, xa, box, xb);
            check_swap<S>(box, xa, crate, xb);
            check_swap<S>(sphere, xa, plane, xb);
            check_swap<S>(box, xa, plane, xb);
        }
    });
}

TEST_CASE("C15: far from the origin a float knows a depth as well as its positions, and no better",
          "[collision][narrowphase]") {
    using S = Space<float, 2>;
    for (const float away : {1e2f, 1e4f, 1e5f}) {
        const auto touch = contact(Sphere{half}, S::Position::from_value({away, 0}), Sphere{half},
                                   S::Position::from_value({away + 0.99f, 0}));
        const float ulp = std::nextafter(away, 2 * away) - away;
        REQUIRE(touch);
        CHECK(std::abs(touch->depth.value() - 0.01f) <= ulp);
    }
    using D = Space<double, 2>;
    const auto touch = contact(Sphere{half}, D::Position::from_value({1e7, 0}), Sphere{half},
                               D::Position::from_value({1e7 + 0.99, 0}));
    REQUIRE(touch);
    CHECK(std::abs(touch->depth.value() - 0.01) <= 1e-8);
}

TEST_CASE("C17: the offset of a plane is where its surface lies, wherever the world has its origin",
          "[collision][narrowphase]") {
    for_each_type(AllSpaces{}, []<class S>() {
        const double close = std::is_same_v<typename S::Scalar, float> ? 1e-3 : 1e-12;
        auto depth = [](double plane, double sphere, double r = 0.5) {
            const auto touch = contact(Sphere{r * metre}, x3<S>(0, sphere), Plane::ground(plane * metre), x3<S>(0));
            return touch ? double(touch->depth.value()) : 0.0;
        };
        CHECK(std::abs(depth(2, 2.4) - 0.1) <= close);
        CHECK(std::abs(depth(1002, 1002.4) - 0.1) <= 1000 * close);
        CHECK(depth(2, 2) == 0.5);     // the centre on the surface
        CHECK(depth(2, -98) == 100.5); // far below it: pushed out along N all the same
        CHECK(depth(2, 2.5) == 0);
        // A normal of any length is the same plane; the body's position moves it.
        const Plane steep{Eigen::Vector3d(0, 7, 0), 2.0 * metre};
        const auto touch = contact(Sphere{half}, x3<S>(0, 2.25), steep, x3<S>(0));
        REQUIRE(touch);
        CHECK(double(touch->depth.value()) == 0.25);
        CHECK(contact(Sphere{half}, x3<S>(0, 3.25), steep, x3<S>(0, 1))->depth == touch->depth);
    });
    for (const double length : {1e-300, 1e-200, 1.0, 1e200}) // through a point, too
        CHECK(Plane::through(metres(7, 5, 3), Eigen::Vector3d(0, length, 0)).offset.value() == 5);
}

TEST_CASE("a sphere and a box: faces, edges, corners, and a centre inside", "[collision][narrowphase]") {
    for_each_type(Types<Space<double, 2>, Space<float, 2>>{}, []<class S>() {
        const Box box{metres(1, 2)};
        auto touch = contact(Sphere{half}, x3<S>(1.25, 0.5), box, x3<S>(0)); // at a face
        REQUIRE(touch);
        CHECK((touch->normal[0] == 1 && touch->normal[1] == 0 && double(touch->depth.value()) == 0.25));
        touch = contact(Sphere{half}, x3<S>(1.25, 2.25), box, x3<S>(0)); // at a corner
        REQUIRE(touch);
        CHECK(std::abs(double(touch->depth.value()) - (0.5 - 0.25 * std::sqrt(2.0))) <= rounding<S>(4));
        CHECK(std::abs(double(touch->normal[0]) - std::sqrt(0.5)) <= rounding<S>(4));
        CHECK_FALSE(contact(Sphere{half}, x3<S>(1.4, 2.4), box, x3<S>(0))); // the boxes touch there, the shapes do not
        touch = contact(Sphere{half}, x3<S>(-0.75, 0.5), box, x3<S>(0));    // inside, nearest to the left
        REQUIRE(touch);
        CHECK((touch->normal[0] == -1 && double(touch->depth.value()) == 0.75));
        touch = contact(Sphere{half}, x3<S>(0), box, x3<S>(0)); // in the middle: the nearest face, upwards on its axis
        REQUIRE(touch);
        CHECK((touch->normal[0] == 1 && double(touch->depth.value()) == 1.5));
    });
}

TEST_CASE("moved by its depth along its normal, a pair only touches: every kind of pair", "[collision][narrowphase]") {
    using S = Space<double, 3>;
    std::mt19937_64 engine(5);
    auto number = [&](double from, double to) { return from + (to - from) * double(engine() >> 11) * 0x1p-53; };
    int found = 0;
    auto look = [&](const auto& a, const S::Position& xa, const auto& b, const S::Position& xb) {
        const auto touch = contact(a, xa, b, xb);
        if (!touch) return;
        ++found;
        const S::Position apart = xa + (touch->depth + 1e-9 * metre) * touch->normal;
        const S::Position nearly = xa + (0.999 * touch->depth) * touch->normal;
        CHECK_FALSE(contact(a, apart, b, xb));
        CHECK(contact(a, nearly, b, xb));
    };
    for (int i = 0; i < 2000; ++i) {
        const auto xa = x3<S>(number(-1, 1), number(-1, 1), number(-1, 1)),
                   xb = x3<S>(number(-1, 1), number(-1, 1), number(-1, 1));
        const Sphere sphere{number(0.1, 1) * metre}, other{number(0.1, 1) * metre};
        const Box box{metres(number(0.1, 1), number(0.1, 1), number(0.1, 1))}, crate{metres(0.3, 0.4, 0.5)};
        const Plane plane{Eigen::Vector3d(number(-1, 1), number(-1, 1), number(-1, 1)), number(-1, 1) * metre};
        look(sphere, xa, other, xb);
        look(sphere, xa, box, xb);
        look(box, xa, crate, xb);
        look(sphere, xa, plane, xb);
        look(box, xa, plane, xb);
    }
    CHECK(found > 3000); // of 10000, or the test says nothing
}

TEST_CASE("shapes with numbers that mean nothing are refused by name, value and unit", "[collision][narrowphase]") {
    using S = Space<double, 2>;
    auto world = world_of(SemiImplicitEuler{}, S{}, Projection{});
    auto add = [&](const auto& shape) { return refusal([&] { world.add(shape, mass(1.0 * kilogram)); }); };
    CHECK(add(Sphere{-1.0 * metre}) == "Sphere: radius is -1 m; it must be finite and greater than zero");
    CHECK(add(Sphere{std::nan("") * metre}).find("radius is nan m") != std::string::npos);
    CHECK(add(Box{metres(1, 0)}) == "Box: half is (1, 0, 0) m; two lengths, finite and greater than zero");
    CHECK(add(Box{metres(1, 1, 1)}).find("third component must be 0") != std::string::npos);
    CHECK(add(Plane{Eigen::Vector3d(0, 0, 0), 0.0 * metre}).find("it has a direction") != std::string::npos);
    CHECK(add(Plane{Eigen::Vector3d(0, 0, 1), 0.0 * metre}).find("third component must be 0") != std::string::npos);
    CHECK(world.size() == 0); // and nothing is half done
}
