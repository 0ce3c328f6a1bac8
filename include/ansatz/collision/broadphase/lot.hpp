// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Lot`: boxes that were copied side by side, and `scan`, the box test of one against a run of them (notes 2.1.1).
///
/// The partitions use it: what is tested together lies together, so that the memory is read in order. For a broadphase
/// of your own. A user of the library needs neither.

#include <ansatz/collision/boxes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// Boxes in the order in which a broadphase put them, each with the index it has among all. Box by box and not in
/// lanes: runs are short, and one box is one line of the cache.
/// \tparam S the space
template <class S> class Lot {
public:
    using Scalar = typename S::Scalar;             ///< of the space
    static constexpr int dimension = S::dimension; ///< of the space

    /// A box, and the body that it belongs to.
    struct Item {
        std::array<Scalar, 2 * std::size_t(S::dimension)>
            bounds;       ///< m, the lower corner, then the upper one with its sign changed
        std::uint32_t id; ///< its index among all

        Scalar lower(std::size_t k) const { return bounds[k]; }                              ///< m
        Scalar upper(std::size_t k) const { return -bounds[std::size_t(S::dimension) + k]; } ///< m
    };

    /// That `make_room` of so many places, or fewer, does not allocate.
    void reserve(std::size_t n) { items_.reserve(n); }
    /// Room for so many places. It only grows, so that a warm broadphase allocates nothing.
    void make_room(std::size_t n) {
        if (n > items_.size()) items_.resize(n);
    }
    /// Copies box `i` into a place.
    [[gnu::always_inline]] void put(std::size_t place, const Boxes<S>& boxes, std::uint32_t i) {
        Item& item = items_[place];
        for (std::size_t k = 0; k < std::size_t(dimension); ++k)
            item.bounds[k] = boxes.lower(int(k))[i], item.bounds[std::size_t(dimension) + k] = -boxes.upper(int(k))[i];
        item.id = i;
    }
    Item& operator[](std::size_t place) { return items_[place]; }             ///< what is there
    const Item& operator[](std::size_t place) const { return items_[place]; } ///< what is there
    /// All of them.
    const Item* data() const { return items_.data(); }

private:
    std::vector<Item> items_;
};

/// Calls `found(q)` for each place of [first, last) whose box touches that in place `p`.
template <class S, class F>
[[gnu::always_inline]] inline void scan(const Lot<S>& lot, std::size_t p, std::size_t first, std::size_t last,
                                        F&& found) {
    constexpr std::size_t dimension = S::dimension;
    std::array<typename S::Scalar, 2 * dimension> reach; // by value: it stays in registers, whatever `found` writes
    for (std::size_t k = 0; k < dimension; ++k) reach[k] = lot[p].upper(k), reach[dimension + k] = -lot[p].lower(k);
    const typename Lot<S>::Item* const all = lot.data();
    for (std::size_t q = first; q < last; ++q) {
        unsigned touch = 1; // no early exit: a branch that cannot be foreseen costs more than the comparisons after it
        for (std::size_t k = 0; k < 2 * dimension; ++k) touch &= unsigned(all[q].bounds[k] <= reach[k]);
        if (touch) found(q);
    }
}
/// The same of boxes in lanes.
template <class S, class F>
[[gnu::always_inline]] inline void scan(const Boxes<S>& boxes, std::size_t p, std::size_t first, std::size_t last,
                                        F&& found) {
    std::array<const typename S::Scalar*, std::size_t(S::dimension)> lower, upper;
    std::array<typename S::Scalar, std::size_t(S::dimension)> own_lower, own_upper;
    for (std::size_t k = 0; k < std::size_t(S::dimension); ++k) {
        lower[k] = boxes.lower(int(k)), upper[k] = boxes.upper(int(k));
        own_lower[k] = lower[k][p], own_upper[k] = upper[k][p];
    }
    constexpr std::size_t block = 32; // tested without a branch, then gone through: so it becomes vector instructions
    for (std::size_t q = first; q < last; q += block) {
        std::array<std::uint8_t, block> touch;
        const std::size_t count = last - q < block ? last - q : block;
        for (std::size_t n = 0; n < count; ++n) {
            touch[n] = 1;
            for (std::size_t k = 0; k < std::size_t(S::dimension); ++k)
                touch[n] = std::uint8_t(touch[n] & unsigned(lower[k][q + n] <= own_upper[k]) &
                                        unsigned(own_lower[k] <= upper[k][q + n]));
        }
        for (std::size_t n = 0; n < count; ++n)
            if (touch[n]) found(q + n);
    }
}

/// Tells two indices in order, if one of them at least is of a body that moves.
template <class F>
[[gnu::always_inline]] inline void tell(std::uint32_t a, std::uint32_t b, std::size_t active, F&& found) {
    const std::size_t i = a < b ? a : b, j = a < b ? b : a;
    if (i < active) found(i, j);
}

} // namespace ansatz
