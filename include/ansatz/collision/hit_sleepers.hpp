// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `HitSleepers`: which sleeping bodies will be hit in a substep, by a response that owns substeps. (Beyond the
/// notes.)
///
/// Such a response stops what comes near before it touches. A sleeper would take that like a wall and sleep on: so it
/// wakes before it is hit, or behind the substep in which another was pushed into it.

#include <ansatz/collision/contact_step.hpp>
#include <ansatz/motion/rest_step.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ansatz {

/// The sleepers that are hit in a substep.
/// \tparam C        the composition
/// \tparam Contacts what the response keeps of them
template <class C, class Contacts> class HitSleepers {
public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot; ///< a body's place in the lanes

    /// Of a substep of length `dt`, whose bodies have been gathered into `contacts`.
    HitSleepers(WorldData<C>& data, Contacts& contacts, const typename S::Time& dt)
        : data_(data), contacts_(contacts), dt_(dt), h_(dt.value()) {}

    /// \return whether any was woken
    bool wake() {
        if (data_.bodies.count(Motion::resting) == 0) return false;
        auto& hit = data_.sleep.value.sleepers;
        hit.clear();
        find(hit);
        if (hit.empty()) return false;
        for (const auto id : hit)
            if (const auto slot = data_.bodies.slot_of_id(id); rests(slot)) wake_resting(data_, slot);
        data_.collisions.wake_contacts(data_);
        return true;
    }

private:
    // In substeps, and more than one, for what others add to a speed: a body that is woken in vain falls asleep again.
    static constexpr double ahead = 1.25;
    static constexpr int noted = -1; // instead of a speed: a sleeper that has been found

    bool rests(Slot slot) const { return data_.bodies.motion(slot) == Motion::resting; }
    /// Into `hit`, each once.
    void find(auto& hit) {
        bool near = false; // whether any sleeper is near to a body that moves
        contacts_.each_acting([&](const auto& c) { near = near || rests(Slot(c.slot_a)) || rests(Slot(c.slot_b)); });
        if (!near) return;
        auto& struck = data_.sleep.value.struck;
        if (struck.size() < data_.bodies.size()) struck.resize(data_.bodies.size());
        contacts_.each_acting([&](const auto& c) { struck[c.slot_a] = struck[c.slot_b] = Scalar(0); });
        find_touched(struck, hit);
        if (find_strikers(struck)) find_struck(struck, hit);
    }
    /// Those that are pressed already, or touched before the substep ends.
    void find_touched(auto& struck, auto& hit) {
        contacts_.each_acting([&](const auto& c) {
            const bool a_rests = rests(Slot(c.slot_a));
            if (!a_rests && !rests(Slot(c.slot_b))) return;
            const Scalar way = Scalar(ahead) * h_ * contacts_.along(c);
            if (!(c.impulse > Scalar(0)) && !(contacts_.apart(c) + way < Scalar(0))) return;
            if (data_.collisions.has_contact(c.a, c.b)) return;
            auto& mark = struck[a_rests ? c.slot_a : c.slot_b];
            if (mark == Scalar(0)) hit.push_back(a_rests ? c.a : c.b);
            mark = Scalar(noted);
        });
    }
    /// Bodies that meet another one before the substep ends: with what that gives them, they may be as fast as twice
    /// their approach.
    /// \return whether there are any
    bool find_strikers(auto& struck) const {
        bool any = false;
        contacts_.each_acting([&](const auto& c) {
            const Scalar approach = -contacts_.along(c);
            if (c.impulse > Scalar(0) || !(contacts_.apart(c) < Scalar(ahead) * h_ * approach)) return;
            for (const auto& [one, other] : {std::pair(c.slot_a, c.slot_b), std::pair(c.slot_b, c.slot_a)})
                if (data_.bodies.motion(one) == Motion::awake && disturbs(data_, Slot(other), false, dt_)) {
                    struck[one] = std::max(struck[one], 2 * approach);
                    any = true;
                }
        });
        return any;
    }
    /// Sleepers that those are about to be struck into, and others that these are.
    void find_struck(auto& struck, auto& hit) {
        bool more = true;
        while (std::exchange(more, false))
            contacts_.each_acting([&](const auto& c) {
                const auto reached = [&](Slot from, Slot to) {
                    if (!(struck[from] > std::max(struck[to], Scalar(0)))) return;
                    if (to >= data_.bodies.end(Motion::resting)) return;
                    if (!(contacts_.apart(c) < Scalar(ahead) * h_ * struck[from])) return;
                    if (rests(to) && struck[to] == Scalar(0)) hit.push_back(data_.bodies.id(to));
                    struck[to] = struck[from];
                    more = true;
                };
                reached(Slot(c.slot_a), Slot(c.slot_b));
                reached(Slot(c.slot_b), Slot(c.slot_a));
            });
    }

    WorldData<C>& data_;
    Contacts& contacts_;
    typename S::Time dt_;
    Scalar h_; // s, the same
};

} // namespace ansatz
