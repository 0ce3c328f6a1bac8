// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftIslands`: contacts of `SoftSubsteps` take energy and do not give it. Beyond the notes.
///
/// An island whose contacts have given it some, because they separated bodies that lay in each other, gets the share of
/// its impulses that leaves it the least kinetic energy.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/bodies.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace ansatz {

/// What is kept here lives within a step.
template <class S> class SoftIslands {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// Takes back what contacts have given. Where something accelerates an island, up to `most_given` times the energy
    /// of that acceleration in a substep is let pass: with less, columns tremble.
    /// \param before    by slot: the velocities before the last pass, m/s
    /// \param platforms whether there are bodies that move by themselves, and do work
    /// \return whether there was such an island; its bodies' velocities are not those of before
    bool calm(auto& contacts, const std::vector<Raw>& before, bool platforms) {
        const auto& bodies = contacts.bodies;
        auto& pushed = contacts.pushed;
        bool given = platforms; // an island is given something only where one of its bodies is
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            const auto& body = bodies[slot];
            if (!(body.weight > Scalar(0))) continue;
            pushed[slot] += body.u - before[slot];
            given = given || 2 * dot(body.u, pushed[slot]) - pushed[slot].squaredNorm() >
                                 2 * most_given * contacts.kicks[slot].squaredNorm();
        }
        if (!given) return false;
        if (islands_.empty()) find(contacts);
        add_energies(contacts);
        if (platforms) add_work(contacts);
        bool any = false;
        for (auto& island : islands_) {
            if (!(island.along + island.square / 2 > most_given * island.kick)) continue;
            island.keep = std::clamp(-island.along / island.square, Scalar(0), Scalar(1));
            any = true;
        }
        if (any) take_back(contacts);
        return any;
    }
    /// Contacts are others than before: islands are found where they are asked for.
    void forget() { islands_.clear(); }
    /// Room for so many bodies.
    void reserve(std::size_t n) {
        island_.reserve(n);
        islands_.reserve(n);
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SoftIslands& other) {
        island_.reserve(other.island_.size());
        islands_.reserve(other.islands_.size());
    }

private:
    static constexpr int most_given = 16; // found by trial on columns of six: 4 and 16 come to rest, 0.5 and 1 do not
    /// Bodies that contacts of this step join, through no body that is not moved.
    struct Island {
        Scalar square{0}, along{0}; // of what contacts did: M (change)^2, and M (change) . (velocity before), J
        Scalar kick{0};             // M (what acceleration does)^2, J
        Scalar keep{1};             // of their impulses
    };

    void find(auto& contacts) {
        const auto awake = std::uint32_t(contacts.awake());
        const auto& bodies = contacts.bodies;
        island_.resize(awake);
        for (std::uint32_t slot = 0; slot < awake; ++slot) island_[slot] = slot;
        contacts.each_acting([&](const auto& c) {
            if (!(bodies[c.slot_a].weight > Scalar(0)) || !(bodies[c.slot_b].weight > Scalar(0))) return;
            const auto a = root(c.slot_a), b = root(c.slot_b);
            island_[std::max(a, b)] = std::min(a, b);
        });
        std::uint32_t count = 0; // a root has the smallest slot of its island, so that it comes first
        for (std::uint32_t slot = 0; slot < awake; ++slot)
            island_[slot] = island_[slot] == slot ? count++ : island_[island_[slot]];
        detail::grow(islands_, count); // one more in every other step, where a heap falls apart
        islands_.resize(count);
    }
    std::uint32_t root(std::uint32_t slot) {
        while (island_[slot] != slot) slot = island_[slot] = island_[island_[slot]];
        return slot;
    }
    void add_energies(const auto& contacts) {
        for (auto& island : islands_) island = Island();
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            const auto& body = contacts.bodies[slot];
            if (!(body.weight > Scalar(0))) continue;
            auto& island = islands_[island_[slot]];
            const Scalar m = 1 / body.weight;
            island.square += m * contacts.pushed[slot].squaredNorm();
            island.along += m * dot(body.u, contacts.pushed[slot]);
            island.kick += m * contacts.kicks[slot].squaredNorm();
        }
        for (auto& island : islands_) island.along -= island.square;
    }
    /// What platforms do to the islands that lie on them.
    void add_work(auto& contacts) {
        const auto& bodies = contacts.bodies;
        contacts.each_acting([&](const auto& c) {
            for (const auto slot : {c.slot_a, c.slot_b})
                if (!(bodies[slot].weight > Scalar(0))) {
                    const auto other = slot == c.slot_a ? c.slot_b : c.slot_a;
                    const Scalar work = dot(contacts.whole(c), Raw(bodies[slot].u));
                    islands_[island_[other]].along += slot == c.slot_a ? work : -work;
                }
        });
    }
    void take_back(auto& contacts) {
        auto& bodies = contacts.bodies;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot)
            if (bodies[slot].weight > Scalar(0)) {
                const Scalar keep = islands_[island_[slot]].keep;
                if (keep < Scalar(1)) bodies[slot].u -= (1 - keep) * contacts.pushed[slot];
            }
        contacts.each_acting([&](auto& c) {
            const Scalar keep = islands_[island_[bodies[c.slot_a].weight > Scalar(0) ? c.slot_a : c.slot_b]].keep;
            if (!(keep < Scalar(1))) return;
            c.impulse *= keep;
            if constexpr (std::remove_cvref_t<decltype(contacts)>::rubs) c.rubbing *= keep;
        });
    }

    std::vector<std::uint32_t> island_; // by slot
    std::vector<Island> islands_;
};

} // namespace ansatz
