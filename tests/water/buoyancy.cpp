// SPDX-License-Identifier: BSL-1.0
// What water does to bodies: Archimedes against its closed forms, and what the notes propose beside it. Rows B of the
// hard cases.
// Runs long with the sanitizers.

#include <ansatz/springs/step_limit.hpp>

#include "tests/measured.hpp"
#include "tests/water/body_in_pool.hpp"

using namespace water_tests;

namespace {

/// The mean of many periods, from where the height crosses the balance upwards.
double period(BodyInPool& one, double balance, double dt, int periods) {
    double first = 0, last = 0, before = one.y() - balance;
    int crossings = 0;
    for (int n = 1; crossings <= periods; ++n) {
        one.steps(1, dt);
        const double now = one.y() - balance;
        if (before < 0 && now >= 0) {
            const double at = dt * (n - 1 + before / (before - now));
            if (crossings++ == 0) first = at;
            last = at;
        }
        before = now;
    }
    return (last - first) / periods;
}

} // namespace

TEST_CASE("a cube of 600 kg/m^3 settles 0.6 m deep (hard case B1)", "[water]") {
    for (const bool presses : {false, true}) {
        auto by = only(cube, 3);
        by.presses = presses;
        BodyInPool one(pond(), 2, by, 600, 5.1, 2.3, 4.9);
        one.steps(60 * 60, 1.0 / 60);
        CHECK(test::measured("B1", "draft", one.level() - (one.y() - 0.5), test::about(0.6, 1e-6), "m"));
        CHECK(one.now().submerged.value() == Approx(0.6).margin(1e-6));
        CHECK(one.now().centre.value() == Approx(one.level() - 0.3).margin(1e-6));
    }
}
TEST_CASE("a cube bobs with the period of semi-implicit Euler, second order in the step (hard case B2)", "[water]") {
    const double exact = 2 * pi * std::sqrt(0.6 / g);
    CHECK(exact == Approx(1.553893).epsilon(1e-6));
    for (const double rate : {30.0, 60.0, 120.0}) {
        BodyInPool one(pond(), 2, only(cube), 600, 5, 1.9 + 0.05, 5);
        const double omega_h = 2 * pi / exact / rate;
        const double error = period(one, 1.9, 1 / rate, 60) / exact - 1;
        CAPTURE(rate, error);
        CHECK(test::measured("B2", "error of the period at " + std::to_string(int(rate)) + " Hz", error,
                             test::about(-omega_h * omega_h / 24, rate > 100 ? 2e-6 : 2e-5)));
    }
}
TEST_CASE("a sphere half under water bobs with 3g/2R (hard case B4)", "[water]") {
    BodyInPool one(pond(), 2, only(ball), 0.5 * 1000 * ball_volume, 5, 2 + 0.001, 5);
    const double exact = 2 * pi / std::sqrt(3 * g / (2 * 0.5)), h = 1.0 / 960;
    CHECK(exact == Approx(1.158203).epsilon(1e-6));
    const double found = period(one, 2, h, 40);
    CHECK(test::measured("B4", "period", found, test::about(exact, 1e-3 * exact), "s"));
    const double omega_h = 2 * pi / exact * h;
    CHECK(found / exact - 1 == Approx(-omega_h * omega_h / 24).margin(2e-6)); // and that of an amplitude of 1 mm
}
TEST_CASE("under water (rho_w/rho - 1) g, dry -g, and no step between (hard case B5)", "[water]") {
    for (const auto& by : {only(ball), only(cube)}) {
        const double volume = by.by.index() == 0 ? ball_volume : 1.0, kilograms = 350;
        BodyInPool one(pond(), 5, by, kilograms, 5, 2, 5);
        auto a = [&](double y) {
            one.world.set_position(one.body, metres(5, y, 5));
            return one.world.acceleration(one.body).value();
        };
        const double deep = (1000 * volume / kilograms - 1) * g;
        CHECK(a(2)[1] == Approx(deep).epsilon(1e-14));
        CHECK(a(-3)[1] == Approx(deep).epsilon(1e-14));
        CHECK(a(5.5)[1] == -g);
        CHECK(a(7)[1] == -g);
        CHECK(a(2)[0] == 0);
        CHECK(a(5)[2] == 0);
        double before = a(4.4)[1];
        for (double y = 4.4; y < 5.6; y += 1e-3) {
            const double now = a(y)[1];
            REQUIRE(std::abs(now - before) < 1e-3 * 1000 * g / kilograms * 1.01); // rho g A dy / m
            REQUIRE(now <= before + 1e-12);
            before = now;
        }
    }
}
TEST_CASE("released deep, it leaps no higher than its energy, and no faster than its drag lets it (hard case B7)",
          "[water]") {
    const ColumnGrid grid(10, 10, 1.0 * metre);
    const double kilograms = 50 * ball_volume, weight = kilograms * g, push = 1000 * g * ball_volume;
    BodyInPool free(grid, 12, only(ball), kilograms, 5, 2, 5);
    double highest = 0;
    for (int i = 0; i < 10 * 240; ++i) {
        free.steps(1, 1.0 / 240);
        highest = std::max(highest, free.y());
    }
    // From 2 m to 11.5 m all of it is pushed; the rest of the way on the mean half of it.
    const double bound = 2 + push * (9.5 + 0.5) / weight;
    CHECK(highest < bound * 1.01); // a step of semi-implicit Euler more or less
    CHECK(highest > bound * 0.97);
    const double terminal = std::sqrt(2 * (push - weight) / (1000 * 0.47 * pi * 0.25));
    for (const double rate : {60.0, 120.0, 240.0}) {
        BodyInPool slowed(grid, 12, only(ball, 0, 0.47), kilograms, 5, 2, 5);
        double fastest = 0, deep = 0;
        for (int i = 0; i < int(4 * rate); ++i) {
            slowed.steps(1, 1 / rate);
            fastest = std::max(fastest, std::abs(slowed.v()));
            if (slowed.y() < 11.4) deep = slowed.v();
        }
        // At 60 Hz a step takes more than the difference to the terminal speed, and passes it by 0.25 %.
        CHECK(fastest <= terminal * (rate > 60 ? 1 + 1e-9 : 1.003));
        CHECK(deep == Approx(terminal).epsilon(1e-3));
        CHECK(slowed.y() < 13);
    }
    // A light ball that is shot into the water with more than its drag can take in a step stops; it does not bounce.
    BodyInPool shot(grid, 12, only(ball, 0, 0.47), 5, 5, 11, 5);
    shot.world.set_velocity(shot.body, metres_per_second(0, -200, 0));
    shot.steps(1, 1.0 / 60);
    CHECK(shot.v() < push / 5 / 60 + 1);
}
TEST_CASE("where a ball floats depends on neither the step nor the columns", "[water]") {
    std::vector<double> heights;
    for (const auto& [cell, rate] : {std::pair{0.125, 60}, {0.25, 60}, {0.5, 60}, {0.25, 30}, {0.25, 240}}) {
        const auto n = std::size_t(10 / cell + 0.5);
        BodyInPool one(ColumnGrid(n, n, cell * metre), 2, pressing(ball, 1), 200, 5, 2.3, 5);
        one.steps(rate, 1.0 / rate); // in the midst of its way
        heights.push_back(one.y());
    }
    CAPTURE(heights);
    // Of a way of 0.6 m: 0.2 mm between 30 and 240 Hz, 4.2 cm between columns of 1/8 m and of 1/2 m, a radius of the
    // ball.
    for (const std::size_t other : {3, 4}) CHECK(std::abs(heights[other] - heights[1]) < 5e-4);
    CHECK(std::abs(heights[2] - heights[0]) < 0.05);
}
TEST_CASE("the push stands on the surface: a body slides down a slope and flat water does not move it", "[water]") {
    Surface tilted{calm, pond(), 2.0 * metre};
    set_heights(tilted, [](double x, double z) { return 2 + 0.02 * (x - 5) - 0.01 * (z - 5); });
    Lake world{{}, {}, {}, {}};
    world.add(Pool{tilted});
    const auto body = world.add(position(metres(5, 1.9, 5)), mass(300.0 * kilogram));
    auto by = only(ball);
    by.body = body;
    const auto f = world.afloat(world.add(by)).lift.value();
    CHECK(f[0] / f[1] == Approx(-0.02).epsilon(1e-9));
    CHECK(f[2] / f[1] == Approx(0.01).epsilon(1e-9));
}
TEST_CASE("fixed acceleration: a denser body is slowed, a lighter one turned round (notes 7.4)", "[water]") {
    auto falls = [](double up, double y, double v) {
        BodyInPool one(pond(), 5, only(FixedLift{up * metre_per_second_squared}), 10, 5, y, 5);
        one.world.set_velocity(one.body, metres_per_second(0, v, 0));
        one.steps(30, 1.0 / 60);
        return one;
    };
    CHECK(falls(4, 4, -2).v() == Approx(-2 - (g - 4) * 0.5).epsilon(1e-12));
    CHECK(falls(15, 4, -2).v() == Approx(-2 + (15 - g) * 0.5).epsilon(1e-12));
    CHECK(falls(15, 9, 0).v() == Approx(-g * 0.5).epsilon(1e-12)); // above the water
    // What carries it presses the water up: 10 kg that have 4 m/s^2 of it, 4.08 litres.
    BodyInPool one(pond(), 5, pressing(FixedLift{4.0 * metre_per_second_squared}), 10, 5, 4, 5);
    one.steps(2, 1.0 / 60);
    CHECK(one.world.water(one.pool).displaced().value() == Approx(10 * 4 / (1000 * g)).epsilon(1e-12));
}
TEST_CASE("a spring holds a body to the surface, breaks when it is too deep, and frees the water (notes 7.4)",
          "[water]") {
    const SurfaceSpring spring{200.0 * newton_per_metre, 20.0 * newton_second_per_metre, 0.6 * metre};
    BodyInPool one(pond(), 5, pressing(spring), 10, 5, 4.6, 5);
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.level() - one.y() == Approx(10 * g / 200).epsilon(1e-4)); // 0.49 m
    CHECK(one.level() - 5 == Approx(10.0 / 1000 / 100).epsilon(1e-2));
    CHECK(one.world.water(one.pool).displaced().value() == Approx(0.01).epsilon(1e-3));
    CHECK_FALSE(one.now().broken);
    one.world.set_mass(one.body, 15.0 * kilogram); // 0.74 m deep, were it to hold
    one.steps(60, 1.0 / 60);
    CHECK(one.now().broken);
    CHECK(one.world.water(one.pool).displaced().value() == 0);
    CHECK(one.world.acceleration(one.body).value()[1] == -g);
    CHECK(one.world.get(one.floating).body == one.body);
    one.world.set_position(one.body, metres(5, 4.9, 5)); // for good
    CHECK(one.world.acceleration(one.body).value()[1] == -g);
    CHECK(one.world.water(one.pool).volume().value() == Approx(500).epsilon(1e-12));
}
TEST_CASE("the Jacobian is how the force changes", "[water]") {
    for (const double kilograms : {300.0, 600.0}) {
        const auto by = kilograms == 300 ? only(ball, 0.7) : only(cube, 0.7);
        BodyInPool one(pond(), 2, by, kilograms, 5, 2.1, 5);
        one.world.step(1e-9 * second);
        auto force = [&](double y, double v) {
            one.world.set_position(one.body, metres(5, y, 5));
            one.world.set_velocity(one.body, metres_per_second(0, v, 0));
            return kilograms * one.world.acceleration(one.body).value()[1];
        };
        const double h = 1e-5;
        const double by_y = (force(2.1 + h, 0) - force(2.1 - h, 0)) / (2 * h);
        const double by_v = (force(2.1, h) - force(2.1, -h)) / (2 * h);
        one.world.set_position(one.body, metres(5, 2.1, 5));
        one.world.set_velocity(one.body, metres_per_second(0, 0, 0));
        const detail::Bound<Buoyancy, Space<>> law{Buoyancy{}};
        law.jacobian(one.world.view<Buoyancy>(), one.world.context(),
                     [&](std::size_t, std::size_t, const auto& position, const auto& velocity) {
                         CHECK(position(1, 1) == Approx(by_y).epsilon(1e-6));
                         CHECK(velocity(1, 1) == Approx(by_v).epsilon(1e-6));
                         CHECK(position(0, 0) == 0);
                     });
        law.stiffnesses(one.world.view<Buoyancy>(), [&](std::size_t, std::size_t, double k, double c) {
            // The most at any depth: a cube is as stiff at each, a ball where it is widest.
            CHECK(k == Approx(kilograms == 300 ? 1000 * g * pi * 0.25 : -by_y).epsilon(1e-6));
            CHECK(k * (1 + 1e-6) >= -by_y);
            CHECK(c == Approx(-by_v).epsilon(1e-6));
        });
    }
}

namespace {

/// How high a ball of 15 cm comes that is dropped into a pool, above where it began; m.
template <class... P> double leaps(double kilograms, double dt, const P&... policy) {
    World world{policy..., Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{3.0 * mps}, pond(), 2.0 * metre}});
    const auto light = world.add(position(metres(5, 2.5, 5)), mass(kilograms * kilogram));
    world.add(Floating{light, Sphere{0.15 * metre}});
    double highest = 0;
    for (double t = 0; t < 10; t += dt) {
        world.step(dt * second);
        highest = std::max(highest, world.position(light).value()[1]);
    }
    return highest - 2.5;
}

} // namespace

TEST_CASE("the longest step of what floats is known before it is wet: sqrt(m / (rho g A))", "[water]") {
    for (const double kilograms : {0.01, 1.0}) {
        Lake world{{}, {}, {}, {}};
        CHECK(std::isinf(stable_step(world).value()));
        world.add(Pool{Surface{calm, pond(), 2.0 * metre}});
        const auto body = world.add(position(metres(5, 4, 5)), mass(kilograms * kilogram));
        auto by = only(Sphere{0.15 * metre});
        by.body = body;
        const auto floating = world.add(by);
        const auto limit = [&](double area) { return 2 * std::sqrt(kilograms / (1000 * g * area)); };
        CHECK(stable_step(world).value() == Approx(limit(pi * 0.15 * 0.15)).epsilon(1e-3));
        auto box = only(Box{metres(0.2, 0.1, 0.3)});
        box.body = body;
        world.set(floating, box);
        CHECK(stable_step(world).value() == Approx(limit(0.4 * 0.6)).epsilon(1e-3));
        auto spring = only(SurfaceSpring{500.0 * newton_per_metre, {}, 1.0 * metre});
        spring.body = body;
        world.set(floating, spring);
        CHECK(stable_step(world).value() == Approx(2 * std::sqrt(kilograms / 500)).epsilon(1e-3));
        world.set_position(body, metres(50, 4, 5)); // there is no water
        CHECK(std::isinf(stable_step(world).value()));
    }
}

TEST_CASE("a light ball gets no energy from the water in a step that is stable, and StepLimit takes no longer one",
          "[water]") {
    for (const double kilograms : {0.01, 0.1, 1.0}) {
        const double limit = 2 * std::sqrt(kilograms / (1000 * g * pi * 0.15 * 0.15));
        if (0.5 * limit < 0.04) CHECK(leaps(kilograms, 0.5 * limit, SemiImplicitEuler{}) < 0.02);
        CHECK(leaps(kilograms, 1.0 / 60, SemiImplicitEuler{}, StepLimit<Divide>{.part = 0.5}) < 0.02);
        CHECK(leaps(kilograms, 1.0 / 60, Verlet{}, StepLimit<Divide>{.part = 0.5}) < 0.02);
    }
    CHECK(leaps(0.01, 1.0 / 60, SemiImplicitEuler{}) > 50); // without it
}
