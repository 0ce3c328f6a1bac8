// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `UniformGrid`: the world divided into cells of one size, each body tested against those of its own and the next
/// cells (notes 2.1.1, "World Partitioning").
///
/// Use it where many bodies are of about one size: from a few hundred on nothing here is faster. <!-- costs: collision
/// broadphase/uniform: UniformGrid < SortAndSweep from 256; collision broadphase/uniform: UniformGrid < Octree from
/// 256; collision broadphase/uniform: UniformGrid < BinarySplit from 256 --> A cell is as wide as the largest of them,
/// so that a body reaches at most into the next cell on each axis. The notes let a body "exist in multiple partitions";
/// here it is written down once, in the cell of its lower corner, and searched for in the cells around: each two
/// neighbours meet once, so no pair has to be remembered or told twice.
///
/// - **Bodies much larger** than the rest get coarser grids of their own, each four times as coarse; a smaller body
///   is tested in the coarser grids, in three cells on each axis at most. The few that are largest of all are tested
///   with everything.
/// - **A world of any size**: cells are counted from the lowest and wrap around where there would be more than a few
/// for each
///   body. Bodies that share a cell from afar cost a test and nothing else.
/// - **Any coordinates**: cells are found by floor, in double, with a margin for its rounding; a body so far out that
/// its cell
///   would not be exact goes to a coarser grid.
///
/// Bodies are put into their cells by a counting sort, without a hash, and their boxes copied in that order, so that
/// three cells in a row are one run of memory (uniform_grid_level.hpp).

#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid_level.hpp>
#include <ansatz/units/requirements.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace ansatz {

/// The pairs whose boxes touch, by cells of one size.
/// \tparam Inside what tests the bodies of a cell: BoundingBoxes or SortAndSweep
template <class Inside = BoundingBoxes> struct UniformGrid {
    using role = roles::Broadphase;
    template <class S> static constexpr bool tests_inside = InsideIn<Inside, S>; ///< whether `Inside` can

    /// m, the width of a cell; finite and not negative. 0: chosen from the boxes. It changes the time and never the
    /// pairs
    Parameter<unit::Length> cell{};
    /// What tests the bodies of a cell
    Inside inside{};

    static constexpr std::string_view name = "UniformGrid";
    static void parameters(auto& self, auto&& visit) { visit("cell", self.cell); }
    void check() const { require_not_negative("UniformGrid", "cell", cell); }

    template <class S> class In {
        static constexpr int dimension = S::dimension;
        using Level = detail::GridLevel<S>;

    public:
        explicit In(const UniformGrid& grid) : cell_(double(S::convert(grid.cell).value())), inside_(grid.inside) {}
        /// Room for so many boxes, on each level that is in use.
        void reserve(std::size_t n) {
            room_ = n;
            needs_.reserve(n);
            level_of_.reserve(n);
            places_.reserve(n);
            lot_.reserve(n);
            if constexpr (requires { inside_.reserve(n); }) inside_.reserve(n);
        }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            if (boxes.active() == 0 || boxes.size() < 2) return;
            const std::uint32_t* order = inside_.order(boxes);
            choose_levels(boxes);
            fill(boxes, order);
            auto touch = [&](std::size_t p, std::size_t q) { tell(lot_[p].id, lot_[q].id, boxes.active(), found); };
            for (std::size_t n = 0; n < levels_.size(); ++n) {
                if (levels_[n].first == levels_[n].last) continue;
                levels_[n].template neighbours<takes_any_order>(inside_, lot_, touch);
                levels_[n].visitors(lot_, touch);
            }
            for (std::size_t p = few_; p < boxes.size(); ++p) {
                scan(lot_, p, 0, few_, [&](std::size_t q) { touch(p, q); });
                scan(lot_, p, p + 1, boxes.size(), [&](std::size_t q) { touch(p, q); });
            }
        }

    private:
        static constexpr bool takes_any_order = detail::takes_any_order<Inside>;
        static constexpr std::size_t most_levels = 12;
        static constexpr std::size_t fewest = 8; // a grid of fewer is not worth its cells
        static constexpr double wider = 1.25;    // than need be: fewer empty cells
        static constexpr double ratio = 4;       // from one level to the next

        /// How wide a cell must be for this body, at least.
        static double need_of(const Boxes<S>& boxes, std::size_t i) {
            return detail::cell_needed(
                dimension, [&](int k) { return boxes.lower(k)[i]; }, [&](int k) { return boxes.upper(k)[i]; });
        }
        void choose_levels(const Boxes<S>& boxes) {
            needs_.resize(boxes.size());
            double sum = 0, largest = 0;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const double need = needs_[i] = need_of(boxes, i);
                sum += need;
                largest = largest < need ? need : largest;
            }
            const double mean = sum / double(boxes.size());
            double width = cell_ > 0 ? cell_ : largest <= 2 * mean ? wider * largest : mean;
            constexpr double smallest = 1e-290,
                             coarsest = 1e290; // so that 1 / width is a number, and the coarsest width too
            width = std::clamp(width == width ? width : coarsest, smallest, coarsest);
            levels_.resize(most_levels);
            for (Level& level : levels_) {
                level.start(width);
                width *= ratio;
            }
            one_size_ = sum == sum && largest <= levels_[0].width && boxes.size() > fewest;
            if (one_size_) levels_[0].take_all(boxes);
            else sort_by_size(boxes);
            std::size_t first = 0;
            for (Level& level : levels_) {
                level.few = level.count <= fewest;
                if (!level.few) level.lay_out(first, room_);
                level.first = first;
                level.last = first += level.few ? 0 : level.count;
            }
            few_ = first;
        }
        void sort_by_size(const Boxes<S>& boxes) {
            level_of_.resize(boxes.size());
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                std::size_t n = 0;
                while (n < most_levels && !(needs_[i] <= levels_[n].width)) ++n;
                level_of_[i] = std::uint8_t(n);
                if (n < most_levels) levels_[n].take(boxes, i);
            }
        }
        /// The counting sort. All bodies of one size is the usual case, and needs no search of the levels.
        void fill_one(const Boxes<S>& boxes, const std::uint32_t* order) {
            Level& level = levels_[0];
            for (std::size_t i = 0; i < boxes.size(); ++i) places_[i] = level.count_in(boxes, i);
            level.sum_up();
            for (std::size_t m = 0; m < boxes.size(); ++m) {
                const std::uint32_t i = order ? order[m] : std::uint32_t(m);
                lot_.put(level.place(places_[i]), boxes, i);
            }
            level.arrange(inside_, lot_);
        }
        /// The counting sort, of all levels at once: the cells of each are a part of one table.
        void fill(const Boxes<S>& boxes, const std::uint32_t* order) {
            const std::size_t n = boxes.size();
            lot_.make_room(n);
            places_.resize(n);
            if (one_size_) return fill_one(boxes, order);
            for (std::size_t i = 0; i < n; ++i)
                if (level_of_[i] < most_levels && !levels_[level_of_[i]].few)
                    places_[i] = levels_[level_of_[i]].count_in(boxes, i);
            for (Level& level : levels_)
                if (!level.few) level.sum_up();
            std::size_t last = few_;
            for (std::size_t m = 0; m < n; ++m) {
                const std::uint32_t i = order ? order[m] : std::uint32_t(m);
                const bool few = level_of_[i] == most_levels || levels_[level_of_[i]].few;
                lot_.put(few ? last++ : levels_[level_of_[i]].place(places_[i]), boxes, i);
            }
            for (Level& level : levels_)
                if (!level.few) level.arrange(inside_, lot_);
        }

        double cell_;
        bool one_size_ = false;
        typename Inside::template In<S> inside_;
        std::size_t room_ = 0; // for how many boxes there shall be room
        std::size_t few_ = 0;  // where in the lot those begin that are in no grid
        std::vector<double> needs_;
        std::vector<std::uint8_t> level_of_;
        std::vector<std::uint32_t> places_; // first the cell of each body
        std::vector<Level> levels_;
        Lot<S> lot_;
    };
};
/// `UniformGrid{1.0 * metre}` tests boxes in its cells.
template <class Unit> UniformGrid(boost::units::quantity<Unit, double>) -> UniformGrid<>;

} // namespace ansatz
