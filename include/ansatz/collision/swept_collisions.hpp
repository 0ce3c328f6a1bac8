// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SweptCollisions`: the collisions of a world whose narrowphase is `Swept`: which bodies are stopped, and where
/// (notes 2.1.2).
///
/// A body is *fast* where it moves by more than a quarter of its smallest extent. Boxes that hold the whole motion of
/// the fast bodies are given to the broadphase; of each pair the first touch is computed; the earliest stops its
/// bodies, and what that changes for their other pairs is computed anew, until no touch is left. So nothing passes
/// anything, however many meet at once.
///
/// - Two that would be in each other at the end of the step, less than a quarter deep and on the right side, are left
///   to the discrete functions: what lies or rolls is treated as it is without `Swept`.
/// - A fast body that meets a slow one stops and goes along with it, so that a hail of bullets does not hold up a
///   crate.
/// - Ties are broken by the ids of the bodies. All that is kept here is a cache: it lives within one step.

#include <ansatz/collision/collisions.hpp>
#include <ansatz/collision/narrowphase/first_touch.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
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
            detail::reserve_each(n, w.moved, w.travellers, w.slow, w.boxes, w.finder);
        }
    }
    /// Where everybody is before they move.
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
        auto& w = sweep_.value;
        w.pushed = pushed;
        w.impacts.clear();
        gather(data);
        if (w.boxes.active() == 0) return;
        find_pairs(data, policies);
        follow();
        for (const auto& t : w.travellers)
            if (t.lost > Scalar(0)) place(t.slot, Point(t.at + (Scalar(1) - t.since) * t.rate), t.stopped_at, t.lost);
    }
    /// Those that were held back are in contact, whether the discrete functions see it or not.
    template <class Data> void add_impacts(const Data& data, std::vector<Contact<S>>& found) {
        auto& w = sweep_.value;
        for (const auto& hit : w.impacts) {
            Contact<S> contact;
            contact.first = data.bodies.handle(data.bodies.slot_of_id(hit.a));
            contact.second = data.bodies.handle(data.bodies.slot_of_id(hit.b));
            contact.normal = hit.first.normal;
            contact.point = hit.first.arm;
            found.push_back(contact);
        }
        w.impacts.clear();
    }
    /// None of them is to be told.
    void forget_impacts() { sweep_.value.impacts.clear(); }
    /// The parameters of the broadphase have changed.
    void new_broadphase() {
        Base::new_broadphase();
        sweep_.value.finder.reset();
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr int most_stops = 8; // in one step, of a body that lies between platforms
    /// Whether only forces part bodies, so that they have to be in each other.
    static constexpr bool by_force = C::template responses<Level::velocities>::size == 0 && !C::substeps &&
                                     C::template responses<Level::accelerations>::size > 0;

    struct Moved {
        std::uint32_t id;
        Point from;
    };
    /// A body: from `since` on it is at `at` and moves at `rate`.
    struct Traveller {
        std::uint32_t id, slot;
        bool stops, fast, sensor;
        Point at, rate;
        Scalar since{0}, lost{0};
        Point stopped_at{};
        int count = 0;
        std::uint32_t version = 0, first_link = none;
    };
    struct Pair {
        std::uint32_t a, b;           // of the travellers; a has the smaller id
        std::uint32_t next_a, next_b; // pairs of the same traveller
    };
    struct Event {
        Scalar time;
        std::uint32_t a, b, pair, version_a, version_b; // a, b: ids
        FirstTouch<S> first;
        friend bool operator<(const Event& x, const Event& y) { // of a heap: the last one is the earliest
            if (x.time != y.time) return x.time > y.time;
            return std::pair(x.a, x.b) > std::pair(y.a, y.b);
        }
    };
    struct Working {
        std::vector<Moved> moved;
        std::vector<Traveller> travellers, slow;
        Boxes<S> boxes;
        std::optional<typename Broadphase::template In<S>> finder;
        std::vector<Pair> pairs;
        std::vector<Event> events;
        std::vector<Event> impacts;
        bool pushed = false;
    };

    /// Half of the smallest extent of a shape, m; nothing for one without end.
    template <class Shape> static Scalar half_extent(const Shape& shape) {
        if constexpr (Shape::description::bounded) {
            Point lower, upper;
            shape.bounds(S::template zero_vector<unit::Length>(), lower, upper);
            Scalar least = upper.value()[0] - lower.value()[0];
            for (int k = 1; k < S::dimension; ++k) least = min(least, Scalar(upper.value()[k] - lower.value()[k]));
            return least / 2;
        } else return std::numeric_limits<Scalar>::max();
    }
    /// How deep two may be in each other, about, before they are pushed out on the wrong side: a sphere by its radius.
    template <class A, class B> static Scalar thickness(const A& a, const B& b) {
        if constexpr (requires {
                          a.radius;
                          b.radius;
                      })
            return min(a.radius.value(), b.radius.value());
        else if constexpr (requires { a.radius; }) return a.radius.value();
        else if constexpr (requires { b.radius; }) return b.radius.value();
        else return min(half_extent(a), half_extent(b));
    }

    /// Everybody, and the boxes of those that have one: the fast first, each around the way from where it was.
    template <class Data> void gather(const Data& data) {
        auto& w = sweep_.value;
        w.boxes.clear();
        w.travellers.clear();
        w.slow.clear();
        for (const auto& m : w.moved) {
            const auto slot = data.bodies.slot_of_id(m.id);
            Traveller t = traveller(data, slot, data.bodies.motion(slot) == Motion::awake);
            const Point now = t.at;
            t.at = m.from;
            t.rate = now - m.from;
            this->shapes.visit(m.id, [&](const auto& shape) {
                if constexpr (std::remove_cvref_t<decltype(shape)>::description::bounded) {
                    t.fast = robust_norm(t.rate).value() > half_extent(shape) / 4;
                    t.fast ? enter(t) : w.slow.push_back(t);
                }
            });
        }
        w.boxes.set_active(w.travellers.size());
        if (w.travellers.empty()) return;
        for (const auto& t : w.slow) enter(t);
        for (const auto motion : {Motion::resting, Motion::fixed})
            for (std::size_t slot = data.bodies.begin(motion); slot < data.bodies.end(motion); ++slot)
                if (this->shapes.bounded(data.bodies.id(slot))) enter(traveller(data, std::uint32_t(slot), false));
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
    void enter(const Traveller& t) {
        auto& w = sweep_.value;
        this->shapes.visit(t.id, [&](const auto& shape) {
            if constexpr (std::remove_cvref_t<decltype(shape)>::description::bounded) {
                Point lower, upper, lower_then, upper_then;
                shape.bounds(t.at, lower, upper);
                shape.bounds(t.at + t.rate, lower_then, upper_then);
                for (auto* corner : {&lower, &upper, &lower_then, &upper_then})
                    if (!is_finite(*corner)) return; // World::status tells of it
                auto low = lower.value(), high = upper.value();
                for (int k = 0; k < S::dimension; ++k)
                    low[k] = min(low[k], lower_then.value()[k]), high[k] = max(high[k], upper_then.value()[k]);
                w.boxes.push_back(Point::from_value(low), Point::from_value(high));
                w.travellers.push_back(t);
            }
        });
    }

    template <class Data, class Policies> void find_pairs(const Data& data, const Policies& policies) {
        auto& w = sweep_.value;
        w.boxes.set_active(w.boxes.size() < w.boxes.active() ? w.boxes.size() : w.boxes.active());
        w.pairs.clear();
        if (!w.finder) detail::make_finder<Base::divides>(w.finder, std::get<Broadphase>(policies), w.moved.capacity());
        // A broadphase may name pairs whose boxes are apart (AllPairs does). A body that a platform takes along leaves
        // its box, and would meet more bodies with such a broadphase than with another.
        w.finder->find(w.boxes, [&](std::size_t i, std::size_t j) {
            if (w.boxes.touch(i, j)) pair(data, policies, std::uint32_t(i), std::uint32_t(j));
        });
        if constexpr (Narrowphase::any_unbounded)
            Narrowphase::for_each_kind([&]<class Kind>() {
                if constexpr (!Kind::bounded)
                    for (const auto id : this->shapes.template owners<Kind>()) {
                        const auto slot = data.bodies.slot_of_id(id);
                        Traveller t = traveller(data, slot, false);
                        for (const auto& m : w.moved)
                            if (m.id == id) t.rate = t.at - m.from, t.at = m.from;
                        w.travellers.push_back(t);
                        for (std::size_t i = 0; i < w.boxes.active(); ++i)
                            pair(data, policies, std::uint32_t(i), std::uint32_t(w.travellers.size() - 1));
                    }
            });
    }
    template <class Data, class Policies>
    void pair(const Data& data, [[maybe_unused]] const Policies& policies, std::uint32_t i, std::uint32_t j) {
        auto& w = sweep_.value;
        if (w.travellers[j].id < w.travellers[i].id) std::swap(i, j);
        auto &a = w.travellers[i], &b = w.travellers[j];
        if (!a.stops && !b.stops) return;
        if (this->were_one(a.id, b.id)) return;
        if constexpr (C::filters::size > 0)
            if (!Base::passes(data, policies, a.slot, b.slot, typename C::filters{})) return;
        const auto number = std::uint32_t(w.pairs.size());
        w.pairs.push_back({i, j, a.first_link, b.first_link});
        a.first_link = b.first_link = number;
    }

    /// Lets all of them travel, and stops those that meet.
    void follow() {
        auto& w = sweep_.value;
        w.events.clear();
        for (std::size_t p = 0; p < w.pairs.size(); ++p) look(std::uint32_t(p), Scalar(0));
        while (!w.events.empty()) {
            std::pop_heap(w.events.begin(), w.events.end());
            const Event e = w.events.back();
            w.events.pop_back();
            auto &a = w.travellers[w.pairs[e.pair].a], &b = w.travellers[w.pairs[e.pair].b];
            if (e.version_a != a.version || e.version_b != b.version) continue;
            w.impacts.push_back(e);
            w.impacts.back().first.arm += a.at + (e.time - a.since) * a.rate; // the place
            if (a.sensor || b.sensor) continue;
            const bool stop_a = a.stops && (a.fast || !b.stops), stop_b = b.stops && (b.fast || !a.stops);
            const Point rate_a = a.rate, rate_b = b.rate;
            if (stop_a) stop(a, e.time, stop_b ? Point(S::template zero_vector<unit::Length>()) : rate_b);
            if (stop_b) stop(b, e.time, stop_a ? Point(S::template zero_vector<unit::Length>()) : rate_a);
            if (stop_a) look_again(w.pairs[e.pair].a, e.time);
            if (stop_b) look_again(w.pairs[e.pair].b, e.time);
        }
    }
    static void stop(Traveller& t, const Scalar& time, const Point& rate) {
        t.at += (time - t.since) * t.rate;
        t.since = time;
        t.rate = rate;
        t.fast = true; // a body that is taken along stops at the next
        if (t.count++ == 0) t.stopped_at = t.at, t.lost = max(Scalar(1) - time, std::numeric_limits<Scalar>::min());
        ++t.version;
    }
    void look_again(std::uint32_t i, const Scalar& time) {
        auto& w = sweep_.value;
        for (auto p = w.travellers[i].first_link; p != none;
             p = w.pairs[p].a == i ? w.pairs[p].next_a : w.pairs[p].next_b)
            look(p, time);
    }
    /// When the two of a pair first touch, from a time on.
    void look(std::uint32_t p, const Scalar& from) {
        auto& w = sweep_.value;
        const auto &a = w.travellers[w.pairs[p].a], &b = w.travellers[w.pairs[p].b];
        if (a.count >= most_stops || b.count >= most_stops) return;
        const Scalar left = Scalar(1) - from;
        const Point between = (a.at + (from - a.since) * a.rate) - (b.at + (from - b.since) * b.rate),
                    motion = left * Point(a.rate - b.rate);
        Event e{from, a.id, b.id, p, a.version, b.version, {}};
        bool there = false;
        Narrowphase::template with_both<S>(this->shapes, a.id, b.id, [&](const auto& one, const auto& other) {
            using A = std::remove_cvref_t<decltype(one)>;
            using B = std::remove_cvref_t<decltype(other)>;
            if constexpr (detail::can_sweep<A, B, S>)
                there = stops(one, other, between, motion, a.sensor || b.sensor, w.pushed, e.first);
        });
        if (!there) return;
        e.time = from + left * e.first.time;
        w.events.push_back(e);
        std::push_heap(w.events.begin(), w.events.end());
    }
    /// Whether a motion has to be stopped, and when.
    template <class A, class B>
    static bool stops(const A& a, const B& b, const Point& between, const Point& motion, bool notices, bool pushed,
                      FirstTouch<S>& first) {
        using Length = typename S::Length;
        const Point origin = S::template zero_vector<unit::Length>();
        Touch<S> before, after;
        const bool inside = detail::intersect<S>(a, between, b, origin, before);
        if (notices && inside) return false;
        const Scalar thick = thickness(a, b);
        Length deeper = Length::from_value(thick / 16);
        if (inside) deeper += before.depth;
        if (!detail::touch_first<S>(a, b, between, motion, deeper, first)) return false;
        const bool in_the_end = detail::intersect<S>(a, Point(between + motion), b, origin, after);
        if (in_the_end && dot(after.normal, inside ? before.normal : first.normal) > Scalar(0.5) &&
            (inside || pushed || after.depth.value() <= thick / 4))
            return false;
        if (!inside) {
            FirstTouch<S> outer;
            if (!by_force && detail::touch_first<S>(a, b, between, motion, Length::from_value(Scalar(0)), outer))
                first = outer;
            return true;
        }
        if (!(dot(motion.value(), before.normal) < Scalar(0))) return false;
        first.time = Scalar(0);
        first.normal = before.normal;
        first.arm = before.point - between;
        return true;
    }

    detail::Cache<Working> sweep_;
};

} // namespace ansatz
