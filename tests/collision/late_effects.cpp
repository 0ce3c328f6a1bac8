// SPDX-License-Identifier: BSL-1.0
// Effects and row systems behind the contacts see the velocity that bodies have, and change it, where it is derived
// from a history, too: whether the history goes on, begins anew because contacts gave the body a velocity, or is that
// of a part of the step.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/motion/integration.hpp>
#include <ansatz/motion/step.hpp>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60;

/// Whatever comes to x = 4 m goes on at -4 m.
template <Place At> struct Wrap {
    using role = roles::Effect;
    using writes = Columns<Position>;
    static constexpr Place place = At;
    template <class S> struct In {
        explicit In(const Wrap&) {}
        void apply(typename S::Position& x, const auto&) const {
            auto raw = x.value();
            if (raw[0] > 4) raw[0] -= 8;
            x = S::Position::from_value(raw);
        }
    };
};
/// No body is faster than this.
template <Place At> struct Limit {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = At;
    Parameter<unit::Velocity> most = 10.0 * metre_per_second;
    template <class S> struct In {
        typename S::Speed most;
        explicit In(const Limit& limit) : most(S::convert(limit.most)) {}
        void apply(typename S::Velocity& v, const auto&) const {
            const auto speed = norm(v);
            if (speed > most) v *= typename S::Scalar(most / speed);
        }
    };
};
/// The same as a system of a phase.
template <bool Late> struct LimitSystem {
    using role = roles::System;
    static constexpr std::string_view name = "LimitSystem";
    template <class S> struct Slow {
        using writes = Columns<Velocity>;
        static constexpr Phase phase = Late ? phases::end : phases::wake;
        static constexpr std::string_view name = "limit";
        explicit Slow(const LimitSystem&) {}
        void apply(typename S::Velocity& v, const auto&) const {
            const auto speed = norm(v).value();
            if (speed > typename S::Scalar(10)) v *= typename S::Scalar(10) / speed;
        }
    };
    template <class S> using systems = Types<Slow<S>>;
};

template <class I, class... P> auto by_impulses(const P&... policies) {
    return world_of(I{}, Gravity{}, Rest{}, Impulse<>{}, Projection{}, policies...);
}
template <class I, class... P> auto in_substeps(const P&... policies) {
    return world_of(I{}, Gravity{}, Rest{}, SoftSubsteps<>{}, policies...);
}

/// Balls of these speeds roll on the ground, and one that lies beside them.
template <class World_> void rolls(World_ world) {
    world.add(Plane::ground(), fixed);
    const auto lies = world.add(Sphere{0.5 * metre}, at<Space<>>(2, 0.5), mass(1.0 * kilogram));
    const std::vector<double> speeds{0.06, 0.1, 0.19, 0.35, 2};
    std::vector<Handle> roll;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        roll.push_back(world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 2.0 * double(i + 1))),
                                 going<Space<>>(speeds[i]), mass(1.0 * kilogram)));
    for (int n = 0; n < 200; ++n) {
        world.step(dt * second);
        REQUIRE(world.velocity(roll.back()).value()[0] == Approx(2).epsilon(1e-9));
    }
    CHECK(world.motion(lies) == Motion::resting);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        INFO(speeds[i] << " m/s");
        CHECK(world.motion(roll[i]) == Motion::awake);
        const double way = 200 * dt * speeds[i];
        CHECK(x_of(world, roll[i]) == Approx(way > 4 ? way - 8 : way).epsilon(1e-6));
    }
}
/// One is too fast, another meets the ground and bounces.
template <class World_> void limits(World_ world) {
    world.add(Plane::ground(), fixed);
    const auto slow =
        world.add(Sphere{0.5 * metre}, at<Space<>>(2, 0.6), going<Space<>>(1), mass(1.0 * kilogram), restitution(0.5));
    const auto fast = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 50), going<Space<>>(60), mass(1.0 * kilogram));
    for (int i = 0; i < 60; ++i) {
        world.step(dt * second);
        REQUIRE(world.velocity(slow).value()[0] == Approx(1).epsilon(1e-9));
        REQUIRE(norm(world.velocity(fast)).value() <= 10.2); // the limit, and what gravity does in a step
    }
    CHECK(norm(world.velocity(fast)).value() >= 9);
}
} // namespace

TEST_CASE("effects behind contacts see and change what is there, whatever keeps the velocity", "[collision][rest]") {
    const auto all = [](const auto& world) {
        rolls(world);
        limits(world);
    };
    const Wrap<Place::end_of_step> wrap;
    const Limit<Place::end_of_step> limit;
    all(by_impulses<SemiImplicitEuler>(wrap, limit));
    all(by_impulses<Verlet>(wrap, limit));
    all(in_substeps<SemiImplicitEuler>(wrap, limit));
    all(in_substeps<Verlet>(wrap, limit));
}

TEST_CASE("so do row systems behind them, and effects before them", "[collision][motion]") {
    limits(by_impulses<Verlet>(LimitSystem<true>{}));
    limits(in_substeps<Verlet>(LimitSystem<true>{}));
    limits(in_substeps<Verlet>(LimitSystem<false>{}));
    const auto early = in_substeps<Verlet>(Wrap<Place::after_integration>{}, Limit<Place::after_integration>{});
    rolls(early);
    limits(early);
}
