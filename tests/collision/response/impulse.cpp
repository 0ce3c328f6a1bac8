// SPDX-License-Identifier: BSL-1.0
// Impulse and projection: hard cases C1 to C6, C9, C24, in every space. C8, with every integrator, is in apexes.cpp.

#include "tests/collision/support.hpp"
#include "tests/measured.hpp"

#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/restitution.hpp>

#include <ansatz/motion/integrators/conjugate_gradient.hpp>

using namespace collision_tests;

namespace {
constexpr double tiny_dt = 1e-9; // so that positions do not matter

template <class S> double close(double size = 1) {
    return std::is_same_v<typename S::Scalar, float> ? 1e-5 * size : 1e-12 * size;
}
} // namespace

TEST_CASE("C1: two bodies separate as restitution says, momentum stays, energy falls by mu (1 - e^2) v^2 / 2",
          "[collision][impulse]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            auto world = world_of(SemiImplicitEuler{}, S{}, Impulse<>{});
            const auto [a, b] = two_spheres(world, 2, -1, 1, 3, e);
            world.step(tiny_dt * second);
            const double va = speed_along(world, a), vb = speed_along(world, b), mu = 0.75;
            const std::string in_scalar = std::is_same_v<typename S::Scalar, float> ? " in float" : "";
            const double off = std::max(std::abs(va - (-0.25 - 2.25 * e)), std::abs(vb - (-0.25 + 0.75 * e)));
            CHECK(test::measured("C1", "error of a velocity" + in_scalar, off, test::at_most(close<S>()), "m/s"));
            CHECK(test::measured("C1", "error of the momentum" + in_scalar, std::abs(va + 3 * vb - (2 - 3)),
                                 test::at_most(rounding<S>(4 * 3)), "kg m/s"));
            const double lost = 0.5 * 4 + 0.5 * 3 - 0.5 * va * va - 1.5 * vb * vb;
            CHECK(test::measured("C1", "error of the energy lost" + in_scalar,
                                 std::abs(lost - 0.5 * mu * (1 - e * e) * 9), test::at_most(close<S>(10)), "J"));
        }
    });
}

TEST_CASE("C2, C3: bodies that move together or part are left alone, to the bit", "[collision][impulse]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (const auto& [va, vb] : {std::pair(5.0, 5.0), std::pair(-1.0, 2.0), std::pair(0.0, 0.0)}) {
            auto world = world_of(SemiImplicitEuler{}, S{}, Impulse<>{});
            const auto [a, b] = two_spheres(world, va, vb, 1, 3, 1);
            world.step(tiny_dt * second);
            CHECK(world.contacts().size() == 1);
            CHECK((speed_along(world, a) == va && speed_along(world, b) == vb));
        }
    });
}

TEST_CASE("C4: what goes across the contact stays as it is, to the bit", "[collision][impulse]") {
    for_each_type(AllSpaces{}, []<class S>() {
        auto world = world_of(SemiImplicitEuler{}, S{}, Impulse<>{});
        const auto [a, b] = two_spheres(world, 2, -1, 1, 3, 0.5);
        world.set_velocity(a, vector_in<S, unit::Velocity>(2, 0.3, -0.7));
        for (const auto body : {a, b})
            world.set_position(body,
                               vector_in<S, unit::Length>(body == a ? 1 : 1.9, 1, 1)); // where a tiny step is none
        world.step(1e-30 * second);
        CHECK(speed_along(world, a) < 0.5);
        CHECK(world.velocity(a).value()[1] == typename S::Scalar(0.3));
        CHECK(world.velocity(b).value()[1] == 0);
    });
}

TEST_CASE("C5, C6: mass ratios up to 1e9, and infinite ones", "[collision][impulse]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (const double R : {1.0, 1e3, 1e6, 1e9}) {
            auto world = world_of(SemiImplicitEuler{}, S{}, Impulse<>{});
            const auto [a, b] = two_spheres(world, 1, 0, R, 1, 1); // the heavy one hits the light one
            world.step(tiny_dt * second);
            CHECK(std::abs(speed_along(world, b) - (2 - 2 / (1 + R))) <= close<S>(2));
            auto other = world_of(SemiImplicitEuler{}, S{}, Impulse<>{});
            const auto [light, heavy] = two_spheres(other, 1, 0, 1, R, 1);
            other.step(tiny_dt * second);
            CHECK(std::abs(speed_along(other, light) - (1 - R) / (1 + R)) <= close<S>(2));
            CHECK(std::abs(speed_along(other, heavy) - 2 / (1 + R)) <= close<S>(2));
        }
        auto world = world_of(SemiImplicitEuler{}, S{}, Impulse<>{}, Projection{});
        const auto ball = world.add(Sphere{0.5 * metre}, at<S>(0), going<S>(1), mass(1.0 * kilogram), restitution(1));
        world.add(Sphere{0.5 * metre}, at<S>(0.9), fixed);
        world.add(Sphere{0.5 * metre}, at<S>(1.2), fixed); // two that nothing moves are no contact
        world.add(Sphere{0.5 * metre}, at<S>(1.5), going<S>(-1), moving);
        world.step(tiny_dt * second);
        CHECK(std::abs(speed_along(world, ball) + 1) <= close<S>());
        CHECK(world.status().ok());
    });
}

TEST_CASE("C24: a projection keeps the centre of mass, and ends the contact", "[collision][projection]") {
    for_each_type(AllSpaces{}, []<class S>() {
        auto world = world_of(SemiImplicitEuler{}, S{}, Projection{});
        const auto [a, b] = two_spheres(world, 0, 0, 1, 9);
        const double before = (x_of(world, a) + 9 * x_of(world, b)) / 10;
        world.step(tiny_dt * second);
        CHECK(std::abs((x_of(world, a) + 9 * x_of(world, b)) / 10 - before) <= rounding<S>(2));
        CHECK(std::abs(x_of(world, b) - x_of(world, a) - 1) <= rounding<S>(4));
        CHECK((speed_along(world, a) == 0 && speed_along(world, b) == 0)); // a push is no velocity
    });
}

TEST_CASE("C9: Zeno's ball lies still after a finite time", "[collision][impulse]") {
    for_each_type(
        Types<ExplicitEuler, SemiImplicitEuler, ImplicitEuler, Verlet, VelocityVerlet, RungeKutta4>{}, []<class I>() {
            auto world =
                world_of(I{}, Gravity{}, Impulse<>{}, Projection{1e-3 * metre}); // or resting bodies lose their contact
            const auto ball =
                world.add(Sphere{0.5 * metre}, at<Space<>>(0, 1.5), mass(1.0 * kilogram), restitution(0.5));
            world.add(Plane::ground(), fixed);
            run(world, 91, 1.0 / 60); // 1.354571 s by the closed form
            int begun = 0;
            for (int i = 0; i < 60; ++i) {
                world.step(1.0 / 60 * second);
                CHECK(std::abs(speed_along(world, ball, 1)) < 0.05);
                CHECK(std::abs(height_of(world, ball) - 0.5) <= 4e-3); // the slop, and what it falls in a step
                for (const auto& c : world.contacts()) begun += c.begins();
            }
            CHECK(begun <= 60);
        });
}

TEST_CASE("a response that would be handed nonsense refuses it by name", "[collision][impulse]") {
    CHECK(refusal([] { restitution(1.5); }) == "restitution: e is 1.5; it is a number from 0 to 1");
    CHECK(refusal([] { restitution(std::nan("")); }).find("e is nan") != std::string::npos);
    CHECK(refusal([] { friction(-1); }) == "friction: mu is -1; it is a number, finite and at least 0");
    CHECK(refusal([] {
              world_of(SemiImplicitEuler{}, Projection{0.0 * metre, 2});
          }) == "Projection: share is 2; it is greater than 0 and at most 1");
    CHECK(refusal([] {
              SoftSubsteps<> s;
              s.parts = 0;
              world_of(SemiImplicitEuler{}, s);
          }) == "SoftSubsteps: parts is 0; it is at least 1");
}
