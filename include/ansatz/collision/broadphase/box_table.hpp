// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BoxTable`: boxes in a table of cells, of which single ones are exchanged: how `Coherent` finds the pairs of the few
/// boxes that have moved far (notes 2.1.1, "World Partitioning").
///
/// A user of the library needs it as little as `Lot`.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/broadphase/cells.hpp>
#include <ansatz/collision/broadphase/lot.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz::detail {

/// Boxes in a table of cells, each in that of its lower corner, into which one is put and from which it is taken alone.
/// Boxes wider than a cell are in a list of their own, and are tested with all.
template <class S> class BoxTable {
    static constexpr int dimension = S::dimension;
    using Cell = std::array<std::int64_t, std::size_t(dimension)>;

public:
    /// Room for so many boxes.
    void reserve(std::size_t n) {
        heads_.reserve(buckets_for(n));
        next_.reserve(n);
        bucket_of_.reserve(n);
        wide_.reserve(n);
        lot_.reserve(n);
    }
    /// Of all boxes, which are finite.
    /// \param width m, of a cell; greater than zero, and so is its inverse
    void make(const Boxes<S>& boxes, double width) {
        size_ = boxes.size();
        per_metre_ = 1 / width;
        heads_.assign(buckets_for(size_), nobody);
        next_.resize(size_);
        bucket_of_.resize(size_);
        wide_.clear();
        lot_.make_room(size_);
        for (std::size_t i = 0; i < size_; ++i) put(boxes, std::uint32_t(i));
    }
    /// How many are wider than a cell.
    std::size_t wide() const { return wide_.size(); }
    /// One that is not in it.
    void put(const Boxes<S>& boxes, std::uint32_t i) {
        lot_.put(i, boxes, i);
        if (is_wide(i)) {
            bucket_of_[i] = nobody;
            wide_.push_back(i);
            return;
        }
        Cell cell;
        for (std::size_t k = 0; k < std::size_t(dimension); ++k) cell[k] = index(double(lot_[i].lower(k)));
        bucket_of_[i] = bucket(cell);
        next_[i] = heads_[bucket_of_[i]];
        heads_[bucket_of_[i]] = i;
    }
    /// One that is.
    void take(std::uint32_t i) {
        if (bucket_of_[i] == nobody) {
            wide_.erase(std::find(wide_.begin(), wide_.end(), i));
            return;
        }
        std::uint32_t* link = &heads_[bucket_of_[i]];
        while (*link != i) link = &next_[*link];
        *link = next_[i];
    }
    /// Calls `found(j)` for each that touches box `i`, that itself too; for some more than once.
    template <class F> void near(std::uint32_t i, F&& found) const {
        const auto own = lot_[i];
        const auto test = [&](std::uint32_t j) {
            unsigned touch = 1;
            for (std::size_t k = 0; k < std::size_t(dimension); ++k)
                touch &= unsigned(lot_[j].lower(k) <= own.upper(k)) & unsigned(own.lower(k) <= lot_[j].upper(k));
            if (touch) found(j);
        };
        if (bucket_of_[i] == nobody) {
            for (std::uint32_t j = 0; j < size_; ++j) test(j);
            return;
        }
        for (const std::uint32_t j : wide_) test(j);
        Cell from, to;
        for (std::size_t k = 0; k < std::size_t(dimension); ++k) {
            from[k] = index(double(own.lower(k))) - 1; // a box that reaches this one begins less than a cell before it
            to[k] = index(double(own.upper(k)));
        }
        for (Cell cell = from;;) {
            for (std::uint32_t j = heads_[bucket(cell)]; j != nobody; j = next_[j]) test(j);
            std::size_t k = 0;
            for (; k < std::size_t(dimension) && ++cell[k] > to[k]; ++k) cell[k] = from[k];
            if (k == std::size_t(dimension)) return;
        }
    }

private:
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

    static std::size_t buckets_for(std::size_t n) {
        std::size_t buckets = 64;
        while (buckets < n) buckets *= 2;
        return buckets;
    }
    bool is_wide(std::uint32_t i) const {
        constexpr double whole = 1 - 1.0 / 512; // of a cell: rounding must not let a box reach further
        bool is = false;
        for (std::size_t k = 0; k < std::size_t(dimension); ++k)
            is |= !((double(lot_[i].upper(k)) - double(lot_[i].lower(k))) * per_metre_ <= whole);
        return is;
    }
    /// On an axis. Those farther out than cells are exact share the last one.
    std::int64_t index(double coordinate) const {
        constexpr double far = double(1ull << 38);
        return floor_of(std::min(std::max(coordinate * per_metre_, -far), far));
    }
    /// Cells of a row are next to each other, so that three of them are mostly in one line of the cache.
    std::uint32_t bucket(const Cell& cell) const {
        std::uint64_t row = 0;
        for (std::size_t k = 1; k < std::size_t(dimension); ++k)
            row = (row ^ std::uint64_t(cell[k])) * 0x9E3779B97F4A7C15ull;
        return std::uint32_t((row >> 32) + std::uint64_t(cell[0])) & std::uint32_t(heads_.size() - 1);
    }

    double per_metre_ = 1;
    std::size_t size_ = 0;
    std::vector<std::uint32_t> heads_, next_; // the first of each bucket; after each box
    std::vector<std::uint32_t> bucket_of_;    // nobody: it is among the wide
    std::vector<std::uint32_t> wide_;
    Lot<S> lot_; // the boxes once more, each in one place
};

} // namespace ansatz::detail
