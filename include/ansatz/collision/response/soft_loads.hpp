// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftLoads`: impulses of `SoftSubsteps` that remember a load which has gone, or become light. Beyond the notes.
///
/// Warm start begins a step with the impulses of the one before: what lies still is held from the first pass on. Where
/// a heavy body has been taken from a column, or gravity has been switched off, they hold up something that is not
/// there, and the few passes of a step would not find out before the rest had been thrown into the air.
///
/// What lies still tells: all that its contacts do to it, friction included, is equal and opposite to what acceleration
/// does,
/// \f$ \sum_c w J_c = -a h \f$. A body that is pushed by some times as much is no memory of lying still. What pushes it
/// is made as small as what is pushed against: gravity, and what is upon it now. That is a smaller load for those
/// below, so it is done again, layer by layer.

#include <ansatz/world/bodies.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace ansatz {

/// What is kept here lives within a step.
template <class S> class SoftLoads {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// Takes off what is too much after the warm start, and starts again with what is left.
    /// \param before by slot: the velocities before the warm start, m/s
    void take_off(auto& contacts, const std::vector<Raw>& before) {
        auto& bodies = contacts.bodies;
        nets_.resize(bodies.size(), Raw::Zero());
        bool any = false;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            nets_[slot] = bodies[slot].weight > Scalar(0) ? Raw(bodies[slot].u - before[slot]) : Raw::Zero();
            any = any || is_overpushed(contacts, slot);
        }
        if (!any) return;
        bool less = false;
        for (int round = 0; round < most_rounds && find_overpushed(contacts) && lessen(contacts); ++round) less = true;
        if (!less) return;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot)
            if (bodies[slot].weight > Scalar(0)) bodies[slot].u = before[slot];
        contacts.warm_start();
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) {
        nets_.reserve(n);
        over_.reserve(n);
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SoftLoads& other) {
        nets_.reserve(other.nets_.size());
        over_.reserve(other.over_.size());
    }

private:
    static constexpr int most_rounds = 64; // a layer of a pile in each
    static constexpr int times = 4;        // bodies that fall about are pushed by a few times what acceleration does

    /// A body that its impulses push too much.
    struct Overpushed {
        Raw towards;              // a unit vector: where they push it together
        Scalar by{0}, against{0}; // of each, along that, m/s; the second is negative
        Scalar keep{1};           // the share of the first that is right
        bool is = false;
    };

    bool is_overpushed(const auto& contacts, std::size_t slot) const {
        return nets_[slot].squaredNorm() > Scalar(times * times) * contacts.kicks[slot].squaredNorm();
    }
    bool find_overpushed(const auto& contacts) {
        bool any = false;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            if (!is_overpushed(contacts, slot)) continue;
            if (!any) over_.assign(nets_.size(), Overpushed());
            any = true;
            over_[slot].is = true;
            over_[slot].towards = nets_[slot] / std::sqrt(nets_[slot].squaredNorm());
        }
        return any;
    }
    /// \return whether there was anything to take
    bool lessen(auto& contacts) {
        const auto& bodies = contacts.bodies;
        auto count = [](Overpushed& o, const Raw& by) {
            if (!o.is) return;
            const Scalar along = dot(by, o.towards);
            (along > Scalar(0) ? o.by : o.against) += along;
        };
        contacts.each_acting([&](const auto& c) {
            const Raw impulse = contacts.whole(c);
            count(over_[c.slot_a], bodies[c.slot_a].weight * impulse);
            count(over_[c.slot_b], -bodies[c.slot_b].weight * impulse);
        });
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot) {
            auto& o = over_[slot];
            if (!o.is) continue;
            const Scalar needed = std::max(-dot(o.towards, contacts.kicks[slot]), Scalar(0)) - o.against;
            if (o.by - needed > Scalar(1e-5) * o.by) o.keep = needed / o.by;
        }
        bool any = false;
        contacts.each_acting([&](auto& c) {
            const auto &a = over_[c.slot_a], &b = over_[c.slot_b];
            const Raw impulse = contacts.whole(c);
            Scalar keep(1);
            if (a.is && dot(a.towards, impulse) > Scalar(0)) keep = std::min(keep, a.keep);
            if (b.is && dot(b.towards, impulse) < Scalar(0)) keep = std::min(keep, b.keep);
            if (!(keep < Scalar(1)) || !(c.impulse > Scalar(0))) return;
            const Raw less = (keep - 1) * impulse;
            nets_[c.slot_a] += bodies[c.slot_a].weight * less;
            nets_[c.slot_b] -= bodies[c.slot_b].weight * less;
            c.impulse *= keep;
            if constexpr (std::remove_cvref_t<decltype(contacts)>::rubs) c.rubbing *= keep;
            any = true;
        });
        return any;
    }

    std::vector<Raw> nets_;        // by slot: what impulses do to a body together, m/s
    std::vector<Overpushed> over_; // by slot
};

} // namespace ansatz
