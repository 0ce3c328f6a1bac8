// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `NearContacts`: the pairs that all but touch: what pulls at them, or their speed, closes the gap within a step.
/// Where contacts are answered together they are held as well. Otherwise a pile that was separated exactly would lie on
/// its lowest bodies alone, and a body that is separated from one that it ran into would be pushed into the next.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/bodies.hpp>
#include <ansatz/world/columns.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
struct NoNear {}; // in its place
} // namespace detail

/// The pairs of a step; it keeps its room.
template <class S> class NearContacts {
public:
    using Scalar = typename S::Scalar;
    std::vector<Contact<S>> all; ///< their depth is negative, or zero where they touch
    Scalar step{};               ///< s, which was taken

    /// Room for so many bodies.
    void reserve(std::size_t n) { reach_.reserve(n); }
    /// How far each body is taken.
    /// \param pull     a function of a slot: the acceleration of an awake body, m/s^2
    /// \param velocity a function of a slot: its velocity, m/s
    template <class Pull, class Going> void begin(const Bodies& bodies, const Pull& pull, const Going& velocity) {
        if (reach_.size() < bodies.size()) reach_.resize(bodies.size());
        const auto reach_before = std::exchange(reached_, bodies.end(Motion::awake));
        for (std::size_t slot = reached_; slot < std::min(reach_before, reach_.size()); ++slot) reach_[slot] = Reach();
        for (std::size_t slot = 0; slot < bodies.end(Motion::awake); ++slot) {
            auto& reach = reach_[slot];
            reach.pulled = norm(pull(Bodies::Slot(slot))).value() * step * step;
            // Twice its way: a body that is separated from one that came towards it is moved by both of their ways.
            const Scalar way = norm(velocity(Bodies::Slot(slot))).value() * step;
            reach.all = reach.pulled + Scalar(2) * std::max(Scalar(0), way - reach.pulled);
        }
    }
    /// A body's box, made as much larger. It is not widened by more than it is thick: a faster body goes through
    /// others in a step, or is detected continuously.
    void widen(std::size_t slot, typename S::Position& lower, typename S::Position& upper) {
        auto& reach = reach_[slot];
        const Scalar thick = (upper - lower).value().minCoeff() / Scalar(2);
        reach.all = std::max(reach.pulled, std::min(reach.all, reach.pulled + thick));
        auto by = lower.value();
        for (int k = 0; k < S::dimension; ++k) by[k] = reach.all;
        lower -= S::Position::from_value(by);
        upper += S::Position::from_value(by);
    }
    /// Tests two that do not intersect.
    /// \param near to which they are added if they nearly touch
    template <class Narrowphase, class Data>
    void test(const Data& data, std::uint32_t a, std::size_t slot_a, std::uint32_t b, std::size_t slot_b,
              std::vector<Contact<S>>& near) const {
        const Scalar margin = reach_[slot_a].all + reach_[slot_b].all;
        if (!(margin > Scalar(0))) return;
        auto xa = data.lanes.template get<Position>(slot_a), xb = data.lanes.template get<Position>(slot_b);
        // One of them is made larger, and which one changes the last bits: not the ids decide it, but the places.
        int k = 0;
        while (k + 1 < S::dimension && xa.value()[k] == xb.value()[k]) ++k;
        const bool turned = xb.value()[k] < xa.value()[k];
        if (turned) std::swap(xa, xb);
        Contact<S> contact;
        if (!Narrowphase::template nearly_collide<S>(data.collisions.shapes, turned ? b : a, xa, turned ? a : b, xb,
                                                     S::Length::from_value(margin), contact))
            return;
        if (turned) contact.normal = -contact.normal;
        if (-contact.depth.value() <= (reach_[slot_a].pulled + reach_[slot_b].pulled) / 64)
            contact.depth = {}; // they touch; a little apart is what separating them left
        contact.first = data.bodies.handle(slot_a);
        contact.second = data.bodies.handle(slot_b);
        detail::append(near, contact);
    }

private:
    struct Reach {
        Scalar pulled{}; // by what pulls at it, m
        Scalar all{};    // by that or its velocity, m
    };
    std::vector<Reach> reach_; // by slot
    std::size_t reached_ = 0;  // those of slots behind are zero
};

} // namespace ansatz
