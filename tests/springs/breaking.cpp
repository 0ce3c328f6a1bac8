// SPDX-License-Identifier: BSL-1.0
// Springs and ropes that break, at a force or a strain.

#include "tests/springs/support.hpp"

using namespace spring_tests;

TEST_CASE("a spring breaks in the step after which it pulls or pushes too hard, with an event, and not before",
          "[springs]") {
    for_each_type(AllIntegrators{}, [&]<class I>() {
        World world{I{}, Springs<Breaking>{}};
        const auto body =
            world.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
        const auto spring =
            world.add(Spring{metres(0, 0, 0), body, 100.0 * N_per_m, {}, 1.0 * metre}, breaks_at(8.0 * newton));
        int step = 0;
        while (world.contains(spring) && ++step < 1000) {
            CHECK(100 * (x(world.position(body)).value() - 1) <= 8);
            CHECK(broken<Spring>(world).empty());
            world.step(0.001 * second);
        }
        REQUIRE(step < 1000);
        const auto all = broken<Spring>(world);
        REQUIRE(all.size() == 1);
        CHECK(all[0].which == spring);
        CHECK(all[0].first.body() == body);
        CHECK(all[0].second.is_point());
        CHECK(all[0].tension > 8.0 * newton);
        CHECK(all[0].tension < 8.2 * newton);
        CHECK(all[0].strain == Approx(0.08).epsilon(0.02));
        // From here on it flies on with the velocity that it had, whatever the integrator keeps.
        const auto v = world.velocity(body);
        const double expected = std::sqrt(1 - 0.64); // cos of where it broke: 10/s times 0.08 m is 0.8 of 1 m/s
        CHECK(x(v).value() ==
              Approx(expected).epsilon(std::same_as<I, ImplicitEuler> ? 0.03 : 0.01)); // ImplicitEuler damps by itself
        world.step(0.001 * second);
        CHECK(norm(world.velocity(body) - v).value() <= 1e-12);
        CHECK(broken<Spring>(world).empty());
    });
}

TEST_CASE("by strain: stretched and pressed, of the rest length, ropes too, a limit of force and one of strain",
          "[springs]") {
    for (const double direction : {1.0, -1.0}) {
        World world{SemiImplicitEuler{}, Springs<Breaking>{}};
        const auto body =
            world.add(position(metres(2, 0, 0)), velocity(metres_per_second(direction, 0, 0)), mass(1.0 * kilogram));
        const auto spring = world.add(Spring{metres(0, 0, 0), body, 1e-3 * N_per_m, {}, 2.0 * metre}, breaks_at(0.25));
        run(world, 49, 0.01);
        CHECK(world.contains(spring));
        run(world, 2, 0.01);
        CHECK_FALSE(world.contains(spring));
    }
    World world{SemiImplicitEuler{}, Ropes<Breaking>{}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto both = world.add(
        Rope{.first = body, .second = metres(0, 0, 0), .stiffness = 1.0 * N_per_m, .rest_length = 1.0 * metre},
        breaks_at(0.5 * newton), breaks_at(0.2));
    run(world, 21, 0.01);
    CHECK_FALSE(world.contains(both));
    CHECK(broken<Rope>(world)[0].tension < 0.5 * newton); // the strain came first
}

TEST_CASE("a chain breaks at its weakest link, and what is left goes on as the laws say", "[springs]") {
    World world{VelocityVerlet{}, Gravity{}, Springs<Breaking>{}};
    std::vector<Handle> bodies;
    std::vector<SpringHandle> links;
    for (int i = 1; i <= 5; ++i) {
        bodies.push_back(world.add(position(metres(0, -i, 0)), mass(1.0 * kilogram)));
        SpringEnd upper = metres(0, 0, 0);
        if (i > 1) upper = bodies[std::size_t(i) - 2];
        links.push_back(world.add(Spring{upper, bodies.back(), 1000.0 * N_per_m, 20.0 * N_s_per_m, 1.0 * metre},
                                  breaks_at(i == 3 ? 30.0 * newton : 1e3 * newton)));
    }
    for (int i = 0; i < 200 && world.contains(links[2]); ++i) world.step(0.005 * second);
    CHECK_FALSE(world.contains(links[2]));
    const auto total = [&] {
        return world.velocity(bodies[2]) + world.velocity(bodies[3]) + world.velocity(bodies[4]);
    };
    const auto before = total();
    run(world, 100, 0.005);
    CHECK(y(total() - before).value() == Approx(3 * -9.81 * 0.5).epsilon(1e-3)); // the lower three fall freely together
    CHECK(world.contains(links[0]));
    CHECK(world.contains(links[4]));
    run(world, 2000, 0.005);
    CHECK(height(world, bodies[1]) == Approx(-2 - (2 + 1) * 9.81 / 1000).epsilon(1e-4));
}

TEST_CASE("many break in one step, those of two policies too, and the events of a step are gone with the next",
          "[springs]") {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Ropes<Breaking>{}};
    for (int i = 0; i < 10; ++i) {
        const auto body =
            world.add(position(metres(i, 1, 0)), velocity(metres_per_second(0, 100, 0)), mass(1.0 * kilogram));
        world.add(Spring{metres(i, 0, 0), body, 100.0 * N_per_m}, breaks_at(1.0 * newton));
        world.add(Rope{metres(i, 0, 0), body, 100.0 * N_per_m}, breaks_at(1.0 * newton));
    }
    world.step(0.01 * second);
    CHECK(broken<Spring>(world).size() == 10);
    CHECK(broken<Rope>(world).size() == 10);
    CHECK(world.elements<Spring>().size() == 0);
    world.step(0.01 * second);
    CHECK(broken<Spring>(world).empty());
}

TEST_CASE("a limit that the world's scalar cannot tell from zero is refused", "[springs]") {
    World world{SemiImplicitEuler{}, Space<float, 2>{}, Springs<Breaking>{}};
    const auto body = world.add(position(metres(1, 0)), mass(1.0 * kilogram));
    const Spring spring{metres(0, 0), body, 100.0 * N_per_m};
    CHECK_THROWS_WITH(world.add(spring, breaks_at(1e-60)),
                      Catch::Matchers::ContainsSubstring("World::add: break strain is 1e-60"));
    CHECK_THROWS_WITH(world.add(spring, breaks_at(1e-60 * newton)),
                      Catch::Matchers::ContainsSubstring("World::add: break force is 1e-60 N"));
    CHECK(world.elements<Spring>().size() == 0);
    world.add(spring, breaks_at(50.0f * newton)); // in the world's own scalar
    CHECK(world.elements<Spring>().limit(0).force == 50);
}

TEST_CASE("who reads what broke may add springs as he goes, more than broke", "[springs]") {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}};
    std::vector<Handle> bodies;
    for (int i = 0; i < 8; ++i) {
        bodies.push_back(world.add(position(metres(i, 0, 0)), mass(1.0 * kilogram)));
        world.add(Spring{bodies.back(), metres(i, 2, 0), 100.0 * N_per_m, {}, 1.0 * metre}, breaks_at(50.0 * newton));
    }
    world.step(0.001 * second);
    const auto gone = broken<Spring>(world);
    REQUIRE(gone.size() == 8);
    std::size_t read = 0;
    for (const auto& b : gone) {
        CHECK(b.first.body() == bodies[read++]);
        for (int i = 0; i < 5; ++i) world.add(Spring{b.first, b.second, 1.0 * N_per_m});
        REQUIRE(broken<Spring>(world).data() == gone.data()); // they stay where they are
    }
    CHECK(read == 8);
    CHECK(world.elements<Spring>().size() == 40);
}
