// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What contacts mean for sleep (motion/sleep.hpp): bodies that touch are of one island, and a contact can hold a body.

#include <ansatz/collision/facts.hpp>
#include <ansatz/motion/sleep.hpp>

#include <cstdint>

namespace ansatz {

namespace detail {
/// Bodies that touch are of one island.
template <class C> void join_by_contacts(const WorldData<C>& data, SleepScratch<typename C::S>& scratch) {
    using S = typename C::S;
    constexpr bool push_unknown = C::template responses<Level::velocities>::size > 0 || C::parts;
    const auto awake = data.bodies.end(Motion::awake);
    const auto meets = [&](Bodies::Slot slot, [[maybe_unused]] const auto& outwards, Bodies::Slot other) {
        if (slot >= awake) return;
        if constexpr (push_unknown) {
            const auto& a = scratch.pulls[slot];
            if (dot(a, outwards) < typename S::Scalar(-0.01) * norm(a))
                scratch.held[slot] = 1; // a wall that it slides down is not enough
        }
        if (other < awake) scratch.islands.unite(slot, other);
        else if (goes(data, other)) scratch.goes_along[slot] = 1;
    };
    for (const auto& contact : data.collisions.contacts) {
        if (data.collisions.is_sensor(contact.first.id) || data.collisions.is_sensor(contact.second.id)) continue;
        const auto a = data.bodies.slot_of_id(contact.first.id), b = data.bodies.slot_of_id(contact.second.id);
        meets(a, contact.normal, b);
        meets(b, -contact.normal, a);
    }
}
} // namespace detail

} // namespace ansatz
