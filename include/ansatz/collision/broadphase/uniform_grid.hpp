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
///   for each body. Bodies that share a cell from afar cost a test and nothing else.
/// - **Any coordinates**: cells are found by floor, in double, with a margin for its rounding; a body so far out that
///   its cell would not be exact goes to a coarser grid.
///
/// Bodies are put into their cells by a counting sort, without a hash, and their boxes copied in that order, so that
/// three cells in a row are one run of memory (uniform_grid_level.hpp).

#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid_level.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/execution.hpp>

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
            cells_.reserve(n);
            ranks_.reserve(n);
            lot_.reserve(n);
            if constexpr (requires { inside_.reserve(n); }) inside_.reserve(n);
        }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            prepare(boxes, detail::Serially());
            find_in(inside_, boxes, 0, std::numeric_limits<std::size_t>::max(), found);
        }
        /// \name The search in pieces, rows of cells and bodies, which may be searched at the same time
        /// @{
        /// Puts the bodies into cells.
        /// \param run runs a loop over bodies, `run(count, grain, loop)`
        void prepare(const Boxes<S>& boxes, const auto& run) {
            size_ = 0;
            if (boxes.active() == 0 || boxes.size() < 2) return;
            const std::uint32_t* order = inside_.order(boxes);
            choose_levels(boxes, run);
            fill(boxes, order, run);
            size_ = boxes.size();
        }
        /// How many there are.
        std::size_t pieces() const
            requires detail::searches_unchanged<Inside, S>
        {
            std::size_t sum = 0;
            each_part([&](std::size_t count, const auto&...) { sum += count; });
            return sum;
        }
        /// Tells the pairs of some of them, in the order in which `find` tells them.
        template <class F>
        void find(const Boxes<S>& boxes, std::size_t first, std::size_t last, F&& found) const
            requires detail::searches_unchanged<Inside, S>
        {
            find_in(inside_, boxes, first, last, found);
        }
        /// @}

    private:
        static constexpr bool takes_any_order = detail::takes_any_order<Inside>;
        static constexpr std::size_t most_levels = 12;
        static constexpr std::size_t fewest = 8;   // a grid of fewer is not worth its cells
        static constexpr std::size_t grain = 1024; // bodies for which another thread is worth waking
        static constexpr double wider = 1.25;      // than need be: fewer empty cells
        static constexpr double ratio = 4;         // from one level to the next

        enum class Part : unsigned char { rows, visitors, few };
        /// Calls `f(count, part, level)` for each part of the search: rows of cells with each other, bodies of finer
        /// grids in coarser ones, and the few in no grid.
        template <class F> [[gnu::always_inline]] void each_part(const F& f) const {
            if (size_ == 0) return;
            for (const Level& level : levels_) {
                if (level.first == level.last) continue;
                f(level.rows(), Part::rows, &level);
                f(level.first, Part::visitors, &level);
            }
            f(size_ - few_, Part::few, static_cast<const Level*>(nullptr));
        }
        template <class F>
        void find_in(auto& tester, const Boxes<S>& boxes, std::size_t first, std::size_t last, F& found) const {
            const auto touch = [&](std::size_t p, std::size_t q) {
                tell(lot_[p].id, lot_[q].id, boxes.active(), found);
            };
            std::size_t before = 0; // pieces of the parts so far
            each_part([&](std::size_t count, Part part, const Level* level) {
                const std::size_t from = std::max(first, before) - before,
                                  to = std::clamp(last, before, before + count) - before;
                before += count;
                if (from >= to) return;
                if (part == Part::rows) level->template neighbours<takes_any_order>(tester, lot_, from, to, touch);
                else if (part == Part::visitors) level->visitors(lot_, from, to, touch);
                else
                    for (std::size_t p = few_ + from; p < few_ + to; ++p) {
                        scan(lot_, p, 0, few_, [&](std::size_t q) { touch(p, q); });
                        scan(lot_, p, p + 1, size_, [&](std::size_t q) { touch(p, q); });
                    }
            });
        }
        /// How wide a cell must be for this body, at least.
        static double need_of(const Boxes<S>& boxes, std::size_t i) {
            return detail::cell_needed(
                dimension, [&](int k) { return boxes.lower(k)[i]; }, [&](int k) { return boxes.upper(k)[i]; });
        }
        void choose_levels(const Boxes<S>& boxes, const auto& run) {
            needs_.resize(boxes.size());
            run(boxes.size(), grain, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) needs_[i] = need_of(boxes, i);
            });
            double sum = 0, largest = 0;
            for (const double need : needs_) {
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
        /// Puts all bodies into their places. All of one size is the usual case, and needs no search of the levels.
        void fill(const Boxes<S>& boxes, const std::uint32_t* order, const auto& run) {
            lot_.make_room(boxes.size());
            cells_.resize(boxes.size());
            ranks_.resize(boxes.size());
            if (one_size_)
                sort(
                    boxes, order, run, [](std::uint32_t) { return true; },
                    [this](std::uint32_t) -> Level& { return levels_[0]; });
            else
                sort(
                    boxes, order, run,
                    [this](std::uint32_t i) { return level_of_[i] < most_levels && !levels_[level_of_[i]].few; },
                    [this](std::uint32_t i) -> Level& { return levels_[level_of_[i]]; });
        }
        /// The counting sort, of all levels at once: the cells of each are a part of one table. What is done for each
        /// body by itself is done in ranges.
        void sort(const Boxes<S>& boxes, const std::uint32_t* order, const auto& run, const auto& has_cell,
                  const auto& level) {
            const std::size_t n = boxes.size();
            run(n, grain, [&](std::size_t begin, std::size_t end) {
                for (auto i = std::uint32_t(begin); i < end; ++i)
                    if (has_cell(i)) cells_[i] = level(i).cell_of(boxes, i);
            });
            auto last = std::uint32_t(few_);
            for (std::size_t m = 0; m < n; ++m) {
                const std::uint32_t i = order ? order[m] : std::uint32_t(m);
                ranks_[i] = has_cell(i) ? level(i).count_in(cells_[i]) : last++;
            }
            for (Level& one : levels_)
                if (!one.few) one.sum_up();
            run(n, grain, [&](std::size_t begin, std::size_t end) {
                for (auto i = std::uint32_t(begin); i < end; ++i)
                    lot_.put(has_cell(i) ? level(i).start_of(cells_[i]) + ranks_[i] : ranks_[i], boxes, i);
            });
            for (Level& one : levels_)
                if (!one.few) one.arrange(inside_, lot_);
        }

        double cell_;
        bool one_size_ = false;
        typename Inside::template In<S> inside_;
        std::size_t size_ = 0; // how many boxes there are
        std::size_t room_ = 0; // for how many boxes there shall be room
        std::size_t few_ = 0;  // where in the lot those begin that are in no grid
        std::vector<double> needs_;
        std::vector<std::uint8_t> level_of_;
        std::vector<std::uint32_t> cells_; // the cell of each body
        std::vector<std::uint32_t> ranks_; // and how many are in it before this one; or its place, if it has no cell
        std::vector<Level> levels_;
        Lot<S> lot_;
    };
};
/// `UniformGrid{1.0 * metre}` tests boxes in its cells.
template <class Unit> UniformGrid(boost::units::quantity<Unit, double>) -> UniformGrid<>;

} // namespace ansatz
