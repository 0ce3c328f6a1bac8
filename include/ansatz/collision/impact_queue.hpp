// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ImpactQueue`: bodies that travel through a step along straight lines, and their first touches in the order of time
/// (notes 2.1.2). It knows shapes and places, and nothing of a world, so that all worlds with the same space and
/// narrowphase compile it once.
///
/// A body is *fast* where it moves by more than a quarter of its smallest extent. The earliest touch stops its bodies,
/// and what that changes for their other pairs is computed anew, until no touch is left.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/narrowphase/first_touch.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// Lets bodies travel, and stops those that meet.
/// \tparam S           the space
/// \tparam Narrowphase of the world
template <class S, class Narrowphase> class ImpactQueue {
public:
    using Scalar = typename S::Scalar;
    using Point = typename S::Position;                      ///< m
    using Shapes = typename Narrowphase::template Shapes<S>; ///< by kind

    /// A body: from `since` on it is at `at` and moves at `rate`. Times are fractions of the step.
    struct Traveller {
        std::uint32_t id;                ///< of the body
        std::uint32_t slot;              ///< its slot
        bool stops;                      ///< where it meets another; a body that a program moves does not
        bool fast;                       ///< moves by more than a quarter of its smallest extent
        bool sensor;                     ///< only notices
        Point at;                        ///< where it is at `since`, m
        Point rate;                      ///< how far it moves in a whole step, m
        Scalar since{0};                 ///< when its motion changed last
        Scalar lost{0};                  ///< what was left of the step when it was stopped first
        Point stopped_at{};              ///< where that was, m
        int count = 0;                   ///< how often it was stopped
        std::uint32_t version = 0;       ///< of its motion
        std::uint32_t first_link = none; ///< of its pairs
    };
    /// Two that have met.
    struct Impact {
        std::uint32_t a;     ///< the smaller id
        std::uint32_t b;     ///< the other
        FirstTouch<S> first; ///< its arm is the place, m
    };

    std::vector<Traveller> travellers; ///< those with a box in the order of `boxes`, then those without
    Boxes<S> boxes;                    ///< around their ways, the fast first
    std::vector<Impact> impacts;       ///< by the time

    /// Room for so many bodies.
    void reserve(std::size_t n) {
        boxes.reserve(n);
        travellers.reserve(n);
        slow_.reserve(n);
    }
    /// No body travels, and none have met.
    void clear() {
        boxes.clear();
        travellers.clear();
        slow_.clear();
        pairs_.clear();
        impacts.clear();
    }
    /// A body that goes: to the boxes if it is fast, else to those that `add_slow` adds.
    void add(const Shapes& shapes, Traveller t) {
        shapes.visit(t.id, [&](const auto& shape) {
            if constexpr (std::remove_cvref_t<decltype(shape)>::description::bounded) {
                t.fast = robust_norm(t.rate).value() > half_extent(shape) / 4;
                t.fast ? enter(shapes, t) : slow_.push_back(t);
            }
        });
    }
    /// The fast are complete: what is found follows from them. The slow come behind them.
    /// \return whether any body is fast
    bool add_slow(const Shapes& shapes) {
        boxes.set_active(travellers.size());
        if (travellers.empty()) return false;
        for (const auto& t : slow_) enter(shapes, t);
        return true;
    }
    /// A body with its box, if it has one and that is finite; World::status tells of those that are not.
    void enter(const Shapes& shapes, const Traveller& t) {
        shapes.visit(t.id, [&](const auto& shape) {
            if constexpr (std::remove_cvref_t<decltype(shape)>::description::bounded) {
                Point lower, upper, lower_then, upper_then;
                shape.bounds(t.at, lower, upper);
                shape.bounds(t.at + t.rate, lower_then, upper_then);
                for (auto* corner : {&lower, &upper, &lower_then, &upper_then})
                    if (!is_finite(*corner)) return;
                auto low = lower.value(), high = upper.value();
                for (int k = 0; k < S::dimension; ++k)
                    low[k] = min(low[k], lower_then.value()[k]), high[k] = max(high[k], upper_then.value()[k]);
                boxes.push_back(Point::from_value(low), Point::from_value(high));
                travellers.push_back(t);
            }
        });
    }
    /// Two that may meet, by their places in `travellers`; `a` is that of the smaller id.
    void add_pair(std::uint32_t a, std::uint32_t b) {
        const auto number = std::uint32_t(pairs_.size());
        pairs_.push_back({a, b, travellers[a].first_link, travellers[b].first_link});
        travellers[a].first_link = travellers[b].first_link = number;
    }
    /// Lets all of them travel, and stops those that meet.
    /// \param pushed   whether they were moved by a response, which may put them into each other as long as none passes
    ///                 another
    /// \param by_force whether bodies are stopped a sixteenth of their thickness deep in each other, where a penalty force
    ///                 sees them, and not at the first touch
    void follow(const Shapes& shapes, bool pushed, bool by_force) {
        pushed_ = pushed;
        by_force_ = by_force;
        events_.clear();
        for (std::size_t p = 0; p < pairs_.size(); ++p) find_touch(shapes, std::uint32_t(p), Scalar(0));
        while (!events_.empty()) {
            std::pop_heap(events_.begin(), events_.end());
            const Event e = events_.back();
            events_.pop_back();
            const Pair& pair = pairs_[e.pair];
            auto &a = travellers[pair.a], &b = travellers[pair.b];
            if (e.version_a != a.version || e.version_b != b.version) continue;
            impacts.push_back({e.a, e.b, e.first});
            impacts.back().first.arm += a.at + (e.time - a.since) * a.rate; // the place
            if (a.sensor || b.sensor) continue;
            const bool stop_a = a.stops && (a.fast || !b.stops), stop_b = b.stops && (b.fast || !a.stops);
            const Point rate_a = a.rate, rate_b = b.rate, still = S::template zero_vector<unit::Length>();
            if (stop_a) stop(a, e.time, stop_b ? still : rate_b);
            if (stop_b) stop(b, e.time, stop_a ? still : rate_a);
            if (stop_a) look_again(shapes, pair.a, e.time);
            if (stop_b) look_again(shapes, pair.b, e.time);
        }
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr int most_stops = 8; // in one step, of a body that lies between platforms

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
    static void stop(Traveller& t, const Scalar& time, const Point& rate) {
        t.at += (time - t.since) * t.rate;
        t.since = time;
        t.rate = rate;
        t.fast = true; // a body that is taken along stops at the next
        if (t.count++ == 0) t.stopped_at = t.at, t.lost = max(Scalar(1) - time, std::numeric_limits<Scalar>::min());
        ++t.version;
    }
    void look_again(const Shapes& shapes, std::uint32_t i, const Scalar& time) {
        for (auto p = travellers[i].first_link; p != none; p = pairs_[p].a == i ? pairs_[p].next_a : pairs_[p].next_b)
            find_touch(shapes, p, time);
    }
    /// When the two of a pair first touch, from a time on.
    void find_touch(const Shapes& shapes, std::uint32_t p, const Scalar& from) {
        const auto &a = travellers[pairs_[p].a], &b = travellers[pairs_[p].b];
        if (a.count >= most_stops || b.count >= most_stops) return;
        const Scalar left = Scalar(1) - from;
        const Point between = (a.at + (from - a.since) * a.rate) - (b.at + (from - b.since) * b.rate),
                    motion = left * Point(a.rate - b.rate);
        Event e{from, a.id, b.id, p, a.version, b.version, {}};
        bool there = false;
        Narrowphase::template with_both<S>(shapes, a.id, b.id, [&](const auto& one, const auto& other) {
            using A = std::remove_cvref_t<decltype(one)>;
            using B = std::remove_cvref_t<decltype(other)>;
            if constexpr (detail::can_sweep<A, B, S>)
                there = must_stop(one, other, between, motion, a.sensor || b.sensor, e.first);
        });
        if (!there) return;
        e.time = from + left * e.first.time;
        events_.push_back(e);
        std::push_heap(events_.begin(), events_.end());
    }
    /// Whether a motion has to be stopped, and when.
    template <class A, class B>
    bool must_stop(const A& a, const B& b, const Point& between, const Point& motion, bool notices,
                   FirstTouch<S>& first) const {
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
            (inside || pushed_ || after.depth.value() <= thick / 4))
            return false;
        if (!inside) {
            FirstTouch<S> outer;
            if (!by_force_ && detail::touch_first<S>(a, b, between, motion, Length::from_value(Scalar(0)), outer))
                first = outer;
            return true;
        }
        if (!(dot(motion.value(), before.normal) < Scalar(0))) return false;
        first.time = Scalar(0);
        first.normal = before.normal;
        first.arm = before.point - between;
        return true;
    }

    std::vector<Traveller> slow_;
    std::vector<Pair> pairs_;
    std::vector<Event> events_;
    bool pushed_ = false, by_force_ = false;
};

} // namespace ansatz
