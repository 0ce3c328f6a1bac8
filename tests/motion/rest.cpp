// SPDX-License-Identifier: BSL-1.0

// Rest: slow for long enough, and nothing pulls. (Islands, waking through contacts and support are tests/world's and
// chapter 2's.)

#include <ansatz/motion/rest.hpp>

#include "tests/motion/support.hpp"

using namespace motion_tests;

TEST_CASE("rest: a slow body sleeps after its time and not before, exactly at zero", "[motion][rest]") {
    for_each_type(AllIntegrators{}, []<class I> {
        World world{I{}, Rest{0.1 * metre_per_second, 0.5 * second}};
        const auto slow = world.add(velocity(metres_per_second(0.05, 0, 0))),
                   fast = world.add(velocity(metres_per_second(0.2, 0, 0)));
        run(world, 29, 1.0 / 60);
        CHECK(world.motion(slow) == Motion::awake);
        run(world, 1, 1.0 / 60);
        CHECK(world.motion(slow) == Motion::resting);
        CHECK(world.velocity(slow).value() == Eigen::Vector3d::Zero());
        CHECK(world.acceleration(slow).value() == Eigen::Vector3d::Zero());
        const auto where = world.position(slow);
        run(world, 100, 1.0 / 60);
        CHECK(world.position(slow).value() == where.value());
        CHECK(world.motion(fast) == Motion::awake);
    });
}

TEMPLATE_TEST_CASE("rest: what stands still sleeps, however small the threshold is", "[motion][rest]", float, double) {
    // Its square is no number of the scalar any more.
    const double least = double(std::numeric_limits<TestType>::min());
    World world{Space<TestType, 3>{}, SemiImplicitEuler{}, Rest{least * metre_per_second, 0.5 * second}};
    const auto still = world.add(), slow = world.add(velocity(metres_per_second(1e-3, 0, 0)));
    run(world, 30, 1.0 / 60);
    CHECK(world.motion(still) == Motion::resting);
    CHECK(world.motion(slow) == Motion::awake);
}

TEST_CASE("R9 rest: a thrown body never sleeps unsupported, on whatever moon", "[motion][R9][rest]") {
    for_each_type(Types<SemiImplicitEuler, Verlet>{}, []<class I> {
        for (const double g : {0.01, 0.1, 1.62, 9.81}) {
            World world{Space<float, 2>{}, I{}, Gravity{metres_per_second_squared(0, -g, 0)}, Rest{}};
            using S = Space<float, 2>;
            const auto thrown = world.add(going<S>(0, 0.1 * g)), released = world.add();
            bool slept = false;
            for (int i = 0; i < 600; ++i) {
                world.step(1.0 / 60 * second);
                slept = slept || world.motion(thrown) != Motion::awake || world.motion(released) != Motion::awake;
            }
            INFO("g = " << g << " m/s^2");
            CHECK_FALSE(slept);
        }
    });
}

TEST_CASE("rest: the speed must be low for the whole time, a faster moment begins it anew", "[motion][rest]") {
    World world{SemiImplicitEuler{}, Rest{0.1 * metre_per_second, 0.5 * second}};
    const auto body = world.add(velocity(metres_per_second(0.05, 0, 0)));
    run(world, 20, 1.0 / 60);
    world.set_velocity(body, metres_per_second(0.2, 0, 0));
    run(world, 1, 1.0 / 60);
    world.set_velocity(body, metres_per_second(0.05, 0, 0));
    run(world, 29, 1.0 / 60);
    CHECK(world.motion(body) == Motion::awake);
    run(world, 1, 1.0 / 60);
    CHECK(world.motion(body) == Motion::resting);
}

TEST_CASE("rest: the same time at every step, and none where the time is zero", "[motion][rest]") {
    for (const int rate : {10, 60, 240}) {
        World world{SemiImplicitEuler{}, Rest{0.1 * metre_per_second, 0.5 * second}};
        const auto body = world.add();
        int steps = 0;
        while (world.motion(body) == Motion::awake && steps < 1000) {
            world.step(1.0 / rate * second);
            ++steps;
        }
        INFO(rate << " Hz");
        CHECK(steps == rate / 2);
    }
    World at_once{SemiImplicitEuler{}, Rest{0.1 * metre_per_second, 0.0 * second}};
    const auto body = at_once.add(velocity(metres_per_second(0.05, 0, 0)));
    at_once.step(1.0 / 60 * second);
    CHECK(at_once.motion(body) == Motion::resting);
}

TEST_CASE("rest: what pulls at a resting body wakes it in the next step", "[motion][rest]") {
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, AppliedForces{}, Rest{}};
    const auto body = world.add(mass(2.0 * kilogram), resting);
    run(world, 10, 1.0 / 60);
    CHECK(world.motion(body) == Motion::resting);
    SECTION("a force") { world.apply_force(body, newtons(0, 1e-9, 0)); }
    SECTION("an impulse") { world.apply_impulse(body, newton_seconds(1e-9, 0, 0)); }
    SECTION("a velocity") { world.set_velocity(body, metres_per_second(0, 0, 1)); }
    SECTION("a position") { world.set_position(body, metres(0, 0, 1)); }
    SECTION("gravity") { world.set(Gravity{}); }
    run(world, 1, 1.0 / 60);
    CHECK(world.motion(body) == Motion::awake);
}

TEST_CASE("rest: a force that begins later wakes it when it begins", "[motion][rest]") {
    // Forcing is zero at first: cos(omega t) with an amplitude of 0, then set.
    World world{SemiImplicitEuler{}, Forcing{metres_per_second_squared(0, 0, 0), 1.0 / second}, Rest{}};
    const auto body = world.add(resting);
    run(world, 100, 1.0 / 60);
    CHECK(world.motion(body) == Motion::resting);
    world.set(Forcing{metres_per_second_squared(1, 0, 0), 1.0 / second});
    run(world, 1, 1.0 / 60);
    CHECK(world.motion(body) == Motion::awake);
}

TEST_CASE("rest refuses a threshold that nothing is below, a negative time, and a pull that is none",
          "[motion][rest]") {
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Rest{0.0 * metre_per_second, 0.5 * second}}), std::invalid_argument);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Rest{0.1 * metre_per_second, -0.5 * second}}), std::invalid_argument);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Rest{.pull = -1e-3 * metre_per_second_squared}}),
                    std::invalid_argument);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Rest{.pull = INFINITY * metre_per_second_squared}}),
                    std::invalid_argument);
}

TEST_CASE("rest: what remains of all that pulls may be as much as it says, and zero is nothing at all",
          "[motion][rest]") {
    const auto sleeps = [](double most, double g) {
        World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -g, 0)},
                    Rest{.pull = most * metre_per_second_squared}};
        const auto body = world.add();
        run(world, 30, 1.0 / 60);
        return world.motion(body) == Motion::resting;
    };
    CHECK(sleeps(1e-3, 0.999e-3));
    CHECK_FALSE(sleeps(1e-3, 1.001e-3));
    CHECK(sleeps(0, 0));
    CHECK_FALSE(sleeps(0, 1e-300));
}

TEST_CASE("rest: the order of the list means nothing, also among effects of one place", "[motion][rest]") {
    // Damping first, then what stops, then the test of the velocity that is left, however they are listed.
    const FrameDrag half{0.5};
    const StopBelow stop{0.03 * metre_per_second};
    const Rest rest{0.05 * metre_per_second, 0.0 * second};
    auto after_a_step = [](auto world, double speed) {
        const auto body = world.add(velocity(metres_per_second(speed, 0, 0)));
        world.step(0.01 * second);
        return std::pair(world.motion(body), world.velocity(body).value()[0]);
    };
    for (const double speed : {0.05, 0.08, 0.2}) {
        const auto expected = after_a_step(World{SemiImplicitEuler{}, half, stop, rest}, speed);
        CHECK((expected.first == Motion::resting) == (speed < 0.1));
        CHECK(after_a_step(World{SemiImplicitEuler{}, half, rest, stop}, speed) == expected);
        CHECK(after_a_step(World{SemiImplicitEuler{}, stop, half, rest}, speed) == expected);
        CHECK(after_a_step(World{SemiImplicitEuler{}, stop, rest, half}, speed) == expected);
        CHECK(after_a_step(World{rest, half, stop, SemiImplicitEuler{}}, speed) == expected);
        CHECK(after_a_step(World{rest, stop, half, SemiImplicitEuler{}}, speed) == expected);
    }
}
