// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `KeptPairs`: boxes that are wider than those of the bodies, and which of them touch: what `Coherent` keeps from one
/// call to the next (notes 2.1.1).
///
/// While every box is inside its fat one, all that touch are among the pairs of fat ones that do. A box that has left
/// its own gets another, whose pairs are found in a table of cells; where many have left, all is made anew. A user
/// of the library needs none of this.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/broadphase/box_table.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz::detail {

/// Two boxes by their indices, the smaller first.
struct BoxPair {
    std::uint32_t i, j;
    std::uint64_t key() const { return std::uint64_t(i) << 32 | j; } ///< their order
    friend bool operator<(BoxPair a, BoxPair b) { return a.key() < b.key(); }
    friend bool operator==(BoxPair a, BoxPair b) { return a.key() == b.key(); }
};

/// Puts pairs in order; keeps the room that it needs.
class PairSorter {
public:
    /// Room for pairs of so many boxes.
    void reserve(std::size_t boxes) { end_.reserve(boxes + 1); }
    /// A counting sort by the first index, then those of each first one by the second.
    /// \param boxes how many there are
    void sort(const std::vector<BoxPair>& from, std::size_t boxes, std::vector<BoxPair>& to) {
        end_.assign(boxes + 1, 0);
        for (const BoxPair p : from) ++end_[p.i + 1];
        for (std::size_t i = 0; i < boxes; ++i) end_[i + 1] += end_[i];
        to.resize(from.size());
        for (const BoxPair p : from) to[end_[p.i]++] = p;
        std::size_t first = 0;
        for (std::size_t i = 0; i < boxes; ++i) {
            by_second(to, first, end_[i]);
            first = end_[i];
        }
    }

private:
    static void by_second(std::vector<BoxPair>& all, std::size_t first, std::size_t last) {
        constexpr std::size_t few = 16;
        if (last - first > few) {
            std::sort(all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(last));
            return;
        }
        for (std::size_t p = first + 1; p < last; ++p) {
            const BoxPair pair = all[p];
            std::size_t q = p;
            for (; q > first && pair.j < all[q - 1].j; --q) all[q] = all[q - 1];
            all[q] = pair;
        }
    }
    std::vector<std::uint32_t> end_; // where the next pair of each box goes
};

/// A box as it is tested, which is read from one line of the cache.
template <class S> struct PlacedBox {
    using Scalar = typename S::Scalar;
    static constexpr std::size_t lanes = S::dimension == 3 ? 4 : 2;
    static constexpr std::size_t line = std::min<std::size_t>(64, std::bit_ceil(2 * lanes * sizeof(Scalar)));

    alignas(line) std::array<Scalar, lanes> low; ///< m; the fourth of three is not used
    std::array<Scalar, lanes> high;              ///< m
};

/// The mean over boxes that move, between two calls.
struct BoxMotion {
    double width = 0; ///< m, of a box's longest side
    double moved = 0; ///< m, how far that one of its sides moved which moved most
};

/// \tparam S the space
template <class S> class KeptPairs {
    using Scalar = typename S::Scalar;
    static constexpr std::size_t dimension = std::size_t(S::dimension);

public:
    /// Room for so many boxes.
    void reserve(std::size_t n) {
        room_ = n;
        for (auto& all : placed_) all.reserve(n);
        fat_.reserve(n);
        left_.reserve(n);
        has_left_.reserve(n);
        sorter_.reserve(n);
        table_.reserve(n);
    }
    /// How many pairs there are: of fat boxes, or those of the last `find`.
    std::size_t size() const { return pairs_.size(); }
    /// One of them.
    BoxPair operator[](std::size_t n) const { return pairs_[n]; }
    /// How many had left their fat boxes in the last `follow`.
    std::size_t left() const { return left_.size(); }
    /// How many are too wide for the table of cells.
    std::size_t wide() const { return table_is_made_ ? table_.wide() : 0; }
    /// Whether there is a table of cells.
    bool table_is_made() const { return table_is_made_; }

    /// Reads the boxes of this call, and remembers them.
    void watch(const Boxes<S>& boxes) {
        auto& placed = next_places(boxes);
        for (std::size_t i = 0; i < boxes.size(); ++i) place(placed[i], boxes, i);
    }
    /// The same, and notes which bodies have left their fat box.
    /// \param run runs loops, `run(count, grain, loop)`
    void follow(const Boxes<S>& boxes, const auto& run) {
        constexpr std::size_t block = 32; // tested at once, without a branch
        auto& placed = next_places(boxes);
        run((boxes.size() + block - 1) / block, blocks_worth_a_thread, [&](std::size_t begin, std::size_t end) {
            for (std::size_t first = begin * block; first < std::min(end * block, boxes.size()); first += block) {
                const std::size_t count = std::min(block, boxes.size() - first);
                std::array<std::uint8_t, block> out{};
                for (int k = 0; k < S::dimension; ++k) {
                    const Scalar *low = boxes.lower(k) + first, *high = boxes.upper(k) + first;
                    const Scalar *least = fat_.lower(k) + first, *most = fat_.upper(k) + first;
                    for (std::size_t n = 0; n < count; ++n)
                        out[n] =
                            std::uint8_t(out[n] | unsigned(!(least[n] <= low[n])) | unsigned(!(high[n] <= most[n])));
                }
                for (std::size_t n = 0; n < count; ++n) place(placed[first + n], boxes, first + n);
                for (std::size_t n = 0; n < count; ++n) has_left_[first + n] = out[n];
            }
        });
        left_.clear();
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (has_left_[i]) left_.push_back(std::uint32_t(i));
    }
    /// Between the last two calls of `watch` and `follow`, for the first so many boxes.
    BoxMotion motion(std::size_t active) const {
        BoxMotion sum;
        for (std::size_t i = 0; i < active; ++i) {
            const PlacedBox<S>&before = placed_[1 - now_][i], &after = placed_[now_][i];
            double wide = 0, moved = 0;
            for (std::size_t k = 0; k < dimension; ++k) {
                wide = std::max(wide, double(after.high[k]) - double(after.low[k]));
                moved = std::max({moved, std::abs(double(after.low[k]) - double(before.low[k])),
                                  std::abs(double(after.high[k]) - double(before.high[k]))});
            }
            sum.width += wide, sum.moved += moved;
        }
        return {sum.width / double(active), sum.moved / double(active)};
    }

    /// The pairs of these boxes as a broadphase finds them, in order. What was kept is lost.
    template <class Finder> void find(Finder& inner, const Boxes<S>& boxes) {
        search(inner, boxes);
        make_room(boxes.size());
    }
    /// Makes all fat boxes from the last two calls, and finds their pairs.
    /// \param calls for how many a body that goes on as it does shall stay in its own
    /// \return whether that could be: not with a box that is not finite
    template <class Finder> bool make(Finder& inner, const Boxes<S>& boxes, const BoxMotion& motion, double calls) {
        table_is_made_ = false;
        typical_ = Scalar(std::min(double(std::numeric_limits<Scalar>::max()), motion.width));
        fat_.resize(boxes.size());
        fat_.set_active(boxes.active());
        has_left_.assign(boxes.size(), 0);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (!fatten(i, calls)) return false;
        search(inner, fat_);
        return true;
    }
    /// Gives those that have left other fat boxes, and finds the pairs of these.
    /// \return whether that could be: not with a box that is not finite
    bool amend(double calls) {
        if (!table_is_made_) make_table();
        for (const std::uint32_t i : left_) {
            table_.take(i);
            if (!fatten(i, calls)) return false;
            table_.put(fat_, i);
        }
        const std::size_t known = pairs_.size();
        for (const std::uint32_t i : left_)
            table_.near(i, [&](std::uint32_t j) {
                const BoxPair pair{std::min(i, j), std::max(i, j)};
                if (i == j || pair.i >= fat_.active() || (has_left_[j] && j < i)) return; // of two that left, one tells
                pairs_.push_back(pair);
            });
        merge(known);
        return true;
    }
    /// Tells those of the pairs begin to end - 1 whose boxes of the last `follow` touch, in order.
    /// \return how many
    template <class F> std::size_t tell(std::size_t begin, std::size_t end, F&& found) const {
        constexpr std::size_t block = 256, ahead = 16;
        std::array<BoxPair, block> touching;
        std::size_t told = 0;
        const PlacedBox<S>* const all = placed_[now_].data();
        for (std::size_t first = begin; first < end; first += block) {
            const std::size_t last = std::min(first + block, end);
            std::size_t count = 0; // each is written, and stays if it touches: a branch could not be foreseen
            for (std::size_t p = first; p < last; ++p) {
                __builtin_prefetch(all + pairs_[std::min(p + ahead, end - 1)].j); // they are far apart
                touching[count] = pairs_[p];
                count += touch(all[pairs_[p].i], all[pairs_[p].j]);
            }
            for (std::size_t n = 0; n < count; ++n) found(std::size_t(touching[n].i), std::size_t(touching[n].j));
            told += count;
        }
        return told;
    }

private:
    static constexpr std::size_t blocks_worth_a_thread = 32; // of 32 boxes: fewer take less time than waking one
    static constexpr double skin = 0.05;                     // of a box's longest side, all around
    static constexpr double farthest = 0.5; // of it or a typical one's: or the fast are tested against all on their way

    /// Where the boxes of this call are kept; those of the last one stay.
    std::vector<PlacedBox<S>>& next_places(const Boxes<S>& boxes) {
        if (room_ < boxes.size()) reserve(boxes.size()); // all at once: what comes later shall not allocate
        now_ = 1 - now_;
        if (placed_[now_].size() < boxes.size()) placed_[now_].resize(boxes.size());
        return placed_[now_];
    }
    [[gnu::always_inline]] static void place(PlacedBox<S>& to, const Boxes<S>& boxes, std::size_t i) {
        for (std::size_t k = 0; k < dimension; ++k)
            to.low[k] = boxes.lower(int(k))[i], to.high[k] = boxes.upper(int(k))[i];
    }
    [[gnu::always_inline]] static unsigned touch(const PlacedBox<S>& a, const PlacedBox<S>& b) {
        unsigned is = 1;
        for (std::size_t k = 0; k < dimension; ++k)
            is &= unsigned(a.low[k] <= b.high[k]) & unsigned(b.low[k] <= a.high[k]);
        return is;
    }
    /// Makes a box longer in the direction in which its sides go, and a little wider all around.
    /// \return whether it is finite
    bool fatten(std::size_t i, double calls) {
        const Scalar most = std::numeric_limits<Scalar>::max(), least = std::numeric_limits<Scalar>::lowest();
        const PlacedBox<S>&before = placed_[1 - now_][i], &after = placed_[now_][i];
        Scalar wide(0), wrong(0); // 0, or 0 / 0
        for (std::size_t k = 0; k < dimension; ++k) {
            wide = std::max(wide, Scalar(after.high[k] - after.low[k]));
            wrong += (after.low[k] - after.low[k]) + (after.high[k] - after.high[k]);
        }
        const Scalar reach = Scalar(farthest) * std::max(typical_, wide), around = Scalar(skin) * wide;
        Vector<Scalar, S::dimension> low, high;
        for (std::size_t k = 0; k < dimension; ++k) {
            const Scalar down = std::max(Scalar(0), Scalar(Scalar(calls) * (before.low[k] - after.low[k])));
            const Scalar up = std::max(Scalar(0), Scalar(Scalar(calls) * (after.high[k] - before.high[k])));
            low[int(k)] = std::max(Scalar(after.low[k] - std::min(down, reach) - around), least);
            high[int(k)] = std::min(Scalar(after.high[k] + std::min(up, reach) + around), most);
        }
        fat_.set(i, S::Position::from_value(low), S::Position::from_value(high));
        return wrong == Scalar(0);
    }
    /// Of cells for the fat boxes of bodies of typical width.
    void make_table() {
        const double width = double(typical_) * (1.01 + farthest + 2 * skin);
        table_.make(fat_, width > 1e-290 && width < 1e290 ? width : 1);
        table_is_made_ = true;
    }
    /// The pairs of those that have left give way to the new ones, which stand behind those that were known.
    void merge(std::size_t known) {
        const auto fresh = pairs_.begin() + std::ptrdiff_t(known);
        std::sort(fresh, pairs_.end());
        pairs_.erase(std::unique(fresh, pairs_.end()), pairs_.end());
        spare_.resize(pairs_.size());
        BoxPair* to = spare_.data();
        auto next = fresh;
        for (auto pair = pairs_.begin(); pair != fresh; ++pair) {
            while (next != pairs_.end() && *next < *pair) *to++ = *next++;
            *to = *pair;
            to += 1 - (has_left_[pair->i] | has_left_[pair->j]);
        }
        to = std::copy(next, pairs_.end(), to);
        spare_.resize(std::size_t(to - spare_.data()));
        pairs_.swap(spare_);
    }
    template <class Finder> void search(Finder& inner, const Boxes<S>& boxes) {
        spare_.clear();
        inner.find(boxes, [this](std::size_t i, std::size_t j) {
            spare_.push_back({std::uint32_t(i), std::uint32_t(j)});
        });
        sorter_.sort(spare_, boxes.size(), pairs_);
    }
    /// Room for more pairs than touch: fat boxes have more, they come and go, and a warm call shall not allocate.
    void make_room(std::size_t boxes) {
        const double more = std::max(1.0, double(room_) / double(boxes));
        const auto least = std::max(room_, boxes) + std::size_t(3 * more * more * double(pairs_.size()));
        for (auto* all : {&pairs_, &spare_})
            if (all->capacity() < least) all->reserve(least + least / 8);
    }

    std::size_t now_ = 0, room_ = 0;                    // which of two; for how many boxes there shall be room
    std::array<std::vector<PlacedBox<S>>, 2> placed_{}; // the boxes of this call, and of the one before
    Boxes<S> fat_;
    Scalar typical_{0}; // m, how wide a box is
    bool table_is_made_ = false;
    std::vector<BoxPair> pairs_, spare_; // the second while the first is made, in turn
    std::vector<std::uint32_t> left_;
    std::vector<std::uint8_t> has_left_; // by box: 1 if it left its fat one in the last `follow`
    PairSorter sorter_;
    BoxTable<S> table_;
};

} // namespace ansatz::detail
