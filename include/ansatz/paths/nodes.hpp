// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a search knows of a node (notes 6.1), and the two stores that keep it: by number, and by hash.
///
/// Neither is ever cleared: every node bears the stamp of the query that wrote it, so a query costs what it visits
/// and not what the graph holds. When the stamps have all been used (after two thousand million queries) they are
/// cleared once.

#include <ansatz/paths/cost.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace ansatz::paths {

/// The notes' node structure: parent, g, h and f.
/// \tparam Guess the number of h and f; another than that of g where estimates may be more than any cost
template <class Vertex, class Cost, class Guess = Cost> struct Node {
    Cost g{};                ///< of the cheapest way from the start that is known
    Guess h{};               ///< estimated, from here to the goal
    Vertex parent{};         ///< the node before this one on that way; the start is its own
    std::uint32_t stamp = 0; ///< whether it is open, closed, or of an earlier query
    /// Of the cheapest way through here, as far as is known: g + h, or the end of the number.
    [[gnu::always_inline]] Guess f() const { return detail::add(Guess(g), h); }
};

namespace detail {

/// Stamps of one query: even is open, the next odd one is closed, all that is less was written by others.
class Stamps {
public:
    std::uint32_t open() const { return open_; }
    std::uint32_t closed() const { return open_ + 1; }
    /// A new query.
    /// \return false when the stamps must be cleared, because they begin again
    bool next() {
        if (open_ >= std::numeric_limits<std::uint32_t>::max() - 3) {
            open_ = 2;
            return false;
        }
        open_ += 2;
        return true;
    }
    void use_up() { open_ = std::numeric_limits<std::uint32_t>::max() - 3; } ///< for tests: the next query begins again

private:
    std::uint32_t open_ = 0;
};

/// Nodes of numbered vertices: an array.
template <class Vertex, class Cost, class Guess = Cost> class NumberedNodes {
public:
    using Record = Node<Vertex, Cost, Guess>;
    using Slot = std::size_t;
    void grow(std::size_t count) { ///< the graph may have
        if (records_.size() < count) records_.resize(count);
    }
    void begin(std::size_t count) {
        grow(count);
        if (!stamps_.next())
            for (auto& record : records_) record.stamp = 0;
    }
    const Stamps& stamps() const { return stamps_; }
    Stamps& stamps() { return stamps_; }
    Record& operator[](Slot slot) { return records_[slot]; }
    const Record& operator[](Slot slot) const { return records_[slot]; }
    std::size_t size() const { return records_.size(); }

private:
    std::vector<Record> records_;
    Stamps stamps_;
};

/// Nodes of vertices without numbers: an open-addressed table. An entry of an earlier query is as good as empty.
template <class Vertex, class Cost, class Guess = Cost> class HashedNodes {
public:
    using Record = Node<Vertex, Cost, Guess>;
    using Slot = std::size_t;
    HashedNodes() : kept_(64), mask_(63) {}
    void grow(std::size_t) {}
    void begin(std::size_t) {
        found_ = 0;
        if (!stamps_.next())
            for (auto& entry : kept_) entry.record.stamp = 0;
    }
    const Stamps& stamps() const { return stamps_; }
    Stamps& stamps() { return stamps_; }
    Record& operator[](Slot slot) { return kept_[slot].record; }
    const Record& operator[](Slot slot) const { return kept_[slot].record; }
    /// Where this vertex is kept, or has its place from now on if the caller stamps it. What was found before may move.
    [[gnu::always_inline]] Slot slot_of(const Vertex& v) {
        Kept* const kept = kept_.data();
        const std::size_t mask = mask_;
        for (std::size_t i = place(v) & mask;; i = (i + 1) & mask) {
            if (kept[i].record.stamp < stamps_.open()) return insert(v, i);
            if (kept[i].vertex == v) return i;
        }
    }
    static constexpr Slot none = std::numeric_limits<Slot>::max();
    Slot find(const Vertex& v) const { ///< none if it was not found
        const std::size_t mask = kept_.size() - 1;
        for (std::size_t i = place(v) & mask; kept_[i].record.stamp >= stamps_.open(); i = (i + 1) & mask)
            if (kept_[i].vertex == v) return i;
        return none;
    }
    /// Every vertex of this query: use(vertex).
    template <class Use> void each(Use&& use) const {
        for (const auto& entry : kept_)
            if (entry.record.stamp >= stamps_.open()) use(entry.vertex);
    }

private:
    struct Kept {
        Vertex vertex{};
        Record record;
    };
    static std::size_t place(const Vertex& v) {
        const std::uint64_t spread = std::uint64_t(std::hash<Vertex>{}(v)) * 0x9E3779B97F4A7C15u;
        return std::size_t(spread >> 32);
    }
    [[gnu::always_inline]] Slot insert(const Vertex& v, std::size_t i) {
        if (2 * ++found_ > mask_) i = enlarge(v);
        kept_[i].vertex = v;
        return i;
    }
    /// \return where the new vertex belongs
    [[gnu::noinline, gnu::cold]] std::size_t enlarge(const Vertex& v) {
        std::vector<Kept> larger(4 * kept_.size());
        const std::size_t mask = larger.size() - 1;
        auto free_place = [&](const Vertex& of) {
            std::size_t i = place(of) & mask;
            while (larger[i].record.stamp >= stamps_.open()) i = (i + 1) & mask;
            return i;
        };
        for (const auto& entry : kept_)
            if (entry.record.stamp >= stamps_.open()) larger[free_place(entry.vertex)] = entry;
        const std::size_t i = free_place(v);
        kept_.swap(larger);
        mask_ = mask;
        return i;
    }
    std::vector<Kept> kept_; ///< a power of two of them
    std::size_t mask_;       ///< one less than their number
    std::size_t found_ = 0;
    Stamps stamps_;
};

} // namespace detail
} // namespace ansatz::paths
