// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How contacts decide about sleep (motion/sleep.hpp): bodies that touch are of one island, and a contact can hold a
/// body.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/facts.hpp>
#include <ansatz/collision/sleeping_contacts.hpp>
#include <ansatz/motion/sleep.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz {

namespace detail {
/// Bodies that touch are of one island.
template <class C> void join_by_contacts(const WorldData<C>& data, SleepScratch<typename C::S>& scratch) {
    using S = typename C::S;
    constexpr bool push_unknown = C::template responses<Level::velocities>::size > 0 || C::separates;
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
    for (const auto& contact : data.collisions.contacts.acting) {
        if (data.collisions.is_sensor(contact.first.id) || data.collisions.is_sensor(contact.second.id)) continue;
        const auto a = data.bodies.slot_of_id(contact.first.id), b = data.bodies.slot_of_id(contact.second.id);
        meets(a, contact.normal, b);
        meets(b, -contact.normal, a);
    }
}
/// What is kept of the contacts of the step before.
struct ContactsKept {
    std::size_t asleep = 0; ///< between bodies of which none may move
    bool twice = false;     ///< whether some may be there twice
};
/// Two bodies of which none moves are in contact as they were. One that sleeps on a platform that stands still is
/// tested with it, but may lie there without any depth.
/// \param found takes them
template <class C>
ContactsKept keep_contacts_at_rest([[maybe_unused]] const WorldData<C>& data,
                                   [[maybe_unused]] std::vector<Contact<typename C::S>>& found) {
    ContactsKept kept;
    if constexpr (C::rests)
        for (const auto& contact : data.collisions.contacts.acting) {
            if (!data.collisions.lasts(data.bodies, contact)) continue;
            const auto a = data.bodies.slot_of_id(contact.first.id), b = data.bodies.slot_of_id(contact.second.id);
            const auto of_a = data.bodies.motion(a), of_b = data.bodies.motion(b);
            if (of_a == Motion::awake || of_b == Motion::awake) continue;
            const bool platform = of_a == Motion::moving || of_b == Motion::moving;
            if (platform && ((of_a != Motion::resting && of_b != Motion::resting) || goes(data, a) || goes(data, b)))
                continue;
            kept.twice = kept.twice || platform;
            if (!platform) ++kept.asleep;
            append(found, contact);
        }
    return kept;
}
/// Whether neither body of a contact, or of what is kept of one, may move.
template <class C> [[gnu::always_inline]] inline bool sleeps(const WorldData<C>& data, const auto& pair) {
    const auto moves = [&](std::uint32_t id) { return data.bodies.goes(data.bodies.slot_of_id(id)); };
    const auto ids = ids_of(pair);
    return !moves(ids.first) && !moves(ids.second);
}
} // namespace detail

} // namespace ansatz
