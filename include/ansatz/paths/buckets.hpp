// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Buckets`: the open list as a ring of buckets, each for a span of f, faster than a heap.
/// <!-- costs: paths cost number/*: "Buckets, uint32" < 0.9 "Heap, uint32"; paths successors/*: "EveryEdge, Buckets" <
/// 0.9 "EveryEdge, Heap" -->
///
/// Putting in and taking out cost the same however long the list is. What lies in one bucket comes out last in, first
/// out, so that the order is right only to a bucket's width. The search makes good for it: it opens nodes again, and
/// when the goal has come out it goes on until nothing cheaper can be left. The answer is as exact as with a heap. It
/// needs `Reopening`, which is the default; `NoReopening` is refused in a sentence.
///
/// The best width is a fraction of the cheapest usual edge: too wide and nodes are expanded twice, too narrow and empty
/// buckets are visited. A grid says its own; for other graphs it is the first argument, in the unit of the weights.
///
/// An inconsistent heuristic lets f fall below what has come out already. Such entries come out before all others, and
/// among themselves by g and not by f: a node that comes out then is reached no cheaper by another of them, so that far
/// fewer nodes are opened again (algorithm B).
///
/// \see R. B. Dial, "Algorithm 360: shortest-path forest with topological ordering", Comm. ACM 12 (1969).
/// \see A. Martelli, "On the complexity of admissible search algorithms", Artificial Intelligence 8 (1977), for
/// algorithm B.

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
            near_.lists.resize(ring);
            late_.lists.resize(ring);
        }
        template <class Graph> void begin(const Graph& g) {
            near_.clear(), late_.clear(); // what an earlier query left
            far_.clear(), later_.clear();
            far_least_ = soon_ = nothing_far;
            set_width(g);
        }
        bool empty() const { return near_.occupied == 0 && far_.empty() && !has_late(); }
        /// No entry has a smaller f than this.
        Cost least_f() {
            if (has_late()) return Cost(0); // they are in order of g, and soon gone
            const std::uint64_t first = near_.occupied == 0 ? far_least_ : near_.first();
            if constexpr (std::is_integral_v<Cost>) return Cost(Cost(first) << shift_);
            else // a little less, since f was rounded on its way into the bucket
                return Cost(first) * width_ * (1 - 8 * std::numeric_limits<Cost>::epsilon());
        }

        /// The first entry of a query: the ring begins with it.
        void start(Cost f, Cost h, const Vertex& v) {
            near_.base = bucket_of(f);
            push(f, h, v);
        }
        [[gnu::always_inline]] void push(Cost f, Cost h, const Vertex& v) {
            const std::uint64_t bucket = bucket_of(f);
            if (bucket - near_.base >= ring) // before the base too: the difference is huge then
                push_outside(bucket, f, h, Vertex(v));
            else near_.put(bucket, v);
        }
        [[gnu::always_inline]] Vertex pop() {
            if (near_.occupied != 0) {
                const std::uint64_t first = near_.first();
                if (soon_ >= first + ring) {
                    near_.base = first;
                    return near_.take();
                }
            }
            return pop_outside();
        }
        /// What comes out next unless something is put in before; null where that is not known at once.
        [[gnu::always_inline]] const Vertex* peek() const {
            const auto& bucket = near_.lists[std::size_t(near_.base) & (ring - 1)];
            return bucket.empty() ? nullptr : &bucket.back();
        }
        /// Every entry, stale ones too: use(vertex).
        template <class Use> void each(Use&& use) const {
            for (const auto* lists : {&near_.lists, &late_.lists})
                for (const auto& bucket : *lists)
                    for (const auto& v : bucket) use(v);
            for (const auto* entries : {&far_, &later_})
                for (const auto& entry : *entries) use(entry.vertex);
        }

    private:
        static constexpr std::size_t ring = 64;
        static constexpr std::uint64_t nothing_far = ~std::uint64_t(0);
        /// All that is dearer shares this bucket: behind it there is room for a ring.
        static constexpr std::uint64_t last = 4000000000000000000;
        struct Far {
            std::uint64_t bucket;
            Vertex vertex;
        };
        /// Lists for so many buckets in a row, the first of which moves on.
        struct Ring {
            std::vector<std::vector<Vertex>> lists;
            std::uint64_t occupied = 0, base = 0;
            void clear() {
                for (; occupied != 0; occupied &= occupied - 1) lists[std::size_t(std::countr_zero(occupied))].clear();
            }
            std::uint64_t first() const { ///< that holds something
                return base + std::uint64_t(std::countr_zero(std::rotr(occupied, int(base & (ring - 1)))));
            }
            void put(std::uint64_t bucket, const Vertex& v) {
                const std::size_t place = std::size_t(bucket) & (ring - 1);
                lists[place].push_back(Vertex(v)); // a copy, or the caller's vertex could not be in a register
                occupied |= std::uint64_t(1) << place;
            }
            Vertex take() { ///< one of the bucket at the base
                const std::size_t place = std::size_t(base) & (ring - 1);
                auto& bucket = lists[place];
                const Vertex v = bucket.back();
                bucket.pop_back();
                if (bucket.empty()) occupied &= ~(std::uint64_t(1) << place);
                return v;
            }
        };
        static bool farther(const Far& a, const Far& b) { return b.bucket < a.bucket; } // the least on top of a heap
        bool has_late() const { return late_.occupied != 0 || !later_.empty(); }
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
            if constexpr (std::is_integral_v<Cost> && sizeof(Cost) < 8) return std::uint64_t(f) >> shift_;
            else if constexpr (std::is_integral_v<Cost>) return std::min(std::uint64_t(f) >> shift_, last);
            else {
                const Cost quotient = f * per_width_;
                return quotient < Cost(last) ? std::uint64_t(quotient) : last;
            }
        }
        [[gnu::noinline]] void push_outside(std::uint64_t bucket, Cost f, Cost h, const Vertex& v) {
            if (bucket < near_.base) { // an inconsistent heuristic: f fell
                const std::uint64_t g = bucket_of(f - h);
                if (!has_late()) late_.base = g;
                if (g - late_.base < ring) late_.put(g, v);
                else { // a long edge; or the first of several was not the nearest
                    later_.push_back({g, v});
                    std::push_heap(later_.begin(), later_.end(), farther);
                }
                soon_ = 0;
                return;
            }
            far_.push_back({bucket, v});
            if (bucket < far_least_) far_least_ = bucket;
            if (!has_late()) soon_ = far_least_;
        }
        [[gnu::noinline]] Vertex pop_outside() {
            if (has_late()) {
                const Vertex v = take_late();
                if (!has_late()) soon_ = far_least_;
                return v;
            }
            near_.base = near_.occupied == 0 ? far_least_ : near_.first();
            draw_near();
            return near_.take();
        }
        Vertex take_late() {
            if (later_.empty() || (late_.occupied != 0 && late_.first() <= later_.front().bucket)) {
                late_.base = late_.first();
                return late_.take();
            }
            const Far least = later_.front();
            std::pop_heap(later_.begin(), later_.end(), farther);
            later_.pop_back();
            if (late_.occupied == 0) late_.base = least.bucket;
            return least.vertex;
        }
        /// Takes into the ring what the ring has come to reach.
        void draw_near() {
            std::size_t kept = 0;
            far_least_ = nothing_far;
            for (std::size_t i = 0; i < far_.size(); ++i) {
                const Far entry = far_[i];
                if (entry.bucket < near_.base + ring) {
                    near_.put(entry.bucket, entry.vertex);
                    continue;
                }
                far_[kept++] = entry;
                if (entry.bucket < far_least_) far_least_ = entry.bucket;
            }
            far_.resize(kept);
            soon_ = far_least_;
        }
        Ring near_;                             ///< by f, from the base on
        Ring late_;                             ///< f fell behind the base: by g
        std::vector<Far> later_;                ///< the same beyond that ring, or before it: a heap by g
        std::vector<Far> far_;                  ///< beyond the ring
        std::uint64_t far_least_ = nothing_far; ///< the first bucket of those beyond
        /// Where the ring does not suffice: that, or 0 where something lies before it.
        std::uint64_t soon_ = nothing_far;
        double chosen_;
        std::uint64_t shift_ = 0; ///< wide, so that no write to a node can be one to it
        Cost width_ = 1, per_width_ = 1;
    };
};

} // namespace ansatz::paths
