// SPDX-License-Identifier: BSL-1.0
// Springs and ropes as forces of a world: every integrator, every space, and the laws that hold for all of them.

#include <ansatz/springs/springs.hpp>

#include "tests/springs/support.hpp"

using namespace spring_tests;

namespace {

/// Three bodies of unequal mass in a triangle of unequal springs, one end at a point; nothing is symmetric.
template <class I, class S, class... More> auto triangle(More... more) {
    World world{I{}, S{}, Springs{}, more...};
    const auto a = world.add(at<S>(0, 0), going<S>(0.3, -0.2), mass(1.0 * kilogram));
    const auto b = world.add(at<S>(1, 0.2), going<S>(-0.1, 0.4), mass(2.0 * kilogram));
    const auto c = world.add(at<S>(0.4, 0.9), going<S>(0.2, 0.1), mass(0.5 * kilogram));
    world.add(Spring{a, b, 30.0 * N_per_m, 0.2 * N_s_per_m, 0.8 * metre});
    world.add(Spring{b, c, 20.0 * N_per_m, 0.1 * N_s_per_m, 1.1 * metre});
    world.add(Spring{c, a, 50.0 * N_per_m, 0.3 * N_s_per_m, 1.0 * metre});
    return world;
}
template <class World_> std::array<double, 6> last_state(const World_& world) {
    return state(world, world.handles().back());
}

} // namespace

TEST_CASE("every integrator takes springs, and has its order with them, damped and free", "[springs][slow]") {
    auto reference = triangle<OdeintFehlberg78, Space<>>();
    run(reference, 4096, 2.0 / 4096);
    const auto truth = last_state(reference);
    for_each_type(AllIntegrators{}, [&]<class I>() {
        if constexpr (!std::same_as<I, OdeintFehlberg78>) {
            const double order = std::same_as<I, OdeintRungeKutta4> ? 4 : I::order;
            check_order(order, 0.1, order == 4 ? 64 : 512, 4, [&](int steps) {
                auto world = triangle<I, Space<>>();
                run(world, steps, 2.0 / steps);
                CHECK(world.status().ok());
                return distance(last_state(world), truth);
            });
        }
    });
}

TEST_CASE("momentum and angular momentum stay, with every integrator and in every space", "[springs]") {
    for_each_type(AllSpaces{}, [&]<class S>() {
        for_each_type(
            Types<ExplicitEuler, SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4, OdeintRungeKutta4,
                  ImplicitEuler>{},
            [&]<class I>() {
                auto world = triangle<I, S>();
                const auto before = total_momentum(world);
                const double rounding = std::is_same_v<typename S::Scalar, float> ? 1e-7 : 1e-16;
                run(world, 200, 0.005);
                // Verlet's velocity is the difference of two positions: their rounding over the step.
                const double factor = std::same_as<I, Verlet> ? 200 * 100 : std::same_as<I, ImplicitEuler> ? 1e6 : 200;
                CHECK(norm(total_momentum(world) - before).value() <= factor * 10 * rounding);
            });
    });
}

TEST_CASE("an undamped spring keeps its energy as the method does, a damped one loses it in every step", "[springs]") {
    World free{VelocityVerlet{}, Springs<Undamped>{}};
    const auto body = free.add(position(metres(1.5, 0, 0)), mass(1.0 * kilogram));
    free.add(Spring{body, metres(0, 0, 0), 100.0 * N_per_m, {}, 1.0 * metre});
    const double start = total_energy(free).value();
    CHECK(start == Approx(12.5));
    for (int i = 0; i < 10000; ++i) {
        free.step(0.001 * second);
        REQUIRE(std::abs(total_energy(free).value() / start - 1) <= 1e-2 * 0.25); // (omega dt)^2 / 4, and no drift
    }
    auto damped = triangle<RungeKutta4, Space<>>();
    double last = total_energy(damped).value();
    for (int i = 0; i < 1000; ++i) {
        damped.step(0.002 * second);
        const double now = total_energy(damped).value();
        REQUIRE(now <= last * (1 + 1e-12));
        last = now;
    }
}

TEST_CASE("a world with springs of no stiffness moves like one without any, to the bit (hard case N1)", "[springs]") {
    for_each_type(Types<ExplicitEuler, SemiImplicitEuler, VelocityVerlet, RungeKutta4>{}, [&]<class I>() {
        World with{I{}, Gravity{}, Springs{}};
        World without{I{}, Gravity{}, Keep<InverseMass>{}};
        const auto a = with.add(position(metres(1, 2, 3)), velocity(metres_per_second(3, 2, 1)), mass(0.3 * kilogram));
        const auto b =
            without.add(position(metres(1, 2, 3)), velocity(metres_per_second(3, 2, 1)), mass(0.3 * kilogram));
        with.add(Spring{a, metres(0, 0, 0), 0.0 * N_per_m});
        for (int i = 0; i < 500; ++i) {
            with.step(1.0 / 60 * second);
            without.step(1.0 / 60 * second);
        }
        CHECK(with.position(a) == without.position(b));
        CHECK(with.velocity(a) == without.velocity(b));
    });
}

TEST_CASE("fixed ends stay, moving ends pull, and a spring between two of them does nothing", "[springs]") {
    for_each_type(AllIntegrators{}, [&]<class I>() {
        World world{I{}, Springs{}};
        const auto post = world.add(position(metres(0, 0, 0)), fixed);
        const auto winch = world.add(position(metres(2, 0, 0)), velocity(metres_per_second(0.5, 0, 0)), moving);
        const auto load = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
        world.add(Spring{post, load, 100.0 * N_per_m, 20.0 * N_s_per_m, 1.0 * metre});
        world.add(Spring{winch, load, 100.0 * N_per_m, 20.0 * N_s_per_m, 1.0 * metre});
        world.add(Spring{post, winch, 1e9 * N_per_m});
        run(world, 500, 0.004);
        CHECK(world.position(post) == metres(0, 0, 0));
        CHECK(x(world.position(winch)).value() == Approx(3.0).epsilon(1e-12));
        // Half of the winch's way and speed; the steady state lags by nothing, because both dampers see the same.
        CHECK(x(world.velocity(load)).value() == Approx(0.25).epsilon(1e-3));
        CHECK(world.status().ok());
    });
}

TEST_CASE("a platform within a step: stages see it where it is at their time, so that RungeKutta4 keeps its order",
          "[springs]") {
    auto pulled = [](int steps) {
        World world{RungeKutta4{}, Springs{}};
        const auto winch = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(2, 0, 0)), moving);
        const auto load = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
        world.add(Spring{winch, load, 40.0 * N_per_m, 0.0 * N_s_per_m, 1.0 * metre});
        run(world, steps, 1.0 / steps);
        const double omega = std::sqrt(40.0); // the load swings about the winch: x = 2 t - 2 sin(omega t) / omega
        return std::abs(x(world.position(load)).value() - (2 - 2 * std::sin(omega) / omega));
    };
    check_order(4, 0.05, 64, 4, pulled);
}

TEST_CASE("a resting end wakes when a spring pulls at it, not when it hangs slack", "[springs]") {
    World world{SemiImplicitEuler{}, Ropes{}, Rest{}};
    const auto ball = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram), resting);
    const auto kite = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    world.add(Rope{.first = ball, .second = kite, .stiffness = 100.0 * N_per_m, .rest_length = 1.5 * metre});
    CHECK(world.motion(ball) == Motion::awake); // something new holds it
    run(world, 100, 0.01);
    World again{SemiImplicitEuler{}, Ropes{}, Rest{0.05 * metre_per_second, 0.05 * second}};
    const auto a = again.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto b = again.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto rope =
        again.add(Rope{.first = a, .second = b, .stiffness = 100.0 * N_per_m, .rest_length = 1.5 * metre});
    run(again, 40, 0.01);
    CHECK(again.motion(a) == Motion::resting); // the rope is slack for half a second
    run(again, 15, 0.01);
    CHECK(again.motion(a) == Motion::awake);
    CHECK(x(again.velocity(a)).value() > 0);
    run(again, 1000, 0.01);
    again.remove(rope);
    CHECK(again.motion(a) == Motion::awake);
}

TEST_CASE("sums do not depend on which bodies slept, were removed or stand where: springs are summed by id",
          "[springs]") {
    auto build = [](bool disturbed) {
        World world{SemiImplicitEuler{}, Springs{}};
        std::vector<Handle> b;
        Handle guest;
        for (int i = 0; i < 6; ++i)
            b.push_back(world.add(position(metres(0.1 * i * i, 0.3 * i, 0)), mass((1.0 + i) * kilogram)));
        for (int i = 0; i < 5; ++i)
            world.add(Spring{b[std::size_t(i)], b[std::size_t(i) + 1], 100.0 * N_per_m, 1.0 * N_s_per_m, 0.2 * metre});
        if (disturbed) { // slots change: the fixed ones stand behind, and a removed one is replaced by the last
            guest = world.add(position(metres(50, 0, 0)), fixed);
            world.remove(guest);
        }
        run(world, 200, 0.002);
        return world.position(b[3]);
    };
    CHECK(build(false) == build(true));
}

TEST_CASE("springs are deterministic: two runs, and a copy, have equal bits", "[springs]") {
    for_each_type(AllIntegrators{}, [&]<class I>() {
        auto one = triangle<I, Space<float, 3>>(Gravity{});
        auto two = triangle<I, Space<float, 3>>(Gravity{});
        run(one, 100, 0.005);
        run(two, 50, 0.005);
        auto three = two;
        run(three, 50, 0.005);
        CHECK(one.hash() == three.hash());
    });
}
