// SPDX-License-Identifier: BSL-1.0
// Solver x response: the one that takes a step in substeps.
// Runs long with the sanitizers.

#include "tests/soft_bodies/contact_grid.hpp"

using namespace soft_bodies_tests;

TEST_CASE("whatever holds a sheet, in SoftSubsteps it falls on a plane or a box, lies still and makes no energy, and "
          "particles leave with e "
          "times their speed",
          "[soft_bodies][contact]") {
    each_way([](const auto& way) {
        const auto world = world_of(way, SoftSubsteps<Friction>{});
        const auto rough = friction(0.5);
        const auto dull = restitution(0);
        for (const auto& ground : {on_plane(world, dull, rough), on_box(world, dull, rough)}) {
            falls_and_lies(way, ground, {.lowest = 0.019}, dull, rough);
            bounces(way, ground);
        }
    });
}
