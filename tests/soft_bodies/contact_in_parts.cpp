// SPDX-License-Identifier: BSL-1.0
// Solver x response: the one that takes a step in parts.
// Runs long with the sanitizers.

#include "tests/soft_bodies/contact_grid.hpp"

using namespace soft_bodies_tests;

TEST_CASE(
    "whatever holds a sheet, in SoftSubsteps it falls, lies still and makes no energy, and particles leave with e "
    "times their speed",
    "[soft_bodies][contact]") {
    each_way([](const auto& way) {
        const auto world = ground(way, SoftSubsteps<Friction>{});
        falls_and_lies(way, world);
        bounces(way, world);
    });
}
