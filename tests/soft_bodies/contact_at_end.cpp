// SPDX-License-Identifier: BSL-1.0
// Solver x response: those that answer contacts at the end of a step.
// Runs long with the sanitizers.

#include "tests/soft_bodies/contact_grid.hpp"

using namespace soft_bodies_tests;

TEST_CASE(
    "whatever holds a sheet, by Impulse it falls, lies still and makes no energy, and particles leave with e times "
    "their speed",
    "[soft_bodies][contact]") {
    each_way([](const auto& way) {
        const auto world = ground(way, Impulse<Friction>{}, Projection{});
        falls_and_lies(way, world);
        bounces(way, world);
    });
}
