// SPDX-License-Identifier: BSL-1.0
// How often a force is asked in a step with contacts, and that asking it once for response and integrator changes no
// answer.
// Compiles like 25 kB: a world of its own, with counted forces, for each integrator and response.

#include "tests/collision/support.hpp"

#include <ansatz/springs.hpp>

using namespace collision_tests;

namespace {

long asked = 0;

/// A pull that varies with the height, and counts how often it is asked.
template <class Reads> struct Counted {
    using role = roles::Force;
    using reads = Reads;
    template <class S> struct In {
        explicit In(const Counted&) {}
        typename S::Acceleration acceleration(const auto& q, const auto&) const {
            ++asked;
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[1] = typename S::Scalar(-9.81) - typename S::Scalar(0.01) * q.value()[1];
            return S::Acceleration::from_value(a);
        }
    };
};
using OfPlace = Counted<Columns<Position>>;
using OfVelocity = Counted<Columns<Velocity>>;

/// Does nothing, but says that it changes where bodies are: whatever asked the forces before must ask again.
struct Nudge {
    using role = roles::Effect;
    static constexpr Place place = Place::before_forces;
    using writes = Columns<Position>;
    template <class S> struct In {
        explicit In(const Nudge&) {}
        void apply(auto&, const auto&) const {}
    };
};

template <class... P> auto pile(P... policies) {
    auto world = world_of(policies...);
    world.add(Plane::ground(), fixed);
    std::vector<Handle> bodies;
    for (int i = 0; i < 6; ++i)
        bodies.push_back(
            world.add(Sphere{0.5 * metre}, position(metres(0.02 * (i % 2), 0.5 + i, 0)), mass(1.0 * kilogram)));
    if constexpr ((std::same_as<P, Springs<>> || ...))
        world.add(Spring{bodies[1], bodies[4], 50.0 * newton_per_metre, 0.5 * newton_second_per_metre, 2.0 * metre});
    return world;
}
/// How often each body's force is asked in a step, when the pile lies.
template <class... P> double evaluations(P... policies) {
    auto world = pile(policies...);
    const auto run = [&] {
        for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    };
    run();
    asked = 0;
    run();
    return double(asked) / (60 * 6);
}

} // namespace

TEST_CASE("a response in substeps asks a force as often as the integrator does, and once more in the step",
          "[collision][soft]") {
    for (const int parts : {1, 2, 4, 7}) {
        const SoftSubsteps<> soft{parts};
        CAPTURE(parts);
        CHECK(evaluations(SemiImplicitEuler{}, OfPlace{}, soft) == parts + 1);
        CHECK(evaluations(SemiImplicitEuler{}, OfVelocity{}, soft) == parts + 1);
        CHECK(evaluations(ExplicitEuler{}, OfPlace{}, soft) <= 2 * parts + 1);
        CHECK(evaluations(Verlet{}, OfPlace{}, soft) == parts + 1);
        CHECK(evaluations(Verlet{}, OfVelocity{}, soft) == 2 * parts + 1);
        CHECK(evaluations(VelocityVerlet{}, OfPlace{}, soft) == 2 * parts + 1);
        CHECK(evaluations(RungeKutta4{}, OfVelocity{}, soft) == 4 * parts + 1);
    }
}

TEST_CASE("impulses and projection ask no force again that the integrator has asked", "[collision][projection]") {
    CHECK(evaluations(SemiImplicitEuler{}, OfPlace{}, Impulse{}, Projection{}) == 1);
    CHECK(evaluations(SemiImplicitEuler{}, OfVelocity{}, Impulse{}, Projection{}) == 1);
    CHECK(evaluations(VelocityVerlet{}, OfPlace{}, Impulse{}, Projection{}) == 2);
    CHECK(evaluations(RungeKutta4{}, OfPlace{}, Impulse{}, Projection{}) == 4);
}

TEMPLATE_TEST_CASE("a force of places that is asked once answers what it would have answered twice",
                   "[collision][soft]", SemiImplicitEuler, ExplicitEuler, VelocityVerlet, Verlet, RungeKutta4) {
    const auto equal = [](auto... policies) {
        auto once = pile(TestType{}, OfPlace{}, SoftSubsteps<>{}, policies...);
        auto twice = pile(TestType{}, OfPlace{}, SoftSubsteps<>{}, policies..., Nudge{});
        STATIC_REQUIRE(decltype(once)::composition::asked != decltype(twice)::composition::asked);
        for (int i = 0; i < 200; ++i) {
            if (i == 60) { // some body falls on them, and wakes bodies that sleep
                once.add(Sphere{0.5 * metre}, position(metres(0.3, 9, 0)), mass(2.0 * kilogram));
                twice.add(Sphere{0.5 * metre}, position(metres(0.3, 9, 0)), mass(2.0 * kilogram));
            }
            once.step(1.0 / 60 * second);
            twice.step(1.0 / 60 * second);
            for (std::size_t n = 0; n < once.size(); ++n) {
                CAPTURE(i, n);
                REQUIRE(once.position(once.body_at(n)) == twice.position(twice.body_at(n)));
                REQUIRE(once.velocity(once.body_at(n)) == twice.velocity(twice.body_at(n)));
            }
        }
    };
    // Springs couple bodies, and what falls asleep wakes; for an integrator that keeps velocities and one that keeps a
    // history without that, too: each world takes seconds to compile.
    equal(Springs{}, Rest{});
    if constexpr (std::same_as<TestType, SemiImplicitEuler> || std::same_as<TestType, Verlet>) equal();
}
