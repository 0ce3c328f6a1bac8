// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SweptCollisions`: the collisions of a world whose narrowphase is `Swept`: which bodies are stopped, and where
/// (notes 2.1.2).
///
/// A body is *fast* where it moves by more than a quarter of its smallest extent. Boxes that hold the whole motion of
/// the fast bodies are given to the broadphase; of each pair the first touch is computed; the earliest stops its
/// bodies, and what that changes for their other pairs is computed anew, until no touch is left (impact_queue.hpp). So
/// nothing passes anything, however many meet at once.
///
/// - Two that would be in each other at the end of the step, less than a quarter deep and on the right side, are left
///   to the discrete functions: what lies or rolls is treated as it is without `Swept`.
/// - A fast body that meets a slow one stops and goes along with it, so that a hail of bullets does not hold up a
///   crate.
/// - Ties are broken by the ids of the bodies. All that is kept here is a cache: it lives within one step.

#include <ansatz/collision/collisions.hpp>
#include <ansatz/collision/impact_queue.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam C the world's composition
template <class C> class SweptCollisions : public Collisions<C> {
    using Base = Collisions<C>;

public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Point = typename S::Position;          ///< m
    using Narrowphase = typename C::Narrowphase; ///< of the world
    using Broadphase = typename C::Broadphase;   ///< of the world

    /// Room for so many bodies.
    void reserve(std::size_t n) {
        Base::reserve(n);
        if constexpr (Base::divides) {
            auto& w = sweep_.value;
            detail::reserve_each(n, w.moved, w.queue, w.finder);
        }
    }
    /// Where bodies are before they move.
    template <class Data> void remember(const Data& data) {
        auto& moved = sweep_.value.moved;
        moved.clear();
        for (const auto motion : {Motion::awake, Motion::moving})
            for (std::size_t slot = data.bodies.begin(motion); slot < data.bodies.end(motion); ++slot)
                moved.push_back({data.bodies.id(slot), data.lanes.template get<Position>(slot)});
    }
    /// Finds the bodies that have passed another, or come too deep into it, since `remember`.
    /// \param pushed whether they were moved by a response, which may put them into each other as long as none
    ///               passes another
    /// \param place  called as `place(slot, to, where, lost)` for each body that is kept: it ends at `to`; it was
    ///               stopped at `where`, with the share `lost` of its motion left
    template <class Data, class Policies, class SetPlace>
    void hold_back(const Data& data, const Policies& policies, bool pushed, SetPlace&& place) {
        auto& queue = sweep_.value.queue;
        if (!gather(data)) return;
        find_pairs(data, policies);
        queue.follow(this->shapes, pushed, by_force);
        for (const auto& t : queue.travellers)
            if (t.lost > Scalar(0)) place(t.slot, Point(t.at + (Scalar(1) - t.since) * t.rate), t.stopped_at, t.lost);
    }
    /// Those that were held back are in contact, whether the discrete functions see it or not.
    template <class Data> void add_impacts(const Data& data, std::vector<Contact<S>>& found) {
        for (const auto& hit : sweep_.value.queue.impacts) {
            Contact<S> contact;
            contact.first = data.bodies.handle(data.bodies.slot_of_id(hit.a));
            contact.second = data.bodies.handle(data.bodies.slot_of_id(hit.b));
            contact.normal = hit.first.normal;
            contact.point = hit.first.arm;
            detail::append(found, contact);
        }
        forget_impacts();
    }
    /// None of them is to be told.
    void forget_impacts() { sweep_.value.queue.impacts.clear(); }
    /// The parameters of the broadphase have changed.
    void new_broadphase() {
        Base::new_broadphase();
        sweep_.value.finder.reset();
    }

private:
    using Queue = ImpactQueue<S, Narrowphase>;
    using Traveller = typename Queue::Traveller;
    /// Whether only forces separate bodies, so that they have to be in each other.
    static constexpr bool by_force = C::template responses<Level::velocities>::size == 0 && !C::substeps &&
                                     C::template responses<Level::accelerations>::size > 0;

    struct Moved {
        std::uint32_t id;
        Point from;
    };
    struct Working {
        std::vector<Moved> moved;
        Queue queue;
        std::optional<typename Broadphase::template In<S>> finder;
    };

    /// All bodies, and the boxes of those that have one: the fast first, each around the way from where it was.
    /// \return whether any body is fast
    template <class Data> bool gather(const Data& data) {
        auto& w = sweep_.value;
        w.queue.clear();
        for (const auto& m : w.moved) {
            const auto slot = data.bodies.slot_of_id(m.id);
            Traveller t = traveller(data, slot, data.bodies.motion(slot) == Motion::awake);
            const Point now = t.at;
            t.at = m.from;
            t.rate = now - m.from;
            w.queue.add(this->shapes, t);
        }
        if (!w.queue.add_slow(this->shapes)) return false;
        for (const auto motion : {Motion::resting, Motion::fixed})
            for (std::size_t slot = data.bodies.begin(motion); slot < data.bodies.end(motion); ++slot)
                if (this->shapes.bounded(data.bodies.id(slot)))
                    w.queue.enter(this->shapes, traveller(data, std::uint32_t(slot), false));
        return true;
    }
    template <class Data> Traveller traveller(const Data& data, std::uint32_t slot, bool stops) const {
        const auto id = data.bodies.id(slot);
        return {id,
                slot,
                stops,
                false,
                this->is_sensor(id),
                data.lanes.template get<Position>(slot),
                S::template zero_vector<unit::Length>()};
    }
    template <class Data, class Policies> void find_pairs(const Data& data, const Policies& policies) {
        auto& w = sweep_.value;
        auto& boxes = w.queue.boxes;
        if (!w.finder) detail::make_finder<Base::divides>(w.finder, std::get<Broadphase>(policies), w.moved.capacity());
        // A broadphase may name pairs whose boxes are apart (AllPairs does). A body that a platform takes along leaves
        // its box, and would meet more bodies with such a broadphase than with another.
        w.finder->find(boxes, [&](std::size_t i, std::size_t j) {
            if (boxes.touch(i, j)) pair(data, policies, std::uint32_t(i), std::uint32_t(j));
        });
        if constexpr (Narrowphase::any_unbounded)
            Narrowphase::for_each_kind([&]<class Kind>() {
                if constexpr (!Kind::bounded)
                    for (const auto id : this->shapes.template owners<Kind>()) {
                        const auto slot = data.bodies.slot_of_id(id);
                        Traveller t = traveller(data, slot, false);
                        for (const auto& m : w.moved)
                            if (m.id == id) t.rate = t.at - m.from, t.at = m.from;
                        w.queue.travellers.push_back(t);
                        for (std::size_t i = 0; i < boxes.active(); ++i)
                            pair(data, policies, std::uint32_t(i), std::uint32_t(w.queue.travellers.size() - 1));
                    }
            });
    }
    template <class Data, class Policies>
    void pair(const Data& data, [[maybe_unused]] const Policies& policies, std::uint32_t i, std::uint32_t j) {
        const auto& all = sweep_.value.queue.travellers;
        if (all[j].id < all[i].id) std::swap(i, j);
        const auto &a = all[i], &b = all[j];
        if (!a.stops && !b.stops) return;
        if (this->were_one(a.id, b.id)) return;
        if (!detail::pass<S>(policies, data, a.slot, b.slot, typename C::filters{})) return;
        sweep_.value.queue.add_pair(i, j);
    }

    detail::Cache<Working> sweep_;
};

} // namespace ansatz
