// SPDX-License-Identifier: BSL-1.0
// What is woken within a step, by a hit or a pull, goes on as if it had never slept; and what is divided asleep.

#include "tests/collision/support.hpp"

#include <ansatz/collision/hit_sleepers.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/collision/substep_driver.hpp>
#include <ansatz/motion/attraction.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world/edited_elements.hpp>

#include <string_view>
#include <vector>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60;
constexpr double never = 1e6; // s, so long that no body falls asleep

/// Rows of balls on smooth ground, which sleep or do not, are hit by another one.
template <class S> void hit_in_a_row(int in_row, double gap, double speed, double e, double hitting) {
    for (const double slow_for : {0.5, never}) {
        auto world = world_of(S{}, SemiImplicitEuler{}, Gravity{}, Rest{0.05 * metre_per_second, slow_for * second},
                              SoftSubsteps<>{});
        world.add(Plane::ground(), fixed);
        std::vector<Handle> row;
        const auto add = [&](double x, double m, double v) {
            row.push_back(
                world.add(Sphere{0.1 * metre}, at<S>(x, 0.1), going<S>(v), mass(m * kilogram), restitution(e)));
        };
        for (int i = 0; i < in_row; ++i) add(i * (0.2 + gap), 1, 0);
        run(world, 60, dt);
        REQUIRE(world.count(Motion::resting) == (slow_for == never ? 0u : std::size_t(in_row)));
        add(-0.35, hitting, speed);
        run(world, 60, dt);
        double momentum = 0;
        for (const auto body : row) momentum += world.mass(body).value() * world.velocity(body).value()[0];
        INFO(in_row << " in a row, " << gap << " m apart, hit at " << speed << " m/s, e = " << e << ", by " << hitting
                    << " kg, slow for " << slow_for << " s");
        CHECK(momentum == Approx(hitting * speed).epsilon(1e-5));
    }
}
} // namespace

TEST_CASE("a sleeper that is struck into another one is not struck against a wall", "[collision][rest][R11]") {
    for (const int in_row : {1, 2, 3})
        for (const double gap : {0.0, 1e-4, 1e-3, 2e-3, 1e-2})
            for (double speed = 0.25; speed < 5; speed += 0.25) {
                hit_in_a_row<Space<double, 2>>(in_row, gap, speed, 1, 1);
                hit_in_a_row<Space<double, 2>>(in_row, gap, speed, 0, 1);
            }
    for (const double speed : {0.5, 1.0, 4.0}) {
        hit_in_a_row<Space<float, 3>>(2, 1e-4, speed, 1, 1);
        hit_in_a_row<Space<double, 3>>(3, 1e-3, speed, 1, 3);
        hit_in_a_row<Space<double, 3>>(3, 1e-3, speed, 0.5, 0.3);
    }
}

namespace {
/// A ball that sleeps before a wall, or does not, is hit by another one, which may be hit itself.
/// \return how far it comes, m; the middle of the wall is at 0.11 + gap
double shot_at_a_wall(double gap, double speed, double e, int in_row, double slow_for, bool separated) {
    using S = Space<double, 2>;
    auto world = world_of(S{}, SemiImplicitEuler{}, Gravity{}, Rest{0.05 * metre_per_second, slow_for * second},
                          SoftSubsteps<>{});
    world.add(Plane::ground(), fixed);
    world.add(Box{metres(0.01, 1)}, at<S>(0.11 + gap, 1), fixed);
    const auto add = [&](double x, double v) {
        return world.add(Sphere{0.1 * metre}, at<S>(x, 0.1), going<S>(v), mass(1.0 * kilogram), restitution(e));
    };
    std::vector<Handle> row;
    for (int i = 0; i < in_row; ++i) row.push_back(add(-i * (0.2 + (separated ? gap : 0)), 0));
    run(world, 60, dt);
    REQUIRE(world.count(Motion::resting) == (slow_for == never ? 0u : std::size_t(in_row)));
    add(-in_row * 0.21 - 0.1, speed);
    double farthest = -1e9;
    for (int i = 0; i < 30; ++i) {
        run(world, 1, dt);
        farthest = std::max(farthest, world.position(row[0]).value()[0]);
    }
    return farthest;
}
} // namespace

TEST_CASE("a sleeper that is shot at a thin wall does not pass it", "[collision][rest][R11][C18]") {
    for (const double slow_for : {0.5, never})
        for (const int in_row : {1, 3})
            for (const double gap : {1e-4, 1e-3, 2e-3})
                for (const double e : {0.0, 0.5, 1.0})
                    for (const double speed : {5.0, 22.0, 40.0, 70.0}) {
                        INFO(in_row << " in a row, " << gap << " m before it, hit at " << speed << " m/s, e = " << e
                                    << ", slow for " << slow_for << " s");
                        CHECK(shot_at_a_wall(gap, speed, e, in_row, slow_for, false) <= 0.11 + gap);
                        if (in_row > 1) CHECK(shot_at_a_wall(gap, speed, e, in_row, slow_for, true) <= 0.11 + gap);
                    }
}

TEST_CASE("a body that was added asleep is hit in that step as if it were awake", "[collision][rest][R11]") {
    using S = Space<>;
    const auto height = [](double y, bool asleep) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, Rest{}, SoftSubsteps<>{});
        world.add(Box{metres(2, 0.5, 2)}, at<S>(0, -0.5), fixed);
        const auto ball = asleep ? world.add(Sphere{0.5 * metre}, at<S>(0, y), mass(1.0 * kilogram), resting)
                                 : world.add(Sphere{0.5 * metre}, at<S>(0, y), mass(1.0 * kilogram));
        world.add(Sphere{0.5 * metre}, at<S>(0, 1.02 + y), velocity(metres_per_second(0, -6, 0)), mass(1.0 * kilogram));
        world.step(dt * second);
        REQUIRE(world.motion(ball) == Motion::awake);
        return height_of(world, ball);
    };
    for (const double y : {0.5, 0.499, 0.501}) {
        CHECK(height(y, true) == height(y, false));
        CHECK(height(y, true) >= 0.49);
    }
}

TEST_CASE("what is woken by a pull within a step is held by its contacts in it", "[collision][rest][R11]") {
    for (const double slow_for : {0.5, never})
        for (const double hz : {60.0, 20.0}) {
            using S = Space<>;
            auto world =
                world_of(SemiImplicitEuler{}, Gravity{}, Rest{0.05 * metre_per_second, slow_for * second},
                         SoftSubsteps<>{}, Attraction{Quantity<unit::GravitationalConstant>::from_value(1e-3)});
            world.add(Plane::ground(), fixed);
            const auto ball = world.add(Sphere{0.5 * metre}, at<S>(0, 0.5), mass(1.0 * kilogram));
            const auto far = world.add(Sphere{0.5 * metre}, at<S>(30, 0.5), mass(1.0 * kilogram));
            run(world, int(5 * hz), 1 / hz);
            REQUIRE((world.motion(ball) == Motion::resting) == (slow_for != never));
            const double before = height_of(world, ball);
            world.set_velocity(far, metres_per_second(1, 0, 0));
            world.step(1 / hz * second);
            REQUIRE(world.motion(ball) == Motion::awake);
            INFO(hz << " Hz, slow for " << slow_for << " s");
            CHECK(std::abs(world.velocity(ball).value()[1]) <= 1e-3);
            CHECK(std::abs(height_of(world, ball) - before) <= 1e-6);
        }
}

namespace {
/// Divides the body of id 1 in the step with this number.
struct Division_ {
    using role = roles::System;
    static constexpr std::string_view name = "Division_";
    int in_step = 200;
    template <class S> struct State {
        int steps = 0;
        static void fields(auto& self, auto&& field) { field("steps", self.steps); }
        std::size_t bodies_to_come(const Division_&) const { return 1; }
    };
    template <class S> struct Divide {
        static constexpr Phase phase = between(phases::breaking, phases::sums);
        static constexpr std::string_view name = "division";
        int in_step;
        explicit Divide(const Division_& division) : in_step(division.in_step) {}
        void run(auto& view, const auto&) const {
            if (++view.state().steps == in_step) view.divide(1, typename S::Scalar(0.25));
        }
    };
    template <class S> using systems = Types<Divide<S>>;
};
} // namespace

TEST_CASE("both halves of a sleeper that is divided lie on what it lay on, and fall when that goes",
          "[collision][rest][division]") {
    for (const bool remove : {false, true}) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, Rest{}, SoftSubsteps<>{}, Division_{});
        using S = Space<>;
        const auto table = world.add(Box{metres(2, 0.5, 2)}, at<S>(0, -0.5), fixed);
        world.add(Sphere{0.5 * metre}, at<S>(0, 0.5), mass(1.0 * kilogram));
        world.add(Sphere{0.5 * metre}, at<S>(1.5, 0.5), mass(1.0 * kilogram));
        run(world, 205, dt);
        REQUIRE(world.size() == 4);
        REQUIRE(world.count(Motion::resting) == 3);
        CHECK(world.contacts().size() == 3);
        if (remove) world.remove(table);
        else world.set_position(table, metres(0, -3, 0));
        run(world, 30, dt);
        for (const auto body : world.handles())
            if (world.motion(body) != Motion::fixed) CHECK(height_of(world, body) < 0);
    }
}
