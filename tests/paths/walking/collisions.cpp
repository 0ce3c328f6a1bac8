// SPDX-License-Identifier: BSL-1.0
// Walkers that have a shape: on the ground, against what stands in their way, and against each other.

#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <ansatz/collision.hpp>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

struct Yard
    : World<SemiImplicitEuler, Gravity, Rest, SortAndSweep, Narrowphase<Sphere, Plane, Box>, Impulse<>, Projection,
            Walkers> {
    Yard()
        : World(SemiImplicitEuler{}, Gravity{}, Rest{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{}, Impulse<>{},
                Projection{}, Walkers{}) {
        add(Plane::ground(), fixed);
    }
    Handle stands(double x, double z, double kilograms = 60) {
        return add(Sphere{0.4 * metre}, ansatz::position(metres(x, 0.4, z)), ansatz::mass(kilograms * kilogram),
                   ansatz::restitution(0.0));
    }
    auto walks(Handle body, double x, double z) {
        return add(Walk{.body = body,
                        .path = {{metres(x, 0, z)}},
                        .speed = 1.5 * metre / second,
                        .acceleration = 3.0 * metre / second / second,
                        .up = Eigen::Vector3d(0, 1, 0),
                        .astray = 0.5 * metre});
    }
    int count(WalkNews news) const {
        int n = 0;
        for (const auto& event : walk_events()) n += event.news == news;
        return n;
    }
};

} // namespace

TEST_CASE("on the ground it walks as in the air, and lies on the ground", "[walking]") {
    Yard yard;
    const auto body = yard.stands(0, 0);
    const auto walk = yard.walks(body, 6, 2);
    const double all = yard.walking(walk).time_left.value();
    double time = 0;
    for (; time < 2 * all && !yard.walking(walk).arrived; time += 1.0 / 60) {
        yard.step(1.0 / 60 * second);
        REQUIRE(std::abs(yard.position(body).value()[1] - 0.4) < 0.02);
        REQUIRE(!yard.walking(walk).off);
    }
    CHECK(time <= all + 3.0 / 60);
    CHECK(yard.position(body).value()[0] == Approx(6).margin(1e-6));
    CHECK(yard.position(body).value()[2] == Approx(2).margin(1e-6));
}

TEST_CASE("before a box it is stuck and says so; when that is gone it goes on and arrives", "[walking]") {
    Yard yard;
    const auto body = yard.stands(0, 0);
    const auto box = yard.add(Box{metres(0.5, 1, 2)}, position(metres(3, 1, 0)), fixed);
    const auto walk = yard.walks(body, 6, 0);
    int stuck = 0;
    for (int i = 0; i < 60 * 6; ++i) {
        yard.step(1.0 / 60 * second);
        stuck += yard.count(WalkNews::stuck);
        REQUIRE(yard.position(body).value()[0] < 2.5 - 0.4 + 0.05);
    }
    CHECK(stuck == 1);
    CHECK(yard.position(body).value()[0] > 2);
    yard.remove(box);
    for (int i = 0; i < 60 * 6; ++i) yard.step(1.0 / 60 * second);
    CHECK(yard.walking(walk).arrived);
    CHECK(yard.position(body).value()[0] == Approx(6).margin(1e-3));
}

TEST_CASE("what is lighter it pushes out of its way, and who pushes it aside is left behind", "[walking]") {
    Yard yard;
    const auto heavy = yard.stands(0, 0, 80), ball = yard.stands(2, 0.1, 2);
    const auto walk = yard.walks(heavy, 6, 0);
    for (int i = 0; i < 60 * 10 && !yard.walking(walk).arrived; ++i) yard.step(1.0 / 60 * second);
    CHECK(yard.walking(walk).arrived);
    CHECK(std::abs(yard.position(ball).value()[2]) > 0.1); // it was hit off its centre

    // A hundred times as heavy, and fast: the walker is thrown off its way, told so, and arrives all the same.
    Yard other;
    const auto light = other.stands(0, 0, 50), truck = other.stands(3, -8, 5000);
    other.set_velocity(truck, metres_per_second(0, 0, 4));
    const auto way = other.walks(light, 6, 0);
    int off = 0, back = 0, arrived = 0;
    for (int i = 0; i < 60 * 20; ++i) {
        other.step(1.0 / 60 * second);
        off += other.count(WalkNews::pushed_off), back += other.count(WalkNews::back);
        arrived += other.count(WalkNews::arrived);
    }
    CHECK(off >= 1);
    CHECK(back == off);
    CHECK(arrived == 1);
    CHECK(other.walking(way).arrived);
}

TEMPLATE_TEST_CASE(
    "in a plane, seen from above: before a box it is stuck and says so, what is lighter it pushes on, and then "
    "it arrives",
    "[walking]", (std::pair<Space<double, 2>, ExplicitEuler>), (std::pair<Space<double, 2>, VelocityVerlet>),
    (std::pair<Space<float, 2>, Verlet>)) {
    using Scalar = typename TestType::first_type::Scalar;
    World yard{typename TestType::first_type{},
               typename TestType::second_type{},
               SortAndSweep{},
               Narrowphase<Sphere, Box>{},
               Impulse<>{},
               Projection{},
               Walkers{}};
    const auto stands = [&](double x, double z, double kilograms) {
        return yard.add(Sphere{0.4 * metre}, position(metres(x, z)), mass(kilograms * kilogram), restitution(0.0));
    };
    const auto body = stands(0, 0, 80), ball = stands(2, 0.1, 2);
    const auto box = yard.add(Box{metres(0.5, 2)}, position(metres(6, 0)), fixed);
    const auto walk = yard.add(Walk{.body = body,
                                    .path = {{metres(9, 0)}},
                                    .speed = 1.5 * metre / second,
                                    .acceleration = 3.0 * metre / second / second,
                                    .up = {},
                                    .astray = 0.5 * metre});
    int stuck = 0;
    for (int i = 0; i < 60 * 8; ++i) {
        yard.step(1.0 / 60 * second);
        for (const auto& event : yard.walk_events()) stuck += event.news == WalkNews::stuck;
        REQUIRE(yard.position(body).value()[0] < Scalar(5.5 - 0.4 + 0.05));
        REQUIRE(std::isfinite(double(yard.position(ball).value()[1])));
    }
    CHECK(stuck == 1);
    CHECK(yard.position(body).value()[0] > 4);
    CHECK(std::abs(yard.position(ball).value()[1]) > 0.1); // it was hit off its centre
    yard.remove(box);
    for (int i = 0; i < 60 * 6; ++i) yard.step(1.0 / 60 * second);
    CHECK(yard.walking(walk).arrived);
    CHECK(double(yard.position(body).value()[0]) == Approx(9).margin(1e-3));
    CHECK(double(yard.position(body).value()[1]) == Approx(0).margin(1e-3));
}
