// SPDX-License-Identifier: BSL-1.0
// Bodies in water: Archimedes against its closed forms, water that is pressed up and comes back, and what the notes
// propose beside it. Rows B of the hard cases.
// Runs long with the sanitizers.

#include <ansatz/water.hpp>
#include <ansatz/water/bodies_in_water.hpp>
#include <ansatz/water/buoyancy.hpp>
#include <ansatz/water/floating.hpp>
#include <ansatz/world.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {

constexpr double g = 9.81;
using Lake = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Buoyancy>;
const WaterColumns calm{3.0 * mps, 0.5 / second};

/// A body in a pool.
struct Afloat_ {
    Lake world{{}, {}, {}, {}};
    PoolHandle<WaterColumns> pool;
    Handle body;
    FloatingHandle floating;

    Afloat_(const ColumnGrid& grid, double level, Floating by, double kilograms, double x, double y, double z,
            const WaterColumns& policy = calm) {
        pool = world.add(Pool{Surface{policy, grid, level * metre}});
        body = world.add(position(metres(x, y, z)), mass(kilograms * kilogram));
        by.body = body;
        floating = world.add(by);
    }
    void steps(int n, double dt) {
        for (int i = 0; i < n; ++i) world.step(dt * second);
    }
    double y() const { return world.position(body).value()[1]; }
    double v() const { return world.velocity(body).value()[1]; }
    auto now() const { return world.afloat(floating); }
    double level() const { return now().level.value(); }
};
ColumnGrid pond() { return ColumnGrid(20, 20, 0.5 * metre); } // 10 m x 10 m
Floating only(const std::variant<Sphere, Box, FixedLift, SurfaceSpring>& by, double damping = 0, double drag = 0) {
    return {{}, by, drag, damping / second, false};
}
Floating pressing(const std::variant<Sphere, Box, FixedLift, SurfaceSpring>& by, double damping = 2) {
    return {{}, by, 0, damping / second, true};
}
const Box cube{metres(0.5, 0.5, 0.5)};
const Sphere ball{0.5 * metre};
constexpr double ball_volume = 4.0 / 3 * pi * 0.125;

/// The mean of many periods, from where the height crosses the balance upwards.
double period(Afloat_& one, double balance, double dt, int periods) {
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
        Afloat_ one(pond(), 2, by, 600, 5.1, 2.3, 4.9);
        one.steps(60 * 60, 1.0 / 60);
        CHECK(one.level() - (one.y() - 0.5) == Approx(0.6).margin(1e-6));
        CHECK(one.now().submerged.value() == Approx(0.6).margin(1e-6));
        CHECK(one.now().centre.value() == Approx(one.level() - 0.3).margin(1e-6));
    }
}
TEST_CASE("a cube bobs with the period of semi-implicit Euler, second order in the step (hard case B2)", "[water]") {
    const double exact = 2 * pi * std::sqrt(0.6 / g);
    CHECK(exact == Approx(1.553893).epsilon(1e-6));
    for (const double rate : {30.0, 60.0, 120.0}) {
        Afloat_ one(pond(), 2, only(cube), 600, 5, 1.9 + 0.05, 5);
        const double omega_h = 2 * pi / exact / rate;
        const double error = period(one, 1.9, 1 / rate, 60) / exact - 1;
        CAPTURE(rate, error);
        CHECK(error == Approx(-omega_h * omega_h / 24).margin(rate > 100 ? 2e-6 : 2e-5));
    }
}
TEST_CASE("a sphere half under water bobs with 3g/2R (hard case B4)", "[water]") {
    Afloat_ one(pond(), 2, only(ball), 0.5 * 1000 * ball_volume, 5, 2 + 0.001, 5);
    const double exact = 2 * pi / std::sqrt(3 * g / (2 * 0.5)), h = 1.0 / 960;
    CHECK(exact == Approx(1.158203).epsilon(1e-6));
    const double found = period(one, 2, h, 40);
    CHECK(found == Approx(exact).epsilon(1e-3));
    const double omega_h = 2 * pi / exact * h;
    CHECK(found / exact - 1 == Approx(-omega_h * omega_h / 24).margin(2e-6)); // and that of an amplitude of 1 mm
}
TEST_CASE("under water (rho_w/rho - 1) g, dry -g, and no step between (hard case B5)", "[water]") {
    for (const auto& by : {only(ball), only(cube)}) {
        const double volume = by.by.index() == 0 ? ball_volume : 1.0, kilograms = 350;
        Afloat_ one(pond(), 5, by, kilograms, 5, 2, 5);
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
    Afloat_ free(grid, 12, only(ball), kilograms, 5, 2, 5);
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
        Afloat_ slowed(grid, 12, only(ball, 0, 0.47), kilograms, 5, 2, 5);
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
    Afloat_ shot(grid, 12, only(ball, 0, 0.47), 5, 5, 11, 5);
    shot.world.set_velocity(shot.body, metres_per_second(0, -200, 0));
    shot.steps(1, 1.0 / 60);
    CHECK(shot.v() < push / 5 / 60 + 1);
}
TEST_CASE("400 kg raise a pool of 100 m^2 by 4 mm, and no water is lost (hard case B9)", "[water]") {
    for (const double cell : {0.1, 0.25, 0.5, 1.0}) {
        CAPTURE(cell);
        const auto n = std::size_t(10 / cell + 0.5);
        Afloat_ one(ColumnGrid(n, n, cell * metre), 2, pressing(ball), 400, 5.03, 2.2, 4.98);
        double farthest = 0;
        for (int i = 0; i < 60 * 60; ++i) {
            one.steps(1, 1.0 / 60);
            farthest = std::max(farthest, std::abs(one.world.water(one.pool).volume().value() - 200));
        }
        CHECK(farthest < 1e-12 * 200);
        CHECK(one.level() - 2 == Approx(0.004).epsilon(1e-3));
        CHECK(one.world.water(one.pool).level(1.0 * metre, 9.0 * metre).value() - 2 == Approx(0.004).epsilon(1e-3));
        CHECK(std::abs(one.v()) < 1e-5);
        CHECK(one.now().submerged.value() == Approx(0.4).epsilon(1e-5));
        one.world.remove(one.body); // taken out, the water comes back
        one.steps(60 * 30, 1.0 / 60);
        CHECK(one.world.water(one.pool).level(5.0 * metre, 5.0 * metre).value() == Approx(2).margin(1e-5));
        CHECK(one.world.water(one.pool).displaced().value() == 0);
    }
}
TEST_CASE("where a ball floats depends on neither the step nor the columns", "[water]") {
    std::vector<double> heights;
    for (const auto& [cell, rate] : {std::pair{0.125, 60}, {0.25, 60}, {0.5, 60}, {0.25, 30}, {0.25, 240}}) {
        const auto n = std::size_t(10 / cell + 0.5);
        Afloat_ one(ColumnGrid(n, n, cell * metre), 2, pressing(ball, 1), 200, 5, 2.3, 5);
        one.steps(rate, 1.0 / rate); // in the midst of its way
        heights.push_back(one.y());
    }
    CAPTURE(heights);
    // Of a way of 0.6 m: 0.2 mm between 30 and 240 Hz, 4.2 cm between columns of 1/8 m and of 1/2 m, a radius of the
    // ball.
    for (const std::size_t other : {3, 4}) CHECK(std::abs(heights[other] - heights[1]) < 5e-4);
    CHECK(std::abs(heights[2] - heights[0]) < 0.05);
}
TEST_CASE("at a wall, in a corner and side by side bodies float as they do in the middle", "[water]") {
    auto settles = [](double x, double z) {
        Afloat_ one(pond(), 2, pressing(ball), 300, x, 2.1, z);
        one.steps(60 * 60, 1.0 / 60);
        CHECK(one.level() - 2 == Approx(0.003).epsilon(2e-3));
        CHECK(one.now().submerged.value() == Approx(0.3).epsilon(1e-5));
        CHECK(std::abs(one.world.water(one.pool).volume().value() - 200) < 1e-10);
        return std::abs(one.v());
    };
    CHECK(settles(0.5, 5) < 1e-5);
    CHECK(settles(0.5, 0.5) < 1e-5);
    CHECK(settles(9.9, 0.1) < 1e-5);
    Lake world{{}, {}, {}, {}};
    const auto pool = world.add(Pool{Surface{calm, pond(), 2.0 * metre}});
    std::vector<FloatingHandle> all;
    for (int i = 0; i < 9; ++i) {
        const auto body = world.add(position(metres(4 + i % 3, 2.2, 4 + i / 3)), mass(300.0 * kilogram));
        auto by = pressing(i % 2 ? decltype(Floating::by)(ball) : decltype(Floating::by)(cube));
        by.body = body;
        all.push_back(world.add(by));
    }
    for (int i = 0; i < 60 * 60; ++i) world.step(1.0 / 60 * second);
    for (const auto& one : all) {
        CHECK(world.afloat(one).submerged.value() == Approx(0.3).epsilon(1e-4));
        CHECK(world.afloat(one).level.value() - 2 == Approx(0.027).epsilon(5e-3));
    }
    CHECK(world.water(pool).volume().value() == Approx(200).epsilon(1e-12));
}
TEST_CASE("in a tub hardly wider than itself a body stands on the water that it has pressed up", "[water]") {
    // 1.5 m x 1.5 m, 1 m deep; a ball of 200 kg raises it by 8.9 cm.
    Afloat_ one(ColumnGrid(3, 3, 0.5 * metre), 1, pressing(ball, 4), 200, 0.75, 1.2, 0.75);
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.level() == Approx(1 + 0.2 / 2.25).epsilon(1e-4));
    CHECK(one.now().submerged.value() == Approx(0.2).epsilon(1e-4));
    CHECK(one.world.water(one.pool).volume().value() == Approx(2.25).epsilon(1e-12));
    // One that is wider than the tub stays dry.
    Afloat_ wide(ColumnGrid(3, 3, 0.3 * metre), 1, pressing(ball), 200, 0.45, 1.2, 0.45);
    wide.steps(10, 1.0 / 60);
    CHECK_FALSE(wide.now().in_pool);
    CHECK(wide.world.acceleration(wide.body).value()[1] == -g);
}
TEST_CASE("a body that leaves the map is dry, takes its water along, and comes back", "[water]") {
    Afloat_ one(pond(), 2, pressing(ball), 400, 9, 1.8, 5);
    one.world.set_velocity(one.body, metres_per_second(4, 0, 0));
    one.steps(5, 1.0 / 60);
    CHECK(one.world.water(one.pool).displaced().value() > 0.3);
    one.steps(25, 1.0 / 60);
    REQUIRE(one.world.position(one.body).value()[0] > 10);
    CHECK_FALSE(one.now().in_pool);
    CHECK(one.now().submerged.value() == 0);
    CHECK(one.world.water(one.pool).displaced().value() == 0);
    CHECK(one.world.acceleration(one.body).value() == Vector<double, 3>(0, -g, 0));
    one.world.set_position(one.body, metres(5, 1.8, 5));
    CHECK(one.now().in_pool); // without a frame of lag
    CHECK(one.world.acceleration(one.body).value()[1] > -g);
    one.world.set_velocity(one.body, metres_per_second(0, 0, 0));
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.level() - 2 == Approx(0.004).epsilon(2e-3));
    CHECK(one.world.water(one.pool).volume().value() == Approx(200).epsilon(1e-12));
}
TEST_CASE("from one pool into another, of another density", "[water]") {
    Lake world{{}, {}, {}, {}};
    const auto fresh = world.add(Pool{Surface{calm, pond(), 2.0 * metre}});
    const auto salt = world.add(
        Pool{Surface{calm, pond().at(30.0 * metre, 0.0 * metre), 3.0 * metre}, 1200.0 * kilogram_per_cubic_metre});
    const auto body = world.add(position(metres(5, 2, 5)), mass(240.0 * kilogram));
    const auto floating = world.add(Floating{body, ball, 0, 2.0 / second});
    for (int i = 0; i < 60 * 60; ++i) world.step(1.0 / 60 * second);
    CHECK(world.afloat(floating).submerged.value() == Approx(0.24).epsilon(1e-5));
    world.set_position(body, metres(35, 3, 5));
    for (int i = 0; i < 60 * 60; ++i) world.step(1.0 / 60 * second);
    CHECK(world.afloat(floating).submerged.value() == Approx(0.2).epsilon(1e-5));
    CHECK(world.afloat(floating).level.value() == Approx(3.002).epsilon(1e-5));
    CHECK(world.water(fresh).displaced().value() == 0);
    CHECK(world.water(fresh).volume().value() == Approx(200).epsilon(1e-12));
    CHECK(world.water(salt).volume().value() == Approx(300).epsilon(1e-12));
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
        Afloat_ one(pond(), 5, only(FixedLift{up * metre_per_second_squared}), 10, 5, y, 5);
        one.world.set_velocity(one.body, metres_per_second(0, v, 0));
        one.steps(30, 1.0 / 60);
        return one;
    };
    CHECK(falls(4, 4, -2).v() == Approx(-2 - (g - 4) * 0.5).epsilon(1e-12));
    CHECK(falls(15, 4, -2).v() == Approx(-2 + (15 - g) * 0.5).epsilon(1e-12));
    CHECK(falls(15, 9, 0).v() == Approx(-g * 0.5).epsilon(1e-12)); // above the water
    // What carries it presses the water up: 10 kg that have 4 m/s^2 of it, 4.08 litres.
    Afloat_ one(pond(), 5, pressing(FixedLift{4.0 * metre_per_second_squared}), 10, 5, 4, 5);
    one.steps(2, 1.0 / 60);
    CHECK(one.world.water(one.pool).displaced().value() == Approx(10 * 4 / (1000 * g)).epsilon(1e-12));
}
TEST_CASE("a spring holds a body to the surface, breaks when it is too deep, and frees the water (notes 7.4)",
          "[water]") {
    const SurfaceSpring spring{200.0 * newton_per_metre, 20.0 * newton_second_per_metre, 0.6 * metre};
    Afloat_ one(pond(), 5, pressing(spring), 10, 5, 4.6, 5);
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
TEST_CASE("a spring stiffer than the weight of its pool for each metre of level presses nothing up", "[water]") {
    const ColumnGrid tub(5, 5, 0.1 * metre); // rho g A = 2452.5 N/m
    auto in_tub = [&](double k, bool presses) {
        const SurfaceSpring spring{k * newton_per_metre, 20.0 * newton_second_per_metre, 0.6 * metre};
        Afloat_ one(tub, 2, presses ? pressing(spring) : only(spring), 10, 0.25, 1.9, 0.25);
        const double a = one.world.acceleration(one.body).value()[1];
        one.steps(1, 0.01);
        CHECK(one.world.status().ok());
        CHECK(one.world.water(one.pool).volume().value() == Approx(0.5).epsilon(1e-12));
        return a;
    };
    for (const double k : {2452.5, 2500.0, 5000.0, 1e6}) CHECK(in_tub(k, true) == -g);
    CHECK(in_tub(5000, false) == Approx(5000 * 0.1 / 10 - g).epsilon(1e-12)); // it changes no level
    // P = k (d + kappa P) / (rho g), where a ring rises by no less than the whole pool would: kappa >= 1 / A.
    const double wet = in_tub(1000, true) + g;
    CHECK(wet >= 1000 * 0.1 / (1 - 1000 / 2452.5) / 10 * (1 - 1e-12));
    CHECK(wet < 1000 * 0.1 / 0.01 / 10);
}
TEST_CASE("over a bed no column gives more than it has, and what it owes is given later (hard case W8)", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Buoyancy{}};
    const auto puddle = world.add(Pool{Surface{Pipes{}, ColumnGrid(30, 30, 0.2 * metre), 0.05 * metre}});
    const auto body = world.add(position(metres(3, -0.4, 3)), velocity(metres_per_second(0, 0, 0)), moving);
    world.add(Floating{body, Sphere{0.4 * metre}});
    auto dry = [&] {
        const auto heights = world.water(puddle).surface().heights();
        REQUIRE(*std::min_element(heights.begin(), heights.end()) >= 0);
        REQUIRE(world.water(puddle).volume().value() == Approx(36 * 0.05).epsilon(1e-12));
        return std::count(heights.begin(), heights.end(), 0.0);
    };
    for (int i = 0; i < 400; ++i) {
        world.step(0.01 * second);
        dry();
    }
    CHECK(world.water(puddle).displaced().value() > 0.1); // three times what stands there
    world.set_position(body, metres(3, 5, 3));
    world.step(0.01 * second);
    CHECK(dry() > 0);
    CHECK(world.water(puddle).displaced().value() > 0);
    // What is asked for here holds no less than nothing, and may be given back.
    auto other = world;
    const auto without = other.get(puddle);
    const auto heights = without.surface.heights();
    CHECK(*std::min_element(heights.begin(), heights.end()) == 0);
    CHECK(without.surface.volume().value() == Approx(36 * 0.05).epsilon(1e-12));
    other.set(puddle, without);
    CHECK(other.water(puddle).volume().value() == Approx(36 * 0.05).epsilon(1e-12));
    CHECK(other.water(puddle).displaced().value() == 0);
    for (int i = 0; i < 100; ++i) other.step(0.01 * second);
    CHECK(other.water(puddle).volume().value() == Approx(36 * 0.05).epsilon(1e-12));
    for (int i = 0; i < 4000; ++i) world.step(0.01 * second);
    dry();
    CHECK(world.water(puddle).displaced().value() == Approx(0).margin(1e-12));
}
TEST_CASE("beside little water a body presses up only what there is room for", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Buoyancy{}};
    const ColumnGrid grid(60, 21, 0.1 * metre);
    std::vector<double> bed;
    for (std::size_t n = 0; n < grid.size(); ++n) bed.push_back(n % 60 < 26 ? 0.0 : 2.0); // a quay at x = 2.6 m
    const auto pool = world.add(Pool{Surface{Pipes{}, grid, std::span<const double>(bed), 1.0 * metre}});
    const auto body = world.add(position(metres(3, 0.9, 1.05)), fixed);
    const auto floating = world.add(Floating{body, Sphere{0.3 * metre}});
    const double submerged = world.afloat(floating).submerged.value();
    world.step(1e-3 * second);
    CHECK(world.afloat(floating).in_pool);
    CHECK(world.water(pool).displaced().value() > 0.1 * submerged);
    CHECK(world.water(pool).displaced().value() < 0.75 * submerged);
    world.set_position(body, metres(4, 0.9, 1.05)); // on the quay there is no water around it
    CHECK_FALSE(world.afloat(floating).in_pool);
}
TEST_CASE("the Jacobian is how the force changes", "[water]") {
    for (const double kilograms : {300.0, 600.0}) {
        const auto by = kilograms == 300 ? only(ball, 0.7) : only(cube, 0.7);
        Afloat_ one(pond(), 2, by, kilograms, 5, 2.1, 5);
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
            CHECK(k == Approx(-by_y).epsilon(1e-6));
            CHECK(c == Approx(-by_v).epsilon(1e-6));
        });
    }
}
TEST_CASE("nobody gets energy from nothing: a ball and the waves that it makes, without damping", "[water]") {
    auto fastest = []<class Policy>(const Policy& policy, double cell) {
        World world{SemiImplicitEuler{}, Gravity{}, Pools<Policy>{}, Buoyancy{}};
        const auto n = std::size_t(10 / cell + 0.5);
        const auto pool = world.add(Pool{Surface{policy, ColumnGrid(n, n, cell * metre), 2.0 * metre}});
        // In the middle, where the waves that come back from the walls do not push it aside.
        const auto body = world.add(position(metres(5, 2.3, 5)), mass(300.0 * kilogram));
        const auto floating = world.add(Floating{body, ball});
        std::vector<double> of_a_minute;
        for (int minute = 0; minute < 4; ++minute) {
            of_a_minute.push_back(0);
            for (int i = 0; i < 3600; ++i) {
                world.step(1.0 / 60 * second);
                of_a_minute.back() = std::max(of_a_minute.back(), std::abs(y(world.velocity(body)).value()));
            }
        }
        // What is pressed up is what is under water, at the end of the step, to rounding.
        CHECK(world.water(pool).displaced().value() == Approx(world.afloat(floating).submerged.value()).epsilon(1e-12));
        return of_a_minute;
    };
    for (const double cell : {0.25, 0.5}) {
        const auto columns = fastest(WaterColumns{std::sqrt(g * 2) * mps}, cell), pipes = fastest(Pipes{}, cell);
        for (const std::size_t minute : {1, 2, 3}) {
            CHECK(columns[minute] <= columns[0] * 1.001);
            CHECK(pipes[minute] <= pipes[0] * 1.001);
        }
        CHECK(columns[3] > 0.8 * columns[0]); // and loses little of it
    }
}
TEST_CASE("a pool that is asked for comes without what bodies press up, and may be given back", "[water]") {
    Afloat_ one(pond(), 2, pressing(ball), 400, 5, 1.8, 5);
    one.steps(60, 1.0 / 60);
    REQUIRE(one.world.water(one.pool).displaced().value() > 0.3);
    const auto pool = one.world.get(one.pool);
    CHECK(pool.surface.volume().value() == Approx(200).epsilon(1e-13));
    one.world.set(one.pool, pool);
    CHECK(one.world.water(one.pool).volume().value() == Approx(200).epsilon(1e-13));
    CHECK(one.world.water(one.pool).displaced().value() == 0);
    CHECK(one.now().submerged.value() > 0.3); // it lies as deep as before, in the water that it will press up
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.now().submerged.value() == Approx(0.4).epsilon(1e-5));
    CHECK(one.level() - 2 == Approx(0.004).epsilon(1e-3));
    CHECK(one.world.water(one.pool).volume().value() == Approx(200).epsilon(1e-12));
}
TEST_CASE("a floating body that is described anew as it was is what it was, and any change of it goes on from there",
          "[water]") {
    Afloat_ one(pond(), 2, pressing(ball), 400, 5, 1.8, 5);
    one.steps(60, 1.0 / 60);
    auto other = one;
    other.world.set(other.floating, other.world.get(other.floating));
    CHECK(other.world.hash() == one.world.hash());
    other.steps(30, 1.0 / 60);
    one.steps(30, 1.0 / 60);
    CHECK(other.world.hash() == one.world.hash());
    auto larger = one.world.get(one.floating);
    larger.by = Sphere{0.6 * metre};
    one.world.set(one.floating, larger);
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.now().submerged.value() == Approx(0.4).epsilon(1e-5));
    CHECK(one.world.water(one.pool).volume().value() == Approx(200).epsilon(1e-12));
}
