// SPDX-License-Identifier: BSL-1.0
// Doors of a world whose integrator keeps history: whatever is changed through them, the velocity is what it was, and
// the order of the method stays. Each case is held against VelocityVerlet, which stores the velocity.

#include <ansatz/motion/present.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

Attraction of_one() {
    Attraction a;
    a.constant = 1.0 * (cubic_metre / (kilogram * second * second));
    return a;
}
/// The error of the velocity at t = 1 s after n steps; `each` acts before each step.
template <class W, class Each> double error_of(W world, Handle body, int n, const W& finest, Each&& each) {
    for (int i = 0; i < n; ++i) {
        each(world);
        world.step(1.0 / n * second);
    }
    return norm(world.velocity(body) - finest.velocity(body)).value();
}
/// The order to which the error falls, against the same thing with 64 times as many steps.
template <class W, class Each> double order_of(const W& world, Handle body, Each&& each) {
    W finest = world;
    for (int i = 0; i < 64 * 64; ++i) {
        each(finest);
        finest.step(1.0 / (64 * 64) * second);
    }
    return std::log2(error_of(world, body, 32, finest, each) / error_of(world, body, 64, finest, each));
}

} // namespace

TEST_CASE("before the first step whatever stands still has velocity zero", "[world][history]") {
    World world{Verlet{}, Gravity{}, AppliedForces{}, Rest{}};
    const auto ground = world.add(fixed), sleeper = world.add(mass(2.0 * kilogram), resting);
    CHECK(world.velocity(ground) == metres_per_second(0, 0, 0));
    CHECK(world.velocity(sleeper) == metres_per_second(0, 0, 0));
    CHECK(world.status().ok());
    CHECK(kinetic_energy(world) == 0.0 * joule);
    world.apply_impulse(sleeper, newton_seconds(4, 0, 0));
    CHECK(world.velocity(sleeper) == metres_per_second(2, 0, 0));
    World pushed{Verlet{}, AppliedForces{}, Rest{}};
    const auto body = pushed.add(mass(2.0 * kilogram), resting);
    pushed.apply_force(body, newtons(8, 0, 0));
    pushed.step(0.5 * second);
    CHECK(norm(pushed.velocity(body) - metres_per_second(2, 0, 0)) < 1e-14 * metre_per_second);
    CHECK(pushed.status().ok());
}

TEST_CASE("a change of what the forces do leaves the velocity, and the next step goes on from it", "[world][history]") {
    // A constant force of 10 N on 1 kg; then the mass is a hundred times as large.
    World world{Verlet{}, AppliedForces{}};
    const auto body = world.add(velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 9; ++i) {
        world.apply_force(body, newtons(10, 0, 0));
        world.step(0.1 * second);
    }
    CHECK(norm(world.velocity(body) - metres_per_second(10, 0, 0)) < 1e-13 * metre_per_second);
    world.apply_force(body, newtons(10, 0, 0));
    world.set_mass(body, 100.0 * kilogram);
    CHECK(norm(world.velocity(body) - metres_per_second(10, 0, 0)) < 1e-13 * metre_per_second);
    world.step(0.1 * second);
    CHECK(norm(world.velocity(body) - metres_per_second(10.01, 0, 0)) < 1e-13 * metre_per_second);
}

namespace {
struct Charge {
    using Unit = unit::Acceleration;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "charge";
};
struct AlongX {
    using role = roles::Force;
    using reads = Columns<Charge>;
    template <class S> struct In {
        explicit In(const AlongX&) {}
        typename S::Acceleration acceleration(const typename S::template ScalarOf<unit::Acceleration>& q,
                                              const auto&) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = q.value();
            return S::Acceleration::from_value(a);
        }
    };
};
} // namespace

TEST_CASE("a column that a force reads can be written without a push", "[world][history]") {
    World world{Verlet{}, AlongX{}};
    const auto body = world.add(velocity(metres_per_second(9, 0, 0)), with<Charge>(10.0 * metre_per_second_squared));
    world.step(0.1 * second);
    CHECK(norm(world.velocity(body) - metres_per_second(10, 0, 0)) < 1e-13 * metre_per_second);
    world.write<Charge>(body, 0.0 * metre_per_second_squared);
    world.step(0.1 * second);
    CHECK(norm(world.velocity(body) - metres_per_second(10, 0, 0)) < 1e-13 * metre_per_second);
}

TEST_CASE("where bodies act on each other, removing, adding, moving one is no push for the others",
          "[world][history][coupled]") {
    const auto change = GENERATE(0, 1, 2, 3);
    World world{Verlet{}, of_one()};
    const auto sun = world.add(mass(30.0 * kilogram));
    const auto planet =
        world.add(position(metres(1, 0, 0)), velocity(metres_per_second(0, 5.5, 0)), mass(1e-6 * kilogram));
    for (int i = 0; i < 50; ++i) world.step(0.002 * second);
    const auto before = world.velocity(planet);
    if (change == 0) world.remove(sun);
    if (change == 1) world.set_position(sun, metres(100, 0, 0));
    if (change == 2) world.set_mass(sun, 1e-9 * kilogram);
    if (change == 3) world.add(position(metres(0, 1, 0)), mass(500.0 * kilogram));
    CAPTURE(change);
    CHECK(norm(world.velocity(planet) - before) < 1e-12 * metre_per_second);
    if (change == 3) return;
    world.step(0.002 * second);
    CHECK(norm(world.velocity(planet) - before) <
          1e-4 * metre_per_second); // what is left pulls with 0.003 m/s^2 at most
}

TEMPLATE_TEST_CASE("the acceleration is that of the present, whatever was changed", "[world][coupled]",
                   ANSATZ_STAGED_INTEGRATORS) {
    World world{TestType{}, of_one()};
    const auto a = world.add(mass(1.0 * kilogram)), b = world.add(position(metres(2, 0, 0)), mass(1.0 * kilogram));
    auto pull = [&] { return x(world.acceleration(a)).value(); };
    CHECK(pull() == Catch::Approx(0.25));
    world.step(1e-3 * second);
    const double d = norm(world.position(b) - world.position(a)).value();
    CHECK(pull() == Catch::Approx(1 / (d * d)).epsilon(1e-14));
    world.set_position(b, world.position(a) + metres(1, 0, 0));
    CHECK(pull() == Catch::Approx(1));
    world.set_mass(b, 3.0 * kilogram);
    CHECK(pull() == Catch::Approx(3));
    world.set(Attraction{});
    CHECK(pull() == Catch::Approx(3 * 6.6743e-11));
    world.remove(b);
    CHECK(pull() == 0);
}

TEMPLATE_TEST_CASE("a copy, and a world that was asked, step as the original does", "[world][coupled]",
                   ANSATZ_STAGED_INTEGRATORS) {
    World world{TestType{}, of_one(), Rest{}};
    for (int i = 0; i < 4; ++i)
        world.add(position(metres(i, i * i, 0.5 * i)), velocity(metres_per_second(0, 0, 0.1 * i)),
                  mass((1.0 + i) * kilogram));
    auto copy = world;
    for (int i = 0; i < 30; ++i) {
        const auto h = i % 3 == 0 ? 0.01 * second : 0.02 * second; // with and without the sums of the step before
        (void)copy.acceleration(copy.body_at(0));
        (void)total_momentum(copy);
        world.step(h);
        copy = decltype(copy)(copy);
        copy.step(h);
        REQUIRE(copy.hash() == world.hash());
    }
}

TEST_CASE("a door in every step leaves the second order", "[world][history]") {
    auto falling = [](auto integrator) {
        World world{integrator, Gravity{}, QuadraticDrag{0.3 * kilogram_per_metre}, AppliedForces{}};
        world.add(velocity(metres_per_second(3, 1, 0)), mass(1.0 * kilogram));
        return world;
    };
    auto coupled = [](auto integrator) {
        World world{integrator, of_one(), AppliedForces{}};
        world.add(velocity(metres_per_second(0, 0.6, 0)), mass(1.0 * kilogram));
        world.add(position(metres(1.5, 0, 0)), velocity(metres_per_second(0, -0.6, 0)), mass(1.0 * kilogram));
        return world;
    };
    auto check = [](const char* what, auto make, auto each) {
        const auto body = make(Verlet{}).body_at(0);
        const double verlet = order_of(make(Verlet{}), body, each),
                     stored = order_of(make(VelocityVerlet{}), body, each);
        INFO(what << ": order " << verlet << " with Verlet, " << stored << " with VelocityVerlet");
        CHECK(verlet > 1.8);
        CHECK(stored > 1.8);
    };
    auto push = [](auto& world) { world.apply_force(world.body_at(0), newtons(2, 0, 0)); };
    auto same_velocity = [](auto& world) { world.set_velocity(world.body_at(0), world.velocity(world.body_at(0))); };
    auto same_place = [](auto& world) { world.set_position(world.body_at(0), world.position(world.body_at(0))); };
    check("apply_force, drag", falling, push);
    check("set_velocity, drag", falling, same_velocity);
    check("set_position, drag", falling, same_place);
    check("set, drag", falling, [](auto& world) { world.set(Gravity{}); });
    check("apply_force, attraction", coupled, push);
    check("set_position, attraction", coupled, same_place);
}

TEST_CASE("many bodies that are removed before the first step cost no more than their number", "[world][history]") {
    World world{Verlet{}, Gravity{}};
    std::vector<Handle> bodies;
    for (int i = 0; i < 2000; ++i) bodies.push_back(world.add());
    for (const auto body : bodies) world.remove(body);
    const auto again = world.add(velocity(metres_per_second(1, 0, 0))); // with an id that was given out before
    world.step(0.5 * second);
    CHECK(norm(world.velocity(again) - metres_per_second(1, -0.5 * 9.81, 0)) < 1e-14 * metre_per_second);
    CHECK(world.status().ok());
}
