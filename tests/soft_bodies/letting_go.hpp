// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Springs that are made to break in the next step: what the tests of tearing pull with.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <random>

namespace soft_tests {

using namespace ansatz;

/// In the next step this spring breaks.
template <class World_> void let_go(World_& world, SpringHandle spring) {
    auto description = world.get(spring);
    const auto length =
        norm(world.position(description.first.body()) - world.position(description.second.body())).value();
    description.rest_length = double(length) * 0.99 * metre;
    world.set(spring, description, breaks_at(0.001));
}
/// The same of some that are still there.
template <class World_> void let_some_go(World_& world, std::mt19937& random, int count) {
    for (int k = 0; k < count; ++k) {
        const auto all = world.template elements<Spring>().handles();
        if (!all.empty()) let_go(world, all[random() % all.size()]);
    }
}

} // namespace soft_tests
