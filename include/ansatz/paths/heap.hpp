// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Heap`: the open list as a heap of four children each, the default queue.
///
/// Takes any cost and hands out the least f exactly; of equal f the one with the least h, which lies nearer to the
/// goal, and in every build the same. A node whose f fell is put in again instead of being moved, and its old entry is
/// passed over when it comes up: that is faster than to keep track of places. For whole-number costs Buckets are faster
/// still. <!-- costs: paths cost number/*: "Buckets, uint32" < 0.9 "Heap, uint32" -->
///
/// \see D. B. Johnson, "Priority queues with update and finding minimum spanning trees", Information Processing Letters
/// 4 (1975), for heaps of more than two children.

#include <ansatz/paths/roles.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// The open list as a heap.
struct Heap {
    using role = roles::Queue;

    template <class Cost, class Vertex> class In {
    public:
        static constexpr bool exact = true; ///< what comes out is the least
        explicit In(const Heap&) {}
        template <class Graph> void begin(const Graph&) { entries_.clear(); }
        bool empty() const { return entries_.empty(); }
        Cost least_f() const { return entries_.front().f; }

        void start(Cost f, Cost h, const Vertex& v) { push(f, h, v); } ///< the first entry of a query
        [[gnu::always_inline]] void push(Cost f, Cost h, const Vertex& v) {
            std::size_t i = entries_.size();
            const Entry entry{h, f, v};
            entries_.push_back(entry);
            Entry* const at = entries_.data();
            while (i > 0) {
                const std::size_t parent = (i - 1) / 4;
                if (!before(entry, at[parent])) break;
                at[i] = at[parent];
                i = parent;
            }
            at[i] = entry;
        }
        [[gnu::always_inline]] Vertex pop() {
            Entry* const at = entries_.data();
            const Vertex least = at[0].vertex;
            const Entry last = entries_.back();
            entries_.pop_back();
            const std::size_t n = entries_.size();
            if (n == 0) return least;
            const bool predicted = !std::is_unsigned_v<Cost> && n < few;
            std::size_t i = 0;
            for (;;) {
                const std::size_t first = 4 * i + 1;
                if (first >= n) break;
                std::size_t child = first;
                if (first + 4 > n) {
                    for (std::size_t k = first + 1; k < n; ++k)
                        if (before(at[k], at[child])) child = k;
                } else if (predicted) child = least_of_four(at, first, before);
                else child = least_of_four(at, first, before_without_branch);
                if (!before(at[child], last)) break;
                at[i] = at[child];
                i = child;
            }
            at[i] = last;
            return least;
        }
        /// What comes out next unless something is put in before; null where there is nothing.
        [[gnu::always_inline]] const Vertex* peek() const {
            return entries_.empty() ? nullptr : &entries_.front().vertex;
        }
        /// Every entry, stale ones too: use(vertex).
        template <class Use> void each(Use&& use) const {
            for (const auto& entry : entries_) use(entry.vertex);
        }

    private:
        __extension__ using Widest = unsigned __int128; // of two words
        using Both = std::conditional_t<(sizeof(Cost) > 4), Widest, std::uint64_t>;
        struct Entry {
            Cost h, f; // in this order the two are one number
            Vertex vertex;
        };
        [[gnu::always_inline]] static bool before(const Entry& a, const Entry& b) {
            if constexpr (std::is_unsigned_v<Cost>) {
                const auto both = [](const Entry& e) { return Both(e.f) << 8 * sizeof(Cost) | e.h; };
                return both(a) < both(b);
            } else return a.f < b.f || (a.f == b.f && a.h < b.h);
        }
        [[gnu::always_inline]] static bool before_without_branch(const Entry& a, const Entry& b) {
            if constexpr (std::is_unsigned_v<Cost>) return before(a, b);
            else return (unsigned(a.f < b.f) | (unsigned(a.f == b.f) & unsigned(a.h < b.h))) != 0;
        }
        /// By arithmetic: the processor cannot predict which child is less, and a misprediction costs more. In a short
        /// list of fractions or of numbers with a sign it often can; there `less` has branches.
        [[gnu::always_inline]] static std::size_t least_of_four(const Entry* at, std::size_t first, const auto& less) {
            const std::size_t a = first + std::size_t(less(at[first + 1], at[first]));
            const std::size_t b = first + 2 + std::size_t(less(at[first + 3], at[first + 2]));
            return a + (b - a) * std::size_t(less(at[b], at[a]));
        }
        static constexpr std::size_t few = 256; ///< entries of a short list: what a planner has
        std::vector<Entry> entries_;
    };
};

} // namespace ansatz::paths
