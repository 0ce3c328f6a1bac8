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

/// Whoever comes to x = 4 m goes on at -4 m.
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
/// Nobody is faster than this.
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

/// Calls `f(world)` with worlds of every integrator and response, and these policies.
template <class... P> void with_each(const auto& f, const P&... policies) {
    const auto of = [&]<class I>(I integrator) {
        f(world_of(integrator, Gravity{}, Impulse<>{}, Projection{}, policies...));
        f(world_of(integrator, Gravity{}, SoftSubsteps<>{}, policies...));
        f(world_of(integrator, Gravity{}, Penalty{}, policies...));
    };
    of(SemiImplicitEuler{});
    of(Verlet{});
    of(VelocityVerlet{});
}
} // namespace

TEST_CASE("an effect that moves a body gives it no velocity", "[collision][motion]") {
    const auto rolls = [](auto world) {
        using S = typename decltype(world)::S;
        world.add(Plane::ground(), fixed);
        const auto ball = world.add(Sphere{0.5 * metre}, at<S>(0, 0.5), going<S>(2), mass(1.0 * kilogram));
        for (int i = 0; i < 200; ++i) {
            world.step(dt * second);
            REQUIRE(world.velocity(ball).value()[0] == Approx(2).epsilon(1e-9));
        }
        CHECK(x_of(world, ball) == Approx(200 * 2 * dt - 8).epsilon(1e-6));
    };
    with_each(rolls, Wrap<Place::end_of_step>{});
    with_each(rolls, Wrap<Place::after_integration>{});
}

TEST_CASE("an effect that limits speed does so wherever it stands", "[collision][motion]") {
    const auto limits = [](auto world) {
        using S = typename decltype(world)::S;
        world.add(Plane::ground(), fixed);
        const auto slow = [&] {
            const auto sphere = Sphere{0.5 * metre};
            if constexpr (decltype(world)::composition::template stores<Restitution>)
                return world.add(sphere, at<S>(7, 0.6), going<S>(1), mass(1.0 * kilogram), restitution(0.5));
            else return world.add(sphere, at<S>(7, 0.6), going<S>(1), mass(1.0 * kilogram));
        }();
        const auto fast = world.add(Sphere{0.5 * metre}, at<S>(0, 50), going<S>(60), mass(1.0 * kilogram));
        for (int i = 0; i < 60; ++i) {
            world.step(dt * second);
            REQUIRE(world.velocity(slow).value()[0] == Approx(1).epsilon(1e-9));
            REQUIRE(norm(world.velocity(fast)).value() <= 10.2); // the limit, and what gravity does in a step
        }
        CHECK(norm(world.velocity(fast)).value() >= 9);
    };
    with_each(limits, Limit<Place::end_of_step>{});
    with_each(limits, Limit<Place::after_integration>{});
    with_each(limits, LimitSystem<true>{});
    with_each(limits, LimitSystem<false>{});
}

TEST_CASE("who rolls does not fall asleep, and who lies does, whatever keeps its velocity", "[collision][rest]") {
    with_each(
        [](auto world) {
            using S = typename decltype(world)::S;
            world.add(Plane::ground(), fixed);
            const auto lies = world.add(Sphere{0.5 * metre}, at<S>(3, 0.5), mass(1.0 * kilogram));
            std::vector<Handle> roll;
            std::vector<double> speeds{0.06, 0.1, 0.19, 0.35, 1.0};
            for (std::size_t i = 0; i < speeds.size(); ++i)
                roll.push_back(world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 2.0 * double(i + 1))),
                                         going<S>(speeds[i]), mass(1.0 * kilogram)));
            run(world, 300, dt);
            using C = typename decltype(world)::composition;
            constexpr bool swings = C::template responses<Level::accelerations>::size > 0; // on the penalty's spring
            if (!swings) CHECK(world.motion(lies) == Motion::resting);
            for (std::size_t i = 0; i < speeds.size(); ++i) {
                INFO(speeds[i] << " m/s");
                CHECK(world.motion(roll[i]) == Motion::awake);
                CHECK(x_of(world, roll[i]) == Approx(300 * dt * speeds[i]).epsilon(1e-6));
            }
        },
        Rest{});
}
