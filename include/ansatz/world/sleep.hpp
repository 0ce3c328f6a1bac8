// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Who falls asleep where bodies collide: islands of bodies that have all been slow for long enough and are all held.
///
/// A body is held where nothing pulls at it, or where one of its contacts pushes against what pulls. At the top of its flight
/// a ball is slow, but nothing holds it; nor does a body beside it that falls as well. What is held by a body that is not held
/// itself is in one island with it, and stays awake with it.

#include <ansatz/world/data.hpp>

#include <cstdint>
#include <vector>

namespace ansatz {

/// What is kept for the question, from step to step.
template <class S, class Sets> struct SleepScratch {
    Sets islands;                                     ///< of the awake bodies, by slot
    std::vector<typename S::Acceleration> pulls;      ///< by slot
    std::vector<std::uint8_t> held;                   ///< whether something holds the body of a slot
    std::vector<std::uint8_t> restless;               ///< whether an island stays awake, by who stands for it
    std::vector<std::uint32_t> sleepers;              ///< by id
};

/// Finds the ids of the bodies that fall asleep now.
/// \param slow_long whether the body of a slot has been slow for long enough
/// \param pull      the acceleration that the body of a slot would have at rest
template <class C, class Scratch, class SlowLong, class Pull>
void find_sleepers(WorldData<C>& data, Scratch& scratch, const SlowLong& slow_long, const Pull& pull) {
    using S = typename C::S;
    const auto awake = data.bodies.end(Motion::awake);
    scratch.sleepers.clear();
    bool any = false;
    for (std::size_t slot = 0; slot < awake && !any; ++slot) any = slow_long(slot);
    if (!any) return;

    scratch.islands.reset(awake);
    scratch.pulls.resize(awake);
    scratch.held.assign(awake, 0);
    scratch.restless.assign(awake, 0);
    for (std::size_t slot = 0; slot < awake; ++slot) {
        scratch.pulls[slot] = pull(Bodies::Slot(slot));
        scratch.held[slot] = scratch.pulls[slot] == S::template zero_vector<unit::Acceleration>();
    }
    const auto pushes_back = [&](std::size_t slot, const auto& outwards) {
        const auto& a = scratch.pulls[slot];
        if (dot(a, outwards) < typename S::Scalar(-0.01) * norm(a)) scratch.held[slot] = 1; // a wall that it slides down is not enough
    };
    for (const auto& contact : data.collisions.contacts) {
        if (data.collisions.is_sensor(contact.first.id) || data.collisions.is_sensor(contact.second.id)) continue;
        const auto a = data.bodies.slot_of_id(contact.first.id), b = data.bodies.slot_of_id(contact.second.id);
        if (a < awake) pushes_back(a, contact.normal);
        if (b < awake) pushes_back(b, -contact.normal);
        if (a < awake && b < awake) scratch.islands.unite(a, b);
    }
    data.states.for_each([&](const auto& elements) {
        elements.for_each([&](std::uint32_t id, const auto&) {
            std::size_t first = awake;
            elements.for_each_body(id, [&](std::uint32_t body) {
                const auto slot = data.bodies.slot_of_id(body);
                if (slot >= awake) return;
                if (first < awake) scratch.islands.unite(std::uint32_t(first), slot);
                first = slot;
            });
        });
    });
    for (std::size_t slot = 0; slot < awake; ++slot)
        if (!scratch.held[slot] || !slow_long(slot)) scratch.restless[scratch.islands.of(std::uint32_t(slot))] = 1;
    for (std::size_t slot = 0; slot < awake; ++slot)
        if (!scratch.restless[scratch.islands.of(std::uint32_t(slot))]) scratch.sleepers.push_back(data.bodies.id(slot));
}

} // namespace ansatz
