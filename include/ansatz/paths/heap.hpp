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
            std::size_t i = 0;
            for (;;) {
                const std::size_t first = 4 * i + 1;
                if (first >= n) break;
                std::size_t child = first;
                if (first + 4 <= n) {
                    // by arithmetic: which child is less cannot be foreseen, and a wrong guess costs more
                    const std::size_t a = first + std::size_t(before(at[first + 1], at[first]));
                    const std::size_t b = first + 2 + std::size_t(before(at[first + 3], at[first + 2]));
                    child = a + (b - a) * std::size_t(before(at[b], at[a]));
                } else
                    for (std::size_t k = first + 1; k < n; ++k)
                        if (before(at[k], at[child])) child = k;
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
        struct Entry {
            Cost h, f; // in this order the two are one word
            Vertex vertex;
        };
        [[gnu::always_inline]] static bool before(const Entry& a, const Entry& b) {
            if constexpr (std::is_same_v<Cost, std::uint32_t>) { // one comparison without a branch
                const auto both = [](const Entry& e) { return std::uint64_t(e.f) << 32 | e.h; };
                return both(a) < both(b);
            } else return (unsigned(a.f < b.f) | (unsigned(a.f == b.f) & unsigned(a.h < b.h))) != 0;
        }
        std::vector<Entry> entries_;
    };
};

} // namespace ansatz::paths
