// SPDX-License-Identifier: BSL-1.0
// Solver x response: those that answer contacts at the end of a step.
// Runs long with the sanitizers.

#include "tests/soft_bodies/contact_grid.hpp"

using namespace soft_bodies_tests;

TEST_CASE("whatever holds a sheet, by Impulse it falls on a plane or a box, lies still and makes no energy, and "
          "particles leave with e times "
          "their speed",
          "[soft_bodies][contact]") {
    each_way([](const auto& way) {
        const auto world = world_of(way, Impulse<Friction>{}, Projection{});
        const auto rough = friction(0.5);
        const auto dull = restitution(0);
        for (const auto& ground : {on_plane(world, dull, rough), on_box(world, dull, rough)}) {
            falls_and_lies(way, ground, {.lowest = 0.019}, dull, rough);
            bounces(way, ground);
        }
    });
}

TEST_CASE("what separates a body from the ground strains the spring at it: that is energy where k h^2 is more than m",
          "[soft_bodies][contact]") {
    // Two bodies above each other fall at one speed v, and the lower one is found d deep at the end of a step h. Its
    // velocity is taken (m v^2 / 2), it is lifted (m g d), and the spring is shortened by as much (k d^2 / 2). Since d
    // is at most |v| h, no energy comes of it while k h^2 <= m; a stiff sheet in long steps is far beyond.
    constexpr double m = 0.01, h = 1.0 / 60, radius = 0.02;
    const Way<SemiImplicitEuler, Xpbd> way{"Xpbd", h, 0, {{}, {10, 1}}};
    const auto empty = on_plane(world_of(way, Impulse<Friction>{}, Projection{}), restitution(0), friction(0.5));
    std::size_t gained = 0;
    for (const double ratio : {0.1, 0.9, 4., 139.})  // k h^2 / m; the last one is 5000 N/m
        for (const double part : {0.1, 0.6, 0.99}) { // of the way of a step, below the ground
            const double stiffness = ratio * m / (h * h), speed = 3.1;
            const auto fall = [&](double above) {
                auto world = empty;
                std::vector<Handle> both;
                for (const double y : {0., 0.1})
                    both.push_back(world.add(Sphere{radius * metre}, position(metres(0, above + y, 0)),
                                             velocity(metres_per_second(0, -speed, 0)), mass(m * kilogram),
                                             restitution(0)));
                world.add(Spring{both[0], both[1], stiffness * newton_per_metre});
                world.step(h * second);
                return std::pair(world, both);
            };
            const double above = radius + speed * h * (1 - part), high = above + 10;
            const auto [free, bodies] = fall(high);
            const auto [hit, same] = fall(above);
            const double deep = radius - (double(free.position(bodies[0]).value()[1]) - 10),
                         v = free.velocity(bodies[0]).value()[1];
            const double gain =
                double(total_energy(hit).value()) - double(total_energy(free).value()) + 2 * m * 9.81 * 10;
            CAPTURE(ratio, part, deep, gain);
            CHECK(deep > 0);
            CHECK(gain ==
                  Approx(stiffness * deep * deep / 2 + m * 9.81 * deep - m * v * v / 2).epsilon(0).margin(1e-9));
            if (ratio < 1 && deep < -v * h) CHECK(gain < m * 9.81 * deep);
            gained += gain > 0;
        }
    CHECK(gained > 2); // of the stiff ones
}
