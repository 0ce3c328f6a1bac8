// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What every archetype is: a value that can be copied and destroyed, made from something, and nothing more. It has no
/// default constructor and no assignment, because a world must not need them of a policy that it only steps with.

#include <ansatz/world.hpp>

namespace ansatz::archetypes {

struct NothingMore {
    explicit NothingMore(int) {}
    NothingMore(const NothingMore&) = default;
    NothingMore& operator=(const NothingMore&) = delete;
    ~NothingMore() = default;
};

/// What a program does with a world: adds, steps, copies, reads.
template <class World_> auto use(World_ world) {
    if constexpr (World_::composition::has_mass) world.add(shapeless, mass(1.0 * kilogram));
    else world.add(shapeless);
    world.step(1.0 / 60 * second);
    const auto copy = world;
    return copy.hash();
}

} // namespace ansatz::archetypes
