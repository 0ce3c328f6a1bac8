// SPDX-License-Identifier: BSL-1.0
// What bodies do to water: they press it up around them, none of it is lost, and no energy comes of it (hard cases B9,
// W8).
// Runs long with the sanitizers.

#include "tests/water/body_in_pool.hpp"

using namespace water_tests;

TEST_CASE("400 kg raise a pool of 100 m^2 by 4 mm, and no water is lost (hard case B9)", "[water]") {
    for (const double cell : {0.1, 0.25, 0.5, 1.0}) {
        CAPTURE(cell);
        const auto n = std::size_t(10 / cell + 0.5);
        BodyInPool one(ColumnGrid(n, n, cell * metre), 2, pressing(ball), 400, 5.03, 2.2, 4.98);
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
TEST_CASE("at a wall, in a corner and side by side bodies float as they do in the middle", "[water]") {
    auto settles = [](double x, double z) {
        BodyInPool one(pond(), 2, pressing(ball), 300, x, 2.1, z);
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
    BodyInPool one(ColumnGrid(3, 3, 0.5 * metre), 1, pressing(ball, 4), 200, 0.75, 1.2, 0.75);
    one.steps(60 * 60, 1.0 / 60);
    CHECK(one.level() == Approx(1 + 0.2 / 2.25).epsilon(1e-4));
    CHECK(one.now().submerged.value() == Approx(0.2).epsilon(1e-4));
    CHECK(one.world.water(one.pool).volume().value() == Approx(2.25).epsilon(1e-12));
    // One that is wider than the tub stays dry.
    BodyInPool wide(ColumnGrid(3, 3, 0.3 * metre), 1, pressing(ball), 200, 0.45, 1.2, 0.45);
    wide.steps(10, 1.0 / 60);
    CHECK_FALSE(wide.now().in_pool);
    CHECK(wide.world.acceleration(wide.body).value()[1] == -g);
}
TEST_CASE("a body that leaves the map is dry, takes its water along, and comes back", "[water]") {
    BodyInPool one(pond(), 2, pressing(ball), 400, 9, 1.8, 5);
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
TEST_CASE("a spring stiffer than the weight of its pool for each metre of level presses nothing up", "[water]") {
    const ColumnGrid tub(5, 5, 0.1 * metre); // rho g A = 2452.5 N/m
    auto in_tub = [&](double k, bool presses) {
        const SurfaceSpring spring{k * newton_per_metre, 20.0 * newton_second_per_metre, 0.6 * metre};
        BodyInPool one(tub, 2, presses ? pressing(spring) : only(spring), 10, 0.25, 1.9, 0.25);
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
TEST_CASE("what a body presses up is nobody's to take, and a column below zero can be filled", "[water]") {
    BodyInPool one(ColumnGrid(12, 12, 0.5 * metre), 2, Floating{{}, Sphere{0.5 * metre}}, 400, 3, 2, 3);
    one.steps(60 * 20, 1.0 / 60);
    auto& world = one.world;
    REQUIRE(world.water(one.pool).displaced().value() > 0.3);
    const auto hash = world.hash();
    const auto before = world.water(one.pool).volume();
    // Each column gives what it would hold without the body, and not what was pressed up.
    const auto& grid = world.water(one.pool).grid();
    const auto without = world.get(one.pool).surface;
    for (std::size_t j = 0; j < 12; ++j)
        for (std::size_t i = 0; i < 12; ++i) {
            const double own = without.height(i, j).value() * 0.25;
            const auto said = refusal(
                [&] { world.pour(one.pool, grid.centre_x(i), grid.centre_z(j), -(own * (1 + 1e-9)) * cubic_metre); });
            REQUIRE(said.find("the column would hold less than nothing; it has ") != std::string::npos);
        }
    CHECK(world.hash() == hash);
    CHECK(world.water(one.pool).volume() == before);
    for (std::size_t j = 0; j < 12; ++j)
        for (std::size_t i = 0; i < 12; ++i) {
            const double own = without.height(i, j).value() * 0.25;
            world.pour(one.pool, grid.centre_x(i), grid.centre_z(j), -(own * (1 - 1e-12)) * cubic_metre);
        }
    CHECK(world.water(one.pool).volume().value() == Approx(0).margin(1e-10));
    CHECK(world.water(one.pool).volume().value() >= 0);

    World low{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}};
    Surface deep(WaterColumns{3.0 * mps}, ColumnGrid(12, 1, 0.5 * metre), 0.1 * metre);
    deep.set_height(0, 0, 2.0 * metre);
    const auto pool = low.add(Pool{deep});
    int steps = 0;
    const auto& heights = low.water(pool).surface().heights();
    auto lowest = [&] { return std::min_element(heights.begin(), heights.end()) - heights.begin(); };
    for (; steps < 200 && heights[std::size_t(lowest())] >= 0; ++steps) low.step(0.02 * second);
    const auto n = std::size_t(lowest());
    REQUIRE(heights[n] < 0);                                   // columns that pull at each other know no ground
    const double was = heights[n], filled = -0.5 * was * 0.25; // half of the way up: below zero still
    low.pour(pool, low.water(pool).grid().centre_x(n), 0.25 * metre, filled * cubic_metre);
    CHECK(heights[n] == Approx(0.5 * was).epsilon(1e-12));
    CHECK(refusal([&] {
              low.pour(pool, low.water(pool).grid().centre_x(n), 0.25 * metre, -1e-9 * cubic_metre);
          }).find("it has 0 m^3") != std::string::npos);
}
TEST_CASE("the wake of a hull that is twice as fast as waves opens by Mach's angle", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    const ColumnGrid grid(160, 120, 0.2 * metre); // 32 m x 24 m
    const auto pool = world.add(Pool{Surface{WaterColumns{2.0 * mps}, grid, 2.0 * metre}});
    const auto hull = world.add(position(metres(4, 2, 12)), velocity(metres_per_second(4, 0, 0)), moving);
    world.add(Floating{hull, ball});
    for (int i = 0; i < 600; ++i) world.step(0.01 * second); // 24 m on
    const auto& water = world.water(pool).surface();
    // The crest of the wake beside the track, so far behind the hull.
    auto crest = [&](double behind) {
        const auto i = grid.column((28 - behind) * metre, 12.0 * metre) % 160;
        std::size_t highest = 60;
        for (std::size_t j = 60; j < 120; ++j)
            if (water.height(i, j) > water.height(i, highest)) highest = j;
        CHECK(water.height(i, highest) > 2.004 * metre);
        for (std::size_t j = 0; j < 60; ++j) // and the same on the other side
            CHECK(water.height(i, j).value() == Approx(water.height(i, 119 - j).value()).epsilon(1e-12));
        return grid.centre_z(highest).value() - 12;
    };
    // sin = c / v: 30 degrees.
    const double near = crest(4), far = crest(14);
    CHECK((far - near) / 10 == Approx(std::tan(pi / 6)).epsilon(0.05));
    for (std::size_t j = 0; j < 120; ++j) // it comes before its waves
        CHECK(water.height(155, j).value() == Approx(2).epsilon(1e-9));
}
TEST_CASE("no body gets energy from nothing: a ball and the waves that it makes, without damping", "[water]") {
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
    BodyInPool one(pond(), 2, pressing(ball), 400, 5, 1.8, 5);
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
    BodyInPool one(pond(), 2, pressing(ball), 400, 5, 1.8, 5);
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
