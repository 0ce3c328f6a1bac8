// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Buckets`: the open list as a ring of buckets, each for a span of f; two to four times as fast as a heap.
///
/// Putting in and taking out cost the same however long the list is. What lies in one bucket comes out last in, first
/// out, so that the order is right only to a bucket's width. The search makes good for it: it opens nodes again, and
/// when the goal has come out it goes on until nothing cheaper can be left. The answer is as exact as with a heap. It
/// needs `Reopening`, which is the default; `NoReopening` is refused in a sentence.
///
/// The best width is a fraction of the cheapest usual edge: too wide and nodes are expanded twice, too narrow and empty
/// buckets are looked at. A grid says its own; for other graphs it is the first argument, in the unit of the weights.
///
/// \see R. B. Dial, "Algorithm 360: shortest-path forest with topological ordering", Comm. ACM 12 (1969).

#include <ansatz/core/error.hpp>
#include <ansatz/paths/cost.hpp>
#include <ansatz/units/describe.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// The open list as a ring of buckets.
struct Buckets {
    using role = roles::Queue;
    /// Of a bucket, in the cost's number; 0 asks the graph: `bucket_width(graph, std::type_identity<Cost>{})`, else 1.
    double width = 0;
    void check() const {
        if (!(width >= 0) || !std::isfinite(width))
            refuse_value("Buckets", "width", width, "it must be finite, and 0 to have the graph choose");
    }

    template <class Cost, class Vertex> class In {
    public:
        static constexpr bool exact = false; ///< what comes out is the least but for a bucket's width
        explicit In(const Buckets& policy) : chosen_(policy.width) {
            policy.check();
            ring_.resize(ring);
        }
        template <class Graph> void begin(const Graph& g) {
            while (occupied_ != 0) { // what an earlier query left
                const int b = std::countr_zero(occupied_);
                ring_[std::size_t(b)].clear();
                occupied_ &= occupied_ - 1;
            }
            far_.clear();
            late_.clear();
            far_least_ = soon_ = nothing_far;
            set_width(g);
        }
        bool empty() const { return occupied_ == 0 && far_.empty() && late_.empty(); }
        /// No entry has a smaller f than this.
        Cost least_f() {
            if (!late_.empty()) return late_.front().f;
            const std::uint64_t first = occupied_ == 0 ? far_least_ : first_bucket();
            if constexpr (std::is_integral_v<Cost>) return Cost(Cost(first) << shift_);
            else // a little less, since f was rounded on its way into the bucket
                return Cost(first) * width_ * (1 - 8 * std::numeric_limits<Cost>::epsilon());
        }

        /// The first entry of a query: the ring begins with it.
        void start(Cost f, Cost h, const Vertex& v) {
            base_ = bucket_of(f);
            push(f, h, v);
        }
        [[gnu::always_inline]] void push(Cost f, Cost, const Vertex& v) {
            const std::uint64_t bucket = bucket_of(f);
            if (bucket - base_ >= ring) // before the base too: the difference is huge then
                push_outside(bucket, f, v);
            else put(bucket, v);
        }
        [[gnu::always_inline]] Vertex pop() {
            if (occupied_ != 0) {
                base_ = first_bucket();
                if (soon_ >= base_ + ring) return take();
            }
            return pop_outside();
        }
        /// What comes out next unless something is put in before; null where that is not known at once.
        [[gnu::always_inline]] const Vertex* peek() const {
            const auto& bucket = ring_[std::size_t(base_) & (ring - 1)];
            return bucket.empty() ? nullptr : &bucket.back();
        }
        /// Every entry, stale ones too: use(vertex).
        template <class Use> void each(Use&& use) const {
            for (const auto& bucket : ring_)
                for (const auto& v : bucket) use(v);
            for (const auto& entry : far_) use(entry.vertex);
            for (const auto& entry : late_) use(entry.vertex);
        }

    private:
        static constexpr std::size_t ring = 64;
        static constexpr std::uint64_t nothing_far = ~std::uint64_t(0);
        struct Far {
            std::uint64_t bucket;
            Vertex vertex;
        };

        struct Late {
            Cost f;
            Vertex vertex;
            bool operator<(const Late& other) const { return other.f < f; } // the least on top
        };
        template <class Graph> void set_width(const Graph& g) {
            double span = chosen_;
            if constexpr (requires {
                              { bucket_width(g, std::type_identity<Cost>{}) } -> std::convertible_to<double>;
                          })
                if (span == 0) span = bucket_width(g, std::type_identity<Cost>{});
            if (span == 0) span = 1;
            if constexpr (std::is_integral_v<Cost>) { // a power of two, so that no division is needed
                shift_ = std::uint64_t(std::bit_width(std::uint64_t(span < 1 ? 1 : span > 1e9 ? 1e9 : span))) - 1;
            } else {
                width_ = Cost(span);
                per_width_ = Cost(1 / span);
            }
        }
        std::uint64_t bucket_of(Cost f) const {
            if constexpr (std::is_integral_v<Cost>) return std::uint64_t(f) >> shift_;
            else {
                const Cost quotient = f * per_width_;
                return quotient < Cost(4e18) ? std::uint64_t(quotient) : std::uint64_t(4000000000000000000);
            }
        }
        std::uint64_t first_bucket() const { ///< that holds something
            return base_ + std::uint64_t(std::countr_zero(std::rotr(occupied_, int(base_ & (ring - 1)))));
        }
        void put(std::uint64_t bucket, const Vertex& v) {
            const std::size_t place = std::size_t(bucket) & (ring - 1);
            ring_[place].push_back(v);
            occupied_ |= std::uint64_t(1) << place;
        }
        Vertex take() {
            const std::size_t place = std::size_t(base_) & (ring - 1);
            auto& bucket = ring_[place];
            const Vertex v = bucket.back();
            bucket.pop_back();
            if (bucket.empty()) occupied_ &= ~(std::uint64_t(1) << place);
            return v;
        }
        [[gnu::noinline]] void push_outside(std::uint64_t bucket, Cost f, const Vertex& v) {
            if (bucket < base_) { // an inconsistent heuristic: f fell
                late_.push_back({f, v});
                std::push_heap(late_.begin(), late_.end());
                soon_ = 0;
                return;
            }
            far_.push_back({bucket, v});
            if (bucket < far_least_) far_least_ = bucket;
            if (late_.empty()) soon_ = far_least_;
        }
        [[gnu::noinline]] Vertex pop_outside() {
            if (!late_.empty()) {
                const Vertex v = late_.front().vertex;
                std::pop_heap(late_.begin(), late_.end());
                late_.pop_back();
                if (late_.empty()) soon_ = far_least_;
                return v;
            }
            if (occupied_ == 0) base_ = far_least_;
            draw_near();
            return take();
        }
        /// Takes into the ring what the ring has come to reach.
        void draw_near() {
            std::size_t kept = 0;
            far_least_ = nothing_far;
            for (std::size_t i = 0; i < far_.size(); ++i) {
                const Far entry = far_[i];
                if (entry.bucket < base_ + ring) {
                    put(entry.bucket, entry.vertex);
                    continue;
                }
                far_[kept++] = entry;
                if (entry.bucket < far_least_) far_least_ = entry.bucket;
            }
            far_.resize(kept);
            soon_ = far_least_;
        }
        std::vector<std::vector<Vertex>> ring_;
        std::vector<Far> far_;   ///< beyond the ring
        std::vector<Late> late_; ///< before it, a heap by f: in any other order nodes would be looked at far more often
        std::uint64_t occupied_ = 0, base_ = 0;
        std::uint64_t far_least_ = nothing_far; ///< the first bucket of those beyond
        std::uint64_t soon_ =
            nothing_far; ///< where the ring does not suffice: that, or 0 where something lies before it
        double chosen_;
        std::uint64_t shift_ = 0; ///< wide, so that no write to a node can be one to it
        Cost width_ = 1, per_width_ = 1;
    };
};

} // namespace ansatz::paths
