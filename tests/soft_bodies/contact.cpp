// SPDX-License-Identifier: BSL-1.0
// What a solver of positions makes of contacts that a response answers on velocities: they agree on what velocity
// comes out.
// Runs long with the sanitizers.

#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/collision.hpp>

#include <algorithm>

using namespace soft_bodies_tests;

namespace {

template <class Scalar, class... Response> auto ground(const Response&... response) {
    World world{Space<Scalar, 3>{}, SemiImplicitEuler{},          Gravity{},  Springs<>{}, Xpbd{10, 1},
                SortAndSweep{},     Narrowphase<Sphere, Plane>{}, response...};
    world.add(Plane::ground(), fixed, restitution(0));
    return world;
}
/// A response that acts at the end of the step, and one that takes it in substeps.
template <class Scalar> struct AtEnd {
    static auto world() { return ground<Scalar>(Impulse<>{}, Projection{}); }
};
template <class Scalar> struct InParts {
    static auto world() { return ground<Scalar>(SoftSubsteps<Friction>{}); }
};

} // namespace

TEMPLATE_TEST_CASE("A sheet that falls on the ground lies still, and no contact has made energy", "[soft_bodies]",
                   AtEnd<double>, InParts<double>, AtEnd<float>, InParts<float>) {
    const double stiffness = GENERATE(200., 20000.), height = GENERATE(0.02, 1.);
    auto world = TestType::world();
    const auto sheet = lay_sheet(world, 8, 0.7, height, 0.01, stiffness, 0.02, Sphere{0.02 * metre}, restitution(0));
    const double start = total_energy(world).value();
    double most = start, speed = 0, lowest = 1;
    for (int i = 0; i < 400; ++i) {
        world.step(frame);
        most = std::max(most, double(total_energy(world).value()));
        for (const auto& body : sheet) {
            lowest = std::min(lowest, double(world.position(body).value()[1]));
            if (i >= 300) speed = std::max(speed, double(norm(world.velocity(body)).value()));
        }
    }
    CAPTURE(stiffness, height, start);
    CHECK(speed <= 1e-3);
    CHECK(most <= start + 1e-6);
    CHECK(lowest > 0.019);
}

TEMPLATE_TEST_CASE("A particle that hits the ground leaves with e times its speed", "[soft_bodies]", AtEnd<double>,
                   InParts<double>) {
    // On its way it is held by a slack spring to a particle beside it, which hits the ground at the same time.
    const double e = GENERATE(0., 0.5, 1.);
    auto world = TestType::world();
    const auto a = world.add(Sphere{0.1 * metre}, position(metres(0, 1.1, 0)), mass(1.0 * kilogram), restitution(e));
    const auto b = world.add(Sphere{0.1 * metre}, position(metres(1, 1.1, 0)), mass(1.0 * kilogram), restitution(e));
    world.add(Spring{a, b, 100.0 * newton_per_metre});
    double down = 0, up = 0;
    for (int i = 0; i < 60 && up == 0; ++i) {
        const double before = world.velocity(a).value()[1];
        world.step(frame);
        const double after = world.velocity(a).value()[1];
        if (before < 0 && after >= 0) {
            down = -before;
            up = after;
        }
    }
    CAPTURE(e, down, up);
    REQUIRE(down > 4);
    // Gravity acts in the step of the impact, too: before it or behind it, by part of a step.
    CHECK(up == Approx(e * down).epsilon(0).margin(9.81 / 60 * (1 + e)));
}

TEST_CASE("hard case K12: cloth falls over a ball and comes to rest on it", "[soft_bodies]") {
    // 240 steps a second: in a step no body falls as far as it is thick (one that does needs Swept).
    const double stiffness = GENERATE(500., 5000.);
    World world{SemiImplicitEuler{}, Gravity{},      Springs<>{},           Xpbd{},
                Drag{0.5 / second},  SortAndSweep{}, Narrowphase<Sphere>{}, SoftSubsteps<Friction>{}};
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0.5, 0, 0.5)), fixed, friction(0.8));
    const auto sheet =
        lay_sheet(world, 15, 1, 0.6, 0.005, stiffness, 0.02, Sphere{0.02 * metre}, restitution(0), friction(0.8));
    double deepest = 0;
    for (int i = 0; i < 2400; ++i) {
        world.step(1.0 / 240 * second);
        for (const auto& body : sheet)
            deepest = std::max(deepest, 0.52 - double(norm(world.position(body) - world.position(ball)).value()));
    }
    CAPTURE(stiffness);
    CHECK(world.status().ok());
    CHECK(deepest <= 1e-3);
    CHECK(world.position(sheet[112]).value()[1] > 0.5); // its middle lies on the ball
    CHECK(world.position(sheet[0]).value()[1] < 0.3);   // and its corners hang
    CHECK(double(kinetic_energy(world).value()) < 1e-6);
}
