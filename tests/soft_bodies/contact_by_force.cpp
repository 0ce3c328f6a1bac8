// SPDX-License-Identifier: BSL-1.0
// Solver x response: Penalty, whose push is one force more.
// Runs long with the sanitizers.

#include "tests/soft_bodies/contact_grid.hpp"

using namespace soft_bodies_tests;

TEST_CASE(
    "whatever holds a sheet, by a damped Penalty it falls on a plane or a box, lies as deep as its weight presses it, "
    "and makes no energy",
    "[soft_bodies][contact]") {
    // 200 N/m below 0.01 kg: its weight presses a particle m g / k = 0.49 mm deep. At 3.1 m/s it goes in by less than
    // v sqrt(m / k) = 22 mm, were there no damping: its centre may come below the surface, and is pushed back all the
    // same.
    constexpr double k = 200, m = 0.01;
    each_way([&](auto way) {
        way.wild = 0; // without friction a sheet that is pushed aside would glide for ever
        // By itself SemiImplicitEuler keeps E - h k p v / 2 of a spring and not E: between both are h sqrt(k m) v^2 / 4
        // at most, of 64 particles. The others take energy away.
        const bool is_explicit = std::string(way.name) == "explicit";
        const double swing = is_explicit ? 64 * way.h * std::sqrt(k * m) * (2 * 9.81 * 0.48) / 4 : 0;
        const Penalty penalty{k * newton_per_metre, 1.0 * newton_second_per_metre};
        const auto world = world_of(way, penalty);
        for (const auto& ground : {on_plane(world), on_box(world)}) {
            falls_and_lies(way, ground, {.lowest = 0.02 - 3.15 * std::sqrt(m / k), .swing = swing});
            auto one = ground;
            const auto lies = one.add(Sphere{0.02 * metre}, position(metres(0.3, 0.02, 0.3)), mass(m * kilogram));
            for (int i = 0; i < int(4 / way.h); ++i) one.step(way.h * second);
            CAPTURE(way.name);
            CHECK(one.position(lies).value()[1] == Approx(0.02 - m * 9.81 / k).epsilon(0).margin(1e-9));
        }
    });
}
