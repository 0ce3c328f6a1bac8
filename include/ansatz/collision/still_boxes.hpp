// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StillBoxes`: the boxes of bodies that are fixed or at rest (notes 1.1), kept from step to step, so that a step
/// tests only those which a moving body comes near to. A broadphase (notes 2.1.1) is given these and the bodies that
/// move: a level of ten thousand fixed boxes costs what is met of it.
///
/// It is a spatial hash with several grids, each four times as coarse as the one before. A box is in the cell of its
/// lower corner, in a grid whose cells are wider than the box. In each step the ids and places of still bodies are
/// compared with those of the step before, where `Bodies::changes` says that some may differ, and only boxes of bodies
/// that do are taken out and put in again.

#include <ansatz/collision/broadphase/cells.hpp>
#include <ansatz/units.hpp>
#include <ansatz/world/bodies.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz {

/// The boxes of still bodies, by cells. It is a cache: all of it can be made again from where the bodies are.
template <class S> class StillBoxes {
public:
    using Raw = Vector<typename S::Scalar, S::dimension>; ///< raw SI
    using Corner = typename S::Position;                  ///< m
    /// With fewer it is as quick to go through all of them.
    static constexpr std::size_t fewest = 64;

    /// Room for so many bodies, with ids below `ids`.
    void make_room(std::size_t bodies, std::size_t ids) {
        if (seen_.size() < bodies) { // `seen_` last: if an allocation fails, the next call makes all of them
            const std::size_t slots = std::max(bodies, 2 * seen_.size());
            changed_.reserve(slots);
            for (auto& lane : places_) lane.resize(slots);
            blocks_.resize(slots / Bodies::block + 1, never);
            seen_.resize(slots, none);
        }
        if (boxes_.size() >= ids) return;
        const std::size_t boxes = std::max(ids, 2 * boxes_.size());
        std::size_t heads = 64;
        while (heads < boxes) heads *= 2;
        if (heads != heads_.size()) {
            heads_.resize(heads);
            forget();
        }
        boxes_.resize(boxes);
    }
    /// Forgets all boxes; the next `follow` puts them in again.
    void forget() {
        std::fill(heads_.begin(), heads_.end(), none);
        std::fill(seen_.begin(), seen_.end(), none);
        std::fill(blocks_.begin(), blocks_.end(), never);
        changes_ = never;
        for (auto& box : boxes_) box.grid = none;
        count_.fill(0);
        used_ = 0;
        ranges_ = {};
    }
    /// Forgets the box of a body: it has been removed, or has another shape.
    void forget(std::uint32_t id) {
        if (id >= boxes_.size()) return;
        const auto slot = boxes_[id].slot;
        if (slot < seen_.size() && seen_[slot] == id) {
            seen_[slot] = none;
            blocks_[slot / Bodies::block] = never;
            changes_ = never;
        }
        if (boxes_[id].grid != none) remove(id);
    }
    /// Where bodies are: the lane of each coordinate, by slot, m.
    using Places = std::array<const typename S::Scalar*, std::size_t(S::dimension)>;
    /// Puts in, takes out and replaces the boxes of all still bodies that are not as they were in the last call.
    /// \param bounds `bounds(slot, lower, upper)`: the box of a body; false, where it has none that is finite
    /// \param world  a number that changes when another world is assigned to this one
    template <class Bounds>
    void follow(const Bodies& bodies, std::uint64_t world, const Places& places, const Bounds& bounds) {
        if (complete_ && world == world_ && changes_ == bodies.changes()) return;
        make_room(bodies.size(), bodies.ids());
        if (!complete_ || world != world_) forget();
        world_ = world;
        complete_ = false; // until all are there: `bounds` may throw
        changed_.clear();
        const std::array<Range, 2> now{Range{bodies.begin(Motion::resting), bodies.end(Motion::resting)},
                                       Range{bodies.begin(Motion::fixed), bodies.end(Motion::fixed)}};
        for (const auto& range : now) compare(bodies, places, range);
        std::copy_n(bodies.changes_by_block().begin(), std::min(blocks_.size(), bodies.changes_by_block().size()),
                    blocks_.begin());
        for (const auto& range : ranges_) // slots in which no body stands still any more
            for (std::size_t slot = range.begin; slot < range.end;) {
                if (now[0].holds(slot)) slot = now[0].end;
                else if (now[1].holds(slot)) slot = now[1].end;
                else {
                    if (seen_[slot] != none) changed_.push_back(std::uint32_t(slot));
                    ++slot;
                }
            }
        for (const auto slot : changed_) { // all are taken out before any is put in: some have exchanged slots
            if (seen_[slot] != none && boxes_[seen_[slot]].grid != none) remove(seen_[slot]);
            seen_[slot] = none;
        }
        for (const auto slot : changed_) {
            if (!now[0].holds(slot) && !now[1].holds(slot)) continue;
            const auto id = bodies.id(slot);
            Corner lower, upper;
            if (bounds(slot, lower, upper)) insert(id, lower, upper);
            seen_[slot] = id;
            for (std::size_t k = 0; k < dimension; ++k) places_[k][slot] = places[k][slot];
            boxes_[id].slot = slot;
        }
        ranges_ = now;
        changes_ = bodies.changes();
        complete_ = true;
    }
    /// Begins a round of queries, in which each box is found once.
    void begin_asking() {
        if (++asked_ != 0) return;
        for (auto& box : boxes_) box.asked = 0;
        asked_ = 1;
    }
    /// Calls `f(id, lower, upper)` for each box that touches the one from `lower` to `upper` and was not found before
    /// in this round.
    template <class F> void each_near(const Raw& lower, const Raw& upper, F&& f) {
        for (std::uint64_t left = used_; left != 0; left &= left - 1) {
            const auto grid = std::uint32_t(std::countr_zero(left));
            const auto& extent = extents_[grid];
            Cell from{}, to{};
            double cells = 1;
            for (std::size_t k = 0; k < dimension; ++k) {
                from[k] = std::max(cell_of(double(lower[int(k)]), grid) - 1, extent.from[k]);
                to[k] = std::min(cell_of(double(upper[int(k)]), grid), extent.to[k]);
                cells *= double(std::max(to[k] - from[k] + 1, std::int64_t(0)));
            }
            if (cells == 0) continue;
            if (cells > double(boxes_.size())) return each_of_all(lower, upper, f);
            const auto row = [&](std::uint64_t sum) {
                for (auto x = from[0]; x <= to[0]; ++x, sum += odd[0])
                    for (auto id = heads_[bucket_of(sum)]; id != none; id = boxes_[id].next) find(id, lower, upper, f);
            };
            const auto plane = [&](std::uint64_t sum) {
                for (auto y = from[1]; y <= to[1]; ++y, sum += odd[1]) row(sum);
            };
            auto sum = sum_of(from, grid);
            if constexpr (dimension == 2) plane(sum);
            else
                for (auto z = from[2]; z <= to[2]; ++z, sum += odd[2]) plane(sum);
        }
    }

private:
    static constexpr std::size_t dimension = std::size_t(S::dimension);
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t never = 0;
    static constexpr std::uint32_t grids = 64; // 4^-32 m, 4^-31 m, ..., and one that has a single cell
    static constexpr std::array<double, grids> per_metre = [] {
        std::array<double, grids> all{};       // the last one stays zero: all coordinates are in one cell
        double cells = 18446744073709551616.0; // 4^32
        for (std::uint32_t grid = 0; grid + 1 < grids; ++grid) {
            all[grid] = cells;
            cells /= 4;
        }
        return all;
    }();
    using Cell = std::array<std::int64_t, dimension>;
    // Random odd numbers, one for each axis: what a step to the next cell adds to the hash.
    static constexpr std::array<std::uint64_t, 3> odd{0xbf58476d1ce4e5b9ull, 0x94d049bb133111ebull,
                                                      0xff51afd7ed558ccdull};
    static constexpr Cell all_cells(std::int64_t cell) {
        Cell all{};
        for (auto& c : all) c = cell;
        return all;
    }
    /// In which cells of a grid there are boxes; it does not shrink before the last of them is gone.
    struct Extent {
        Cell from = all_cells(std::numeric_limits<std::int64_t>::max());
        Cell to = all_cells(std::numeric_limits<std::int64_t>::min());
    };

    struct Box {
        Raw lower, upper;                         // m
        std::uint32_t next = none, before = none; // in its bucket
        std::uint32_t bucket = 0;
        std::uint32_t grid = none; // none: it is in no grid
        std::uint32_t slot = 0;    // where it was seen
        std::uint32_t asked = 0;   // the last round in which it was found
    };
    struct Range {
        std::size_t begin = 0, end = 0;
        bool holds(std::size_t slot) const { return slot >= begin && slot < end; }
    };

    /// Notes the slots of a range in which there is another body than before, or at another place. Often there is
    /// none in a block, so that its slots are compared without a branch.
    void compare(const Bodies& bodies, const Places& places, const Range& range) {
        const auto& blocks = bodies.changes_by_block();
        for (std::size_t begin = range.begin, end; begin < range.end; begin = end) {
            const auto block = begin / Bodies::block;
            end = std::min((block + 1) * Bodies::block, range.end);
            if (blocks[block] == blocks_[block]) continue;
            const auto differs = [&](std::size_t from, std::size_t to) {
                unsigned any = 0; // not a bool, which g++ 12 does not vectorize
                const auto differ = [&](const auto* seen, const auto* now) {
                    for (std::size_t slot = from; slot < to; ++slot) any |= unsigned(!(seen[slot] == now[slot]));
                };
                differ(seen_.data(), bodies.ids_by_slot());
                for (std::size_t k = 0; k < dimension; ++k) differ(places_[k].data(), places[k]);
                return any != 0;
            };
            if (!differs(begin, end)) continue;
            for (std::size_t slot = begin; slot < end; ++slot)
                if (differs(slot, slot + 1)) changed_.push_back(std::uint32_t(slot));
        }
    }

    /// The finest grid whose cells are wide enough for a box.
    static std::uint32_t grid_of(const Raw& lower, const Raw& upper) {
        const double need = detail::cell_needed(
            S::dimension, [&](int k) { return lower[k]; }, [&](int k) { return upper[k]; });
        if (!(need > 0)) return 0;
        const int exponent = std::ilogb(need) + 1; // 2^exponent is the least power of two above it
        return std::uint32_t(std::clamp((exponent + (exponent & 1)) / 2 + 32, 0, int(grids) - 1));
    }
    /// The cell of a coordinate. No box of a grid is more than 2^38 cells from the origin, so that what is farther away
    /// is held at 2^40.
    static std::int64_t cell_of(double coordinate, std::uint32_t grid) {
        constexpr double far = double(1ull << 40);
        return detail::floor_of(std::clamp(coordinate * per_metre[grid], -far, far));
    }
    /// The hash of a cell, not yet mixed: it grows by `odd[k]` from one cell to the next along axis k.
    static std::uint64_t sum_of(const Cell& cell, std::uint32_t grid) {
        std::uint64_t sum = grid * 0xd6e8feb86659fd93ull;
        for (std::size_t k = 0; k < dimension; ++k) sum += std::uint64_t(cell[k]) * odd[k];
        return sum;
    }
    std::uint32_t bucket_of(std::uint64_t sum) const {
        sum = (sum ^ (sum >> 32)) * 0x9e3779b97f4a7c15ull;
        return std::uint32_t(sum >> 32) & std::uint32_t(heads_.size() - 1);
    }

    void insert(std::uint32_t id, const Corner& lower, const Corner& upper) {
        Box& box = boxes_[id];
        box.lower = lower.value();
        box.upper = upper.value();
        box.grid = grid_of(box.lower, box.upper);
        Cell cell{};
        auto& extent = extents_[box.grid];
        if (count_[box.grid] == 0) extent = {};
        for (std::size_t k = 0; k < dimension; ++k) {
            cell[k] = cell_of(double(box.lower[int(k)]), box.grid);
            extent.from[k] = std::min(extent.from[k], cell[k]);
            extent.to[k] = std::max(extent.to[k], cell[k]);
        }
        box.bucket = bucket_of(sum_of(cell, box.grid));
        box.before = none;
        box.next = heads_[box.bucket];
        if (box.next != none) boxes_[box.next].before = id;
        heads_[box.bucket] = id;
        ++count_[box.grid];
        used_ |= std::uint64_t(1) << box.grid;
    }
    void remove(std::uint32_t id) {
        Box& box = boxes_[id];
        if (box.next != none) boxes_[box.next].before = box.before;
        if (box.before != none) boxes_[box.before].next = box.next;
        else heads_[box.bucket] = box.next;
        if (--count_[box.grid] == 0) used_ &= ~(std::uint64_t(1) << box.grid);
        box.grid = none;
    }
    template <class F> [[gnu::always_inline]] void find(std::uint32_t id, const Raw& lower, const Raw& upper, F& f) {
        Box& box = boxes_[id];
        if (box.asked == asked_) return;
        for (int k = 0; k < int(dimension); ++k)
            if (!(box.lower[k] <= upper[k] && lower[k] <= box.upper[k])) return;
        box.asked = asked_;
        f(id, Corner::from_value(box.lower), Corner::from_value(box.upper));
    }
    /// The same for a box that reaches over more cells than there are bodies.
    template <class F> void each_of_all(const Raw& lower, const Raw& upper, F& f) {
        for (std::uint32_t id = 0; id < boxes_.size(); ++id)
            if (boxes_[id].grid != none) find(id, lower, upper, f);
    }

    std::vector<Box> boxes_;                                        // by id
    std::vector<std::uint32_t> seen_;                               // by slot: whose id was there
    std::array<std::vector<typename S::Scalar>, dimension> places_; // by slot: and where, m
    std::vector<std::uint32_t> blocks_;                             // what `Bodies::changes_by_block` was
    std::vector<std::uint32_t> heads_;                              // the first of each bucket
    std::vector<std::uint32_t> changed_;
    std::array<std::size_t, grids> count_{};
    std::array<Extent, grids> extents_{};
    std::uint64_t used_ = 0; // a bit for each grid in which there is a box
    std::array<Range, 2> ranges_{};
    std::uint32_t asked_ = 0;
    std::uint64_t world_ = 0;
    std::uint64_t changes_ = never; // what `Bodies::changes` was
    bool complete_ = true;          // whether the last `follow` came to its end
};

} // namespace ansatz
