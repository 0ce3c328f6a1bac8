// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SortAndSweep`: boxes sorted along one axis, so that each meets only those that begin before it ends (notes 2.1.1,
/// "Sort and Sweep").
///
/// Use it by itself for up to about a hundred bodies, or for any number of them on a line, where nothing is faster
/// <!-- costs: collision broadphase/column: SortAndSweep < UniformGrid; collision broadphase/column: SortAndSweep <
/// Octree from 256 -->; and inside the cells of a partition,
/// `UniformGrid<SortAndSweep>`, where cells hold many. The axis is the one along which the centres vary most. From one
/// step to the next bodies hardly change places, so the order is kept and repaired by insertion, which costs as many
/// moves as bodies have overtaken each other; where that is too many, it is sorted anew. Equal lower ends are ordered
/// by index, so that the order never depends on the past. (After D. Baraff, "Dynamic simulation of non-penetrating
/// rigid bodies", 1992.)

#include <ansatz/collision/broadphase/inside.hpp>
#include <ansatz/world/space.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace ansatz {

/// When bodies in the cells of a partition are sorted.
enum class Sorting : bool {
    while_parted, ///< all of them once; the cells are filled in that order (notes: "during the test for partition
                  ///< occupancy")
    in_cells      ///< each cell's by themselves
};

/// The pairs whose boxes touch, by one pass along the axis of largest variance.
struct SortAndSweep {
    using role = roles::Broadphase;

    /// Of interest only inside a partition; the pairs are the same
    Sorting sorting = Sorting::while_parted;

    static constexpr std::string_view name = "SortAndSweep";
    static void parameters(auto&, auto&&) {}

    template <class S> class In {
    public:
        using Scalar = typename S::Scalar; ///< of the space

        explicit In(const SortAndSweep& policy) : sorting_(policy.sorting) {}
        /// Room for so many boxes.
        void reserve(std::size_t n) {
            keys_.reserve(n);
            order_.reserve(n);
            lot_.reserve(n);
        }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            sort(boxes);
            lot_.make_room(keys_.size());
            for (std::size_t p = 0; p < keys_.size(); ++p) lot_.put(p, boxes, keys_[p].id);
            among(lot_, 0, keys_.size(),
                  [&](std::size_t p, std::size_t q) { tell(lot_[p].id, lot_[q].id, boxes.active(), found); });
        }
        /// The axis of the last pass.
        int axis() const { return axis_; }

        /// \name Inside a cell
        /// @{
        const std::uint32_t* order(const Boxes<S>& boxes) {
            axis_ = widest_axis(boxes);
            if (sorting_ == Sorting::in_cells) return nullptr;
            sort(boxes);
            order_.resize(keys_.size());
            for (std::size_t p = 0; p < keys_.size(); ++p) order_[p] = keys_[p].id;
            return order_.data();
        }
        void arrange(Lot<S>& lot, std::size_t first, std::size_t last) const {
            if (sorting_ == Sorting::while_parted) return;
            const auto k = std::size_t(axis_);
            for (std::size_t p = first + 1; p < last; ++p) {
                const auto item = lot[p];
                std::size_t q = p;
                for (; q > first && item.lower(k) < lot[q - 1].lower(k); --q) lot[q] = lot[q - 1];
                if (q != p) lot[q] = item;
            }
        }
        template <class F> void among(const Lot<S>& lot, std::size_t first, std::size_t last, F&& touch) const {
            for (std::size_t p = first; p < last; ++p)
                scan(lot, p, p + 1, end_of(lot, p + 1, last, lot[p].upper(std::size_t(axis_))),
                     [&](std::size_t q) { touch(p, q); });
        }
        /// Goes along two lists at once: whichever begins first is compared with those of the other.
        template <class F>
        void between(const Lot<S>& lot, std::size_t first, std::size_t last, std::size_t other_first,
                     std::size_t other_last, F&& touch) const {
            const auto k = std::size_t(axis_);
            auto compare_from = [&](std::size_t p, std::size_t from, std::size_t to) {
                scan(lot, p, from, end_of(lot, from, to, lot[p].upper(k)), [&](std::size_t q) { touch(p, q); });
            };
            std::size_t p = first, q = other_first;
            while (p < last && q < other_last) {
                if (lot[p].lower(k) <= lot[q].lower(k)) compare_from(p++, q, other_last);
                else compare_from(q++, p, last);
            }
        }
        /// @}

    private:
        struct Key {
            Scalar low;
            std::uint32_t id;
            bool operator<(const Key& other) const { return low < other.low || (low == other.low && id < other.id); }
        };

        /// The first of a sorted run that begins after `reach`.
        std::size_t end_of(const Lot<S>& lot, std::size_t first, std::size_t last, Scalar reach) const {
            constexpr std::size_t stride = 8;
            const auto k = std::size_t(axis_);
            while (first + stride <= last && lot[first + stride - 1].lower(k) <= reach) first += stride;
            while (first < last && lot[first].lower(k) <= reach) ++first;
            return first;
        }
        /// In order, from the order of the last time.
        void sort(const Boxes<S>& boxes) {
            axis_ = widest_axis(boxes);
            const Scalar* low = boxes.lower(axis_);
            const bool anew = keys_.size() != boxes.size();
            if (anew) {
                keys_.resize(boxes.size());
                for (std::size_t p = 0; p < keys_.size(); ++p) keys_[p].id = std::uint32_t(p);
            }
            for (Key& key : keys_) {
                key.low = low[key.id];
                if (!(key.low == key.low)) key.low = std::numeric_limits<Scalar>::max(); // no order has a NaN in it
            }
            if (anew || !repair()) std::sort(keys_.begin(), keys_.end());
        }
        /// Insertion sort that gives up when more has moved than sorting costs.
        bool repair() {
            std::size_t moves_left = 4 * keys_.size();
            for (std::size_t p = 1; p < keys_.size(); ++p) {
                const Key key = keys_[p];
                std::size_t q = p;
                for (; q > 0 && key < keys_[q - 1]; --q) keys_[q] = keys_[q - 1];
                keys_[q] = key;
                if (p - q > moves_left) return false;
                moves_left -= p - q;
            }
            return true;
        }
        /// By the variance of the centres; of equal ones the first.
        static int widest_axis(const Boxes<S>& boxes) {
            int widest = 0;
            double most = -1;
            for (int k = 0; k < S::dimension; ++k) {
                const Scalar *low = boxes.lower(k), *high = boxes.upper(k);
                double sum = 0, squares = 0;
                const double origin =
                    boxes.size() ? double(low[0]) : 0; // near the values, or the squares swallow the difference
                for (std::size_t i = 0; i < boxes.size(); ++i) {
                    const double centre = 0.5 * (double(low[i]) - origin) + 0.5 * (double(high[i]) - origin);
                    sum += centre;
                    squares += centre * centre;
                }
                const double variance = squares - sum * (sum / double(boxes.size()));
                if (variance > most) most = variance, widest = k;
            }
            return widest;
        }

        Sorting sorting_;
        int axis_ = 0;
        std::vector<Key> keys_;
        std::vector<std::uint32_t> order_;
        Lot<S> lot_;
    };
};

} // namespace ansatz
