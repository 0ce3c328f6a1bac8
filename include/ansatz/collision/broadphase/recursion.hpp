// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The recursion that `Octree` and `BinarySplit` share: a cell with too many bodies is divided, its bodies handed on,
/// and so on (notes 2.1.1, "Binary Search Partitioning").
///
/// A body that reaches over a plane is handed to both sides. Two such meet in more than one cell, and are told in one:
/// that which holds the lower corner of what their boxes have in common. It exists and is one, because the cells have
/// no gap and no overlap; and both bodies are in its list, because both boxes reach into it. No pair is remembered, and
/// none is lost.
///
/// A division is given up where too many bodies would be in several cells: coincident ones could be divided for ever.

#include <ansatz/collision/broadphase/inside.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz::detail {

/// A cell: from `lower` up to, but not including, `upper`; at the upper end of the world it includes that as well.
template <class S> struct TreeCell {
    std::array<typename S::Scalar, std::size_t(S::dimension)> lower, upper;
};

/// Planes that divide a cell: on each axis of `axes` (a bit each) at `at`.
template <class S> struct Division {
    unsigned axes = 0;
    std::array<typename S::Scalar, std::size_t(S::dimension)> at{};
};

/// Finds the pairs of boxes by dividing cells, as `Divide` says.
template <class S, class Inside> class Recursion {
public:
    using Scalar = typename S::Scalar;
    static constexpr int dimension = S::dimension;
    static constexpr std::size_t sides = std::size_t(1) << dimension;

    explicit Recursion(const Inside& inside) : inside_(inside) {}
    /// Room for so many boxes.
    void reserve(std::size_t n) {
        members_.reserve(likely * n);
        masks_.reserve(likely * n);
        lot_.reserve(n);
        if constexpr (requires { inside_.reserve(n); }) inside_.reserve(n);
    }

    /// \param threshold cells of so many bodies, or fewer, are not divided
    /// \param depth     nor are cells that are so many divisions deep
    /// \param copies    nor where the children would together hold so many times as many bodies, or more
    /// \param divide    divide(cell, members, count, attempt, division): false where there is nothing (more) to try
    template <class Divide, class F>
    void find(const Boxes<S>& boxes, std::size_t threshold, int depth, double copies, const Divide& divide, F&& found) {
        if (boxes.active() == 0 || boxes.size() < 2) return;
        const std::uint32_t* order = inside_.order(boxes);
        // Bodies move, and another time other cells are divided: room for all that is likely, at once.
        members_.reserve(likely * boxes.size());
        masks_.reserve(likely * boxes.size());
        lot_.make_room(boxes.size());
        members_.clear();
        for (std::size_t p = 0; p < boxes.size(); ++p) members_.push_back(order ? order[p] : std::uint32_t(p));
        world_ = bounds(boxes);
        threshold_ = threshold, copies_ = copies, cells_ = 0;
        part(boxes, world_, 0, boxes.size(), depth, divide, found);
    }
    /// The sides of a division that a box reaches into, a bit each.
    [[gnu::always_inline]] static unsigned sides_of(const Boxes<S>& boxes, std::uint32_t i,
                                                    const Division<S>& division) {
        static constexpr std::array<unsigned, 3> low_sides{0x55u, 0x33u, 0x0Fu};
        unsigned mask = (1u << sides) - 1;
        for (int k = 0; k < dimension; ++k) {
            if (!(division.axes >> k & 1u)) {
                mask &= low_sides[std::size_t(k)]; // one side of this axis stands for both
                continue;
            }
            const Scalar at = division.at[std::size_t(k)];
            mask &= (boxes.lower(k)[i] < at ? low_sides[std::size_t(k)] : 0u) |
                    (boxes.upper(k)[i] >= at ? ~low_sides[std::size_t(k)] : 0u);
        }
        return mask;
    }
    /// How many cells were tested in the last `find`.
    std::size_t cells() const { return cells_; }

private:
    static constexpr std::size_t likely = 8; // places a body takes in the lists, at most

    static TreeCell<S> bounds(const Boxes<S>& boxes) {
        TreeCell<S> all;
        for (int k = 0; k < dimension; ++k) {
            Scalar low = boxes.lower(k)[0], high = boxes.upper(k)[0];
            for (std::size_t i = 1; i < boxes.size(); ++i) {
                low = boxes.lower(k)[i] < low ? boxes.lower(k)[i] : low;
                high = high < boxes.upper(k)[i] ? boxes.upper(k)[i] : high;
            }
            all.lower[std::size_t(k)] = low, all.upper[std::size_t(k)] = high;
        }
        return all;
    }

    template <class Divide, class F>
    void part(const Boxes<S>& boxes, const TreeCell<S>& cell, std::size_t first, std::size_t last, int depth,
              const Divide& divide, F& found) {
        const std::size_t count = last - first;
        if (count < 2) return;
        Division<S> division;
        std::array<std::size_t, sides + 1> ends{};
        bool divided = false;
        for (int attempt = 0; !divided && count > threshold_ && depth > 0; ++attempt) {
            if (!divide(cell, members_.data() + first, count, attempt, division)) break;
            divided = division.axes != 0 && hand_on(boxes, division, first, last, ends);
        }
        if (!divided) return test(boxes, cell, first, last, found);
        for (std::size_t side = 0; side < sides; ++side) {
            TreeCell<S> child = cell;
            for (int k = 0; k < dimension; ++k)
                if (division.axes >> k & 1u)
                    ((side >> k & 1u) ? child.lower : child.upper)[std::size_t(k)] = division.at[std::size_t(k)];
            part(boxes, child, ends[side], ends[side + 1], depth - 1, divide, found);
        }
        members_.resize(ends[0]);
    }

    /// Appends the lists of the children; leaves all as it was where that is not worth it.
    bool hand_on(const Boxes<S>& boxes, const Division<S>& division, std::size_t first, std::size_t last,
                 std::array<std::size_t, sides + 1>& ends) {
        std::array<std::size_t, sides> counts{};
        masks_.resize(last > masks_.size() ? last : masks_.size());
        std::size_t all = 0;
        for (std::size_t p = first; p < last; ++p) {
            const unsigned mask = sides_of(boxes, members_[p], division);
            masks_[p] = std::uint8_t(mask);
            for (std::size_t side = 0; side < sides; ++side) counts[side] += mask >> side & 1u;
        }
        for (const std::size_t count : counts) all += count;
        if (double(all) >= copies_ * double(last - first)) return false;
        ends[0] = members_.size();
        std::array<std::size_t, sides> next{};
        for (std::size_t side = 0; side < sides; ++side)
            next[side] = ends[side], ends[side + 1] = ends[side] + counts[side];
        members_.resize(ends[sides]);
        for (std::size_t p = first; p < last; ++p)
            for (unsigned mask = masks_[p]; mask != 0; mask &= mask - 1)
                members_[next[std::size_t(__builtin_ctz(mask))]++] = members_[p];
        return true;
    }

    template <class F>
    void test(const Boxes<S>& boxes, const TreeCell<S>& cell, std::size_t first, std::size_t last, F& found) {
        const std::size_t count = last - first;
        ++cells_;
        for (std::size_t p = 0; p < count; ++p) lot_.put(p, boxes, members_[first + p]);
        inside_.arrange(lot_, 0, count);
        inside_.among(lot_, 0, count, [&](std::size_t p, std::size_t q) {
            if (holds_corner(cell, p, q)) ansatz::tell(lot_[p].id, lot_[q].id, boxes.active(), found);
        });
    }
    /// Whether the lower corner of what two boxes have in common is in the cell.
    bool holds_corner(const TreeCell<S>& cell, std::size_t p, std::size_t q) const {
        bool all = true;
        for (int k = 0; k < dimension; ++k) {
            const auto axis = std::size_t(k);
            const Scalar a = lot_[p].lower(axis), b = lot_[q].lower(axis), corner = a < b ? b : a;
            all &= corner >= cell.lower[axis] && (corner < cell.upper[axis] || cell.upper[axis] == world_.upper[axis]);
        }
        return all;
    }

    typename Inside::template In<S> inside_;
    TreeCell<S> world_{};
    std::size_t threshold_ = 0, cells_ = 0;
    double copies_ = 0;
    std::vector<std::uint32_t> members_; // the lists of all cells that are being divided, one after the other
    std::vector<std::uint8_t> masks_;
    Lot<S> lot_;
};

} // namespace ansatz::detail
