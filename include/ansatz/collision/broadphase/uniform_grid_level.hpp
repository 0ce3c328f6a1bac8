// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One grid of a `UniformGrid`: the bodies of about one size, by cells (notes 2.1.1, "World Partitioning").

#include <ansatz/collision/broadphase/cells.hpp>
#include <ansatz/collision/broadphase/lot.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz::detail {

/// A grid whose cells are at least as wide as each of its bodies.
template <class S> class GridLevel {
public:
    static constexpr int dimension = S::dimension;
    struct Bounds {
        double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
    };

    double width = 0;                ///< m, of a cell
    std::size_t count = 0;           ///< of its bodies
    std::size_t first = 0, last = 0; ///< of their places
    bool few = true;                 ///< so few that they are in no grid

    /// Empty, with cells of this width.
    void start(double cell) {
        width = cell, per_metre_ = 1 / cell, count = 0;
        bounds_.fill({});
    }
    /// All bodies at once.
    void take_all(const Boxes<S>& boxes) {
        count = boxes.size();
        for (int k = 0; k < dimension; ++k) {
            const auto* low = boxes.lower(k);
            constexpr std::size_t lanes = 16; // or each number waits for the one before
            std::array<typename S::Scalar, lanes> least, most;
            least.fill(low[0]), most.fill(low[0]);
            const auto see = [&](std::size_t lane, std::size_t i) {
                least[lane] = low[i] < least[lane] ? low[i] : least[lane];
                most[lane] = most[lane] < low[i] ? low[i] : most[lane];
            };
            std::size_t i = 0;
            for (; i + lanes <= count; i += lanes)
                for (std::size_t lane = 0; lane < lanes; ++lane) see(lane, i + lane);
            for (; i < count; ++i) see(0, i);
            bounds_[std::size_t(k)] = {double(*std::min_element(least.begin(), least.end())),
                                       double(*std::max_element(most.begin(), most.end()))};
        }
    }
    /// One more body.
    void take(const Boxes<S>& boxes, std::size_t i) {
        ++count;
        for (int k = 0; k < dimension; ++k) {
            const double low = double(boxes.lower(k)[i]);
            Bounds& b = bounds_[std::size_t(k)];
            b.low = low < b.low ? low : b.low;
            b.high = b.high < low ? low : b.high;
        }
    }
    /// Chooses how many cells there are on each axis: all that the bodies need, or so few that they wrap around.
    /// \param room how many bodies there may be another time
    void lay_out(std::size_t first_place, std::size_t room) {
        first = first_place;
        std::array<double, std::size_t(dimension)> needed{};
        for (std::size_t k = 0; k < std::size_t(dimension); ++k) {
            lowest_[k] = double(floor_of(bounds_[k].low * per_metre_));
            needed[k] = double(index_of(k, bounds_[k].high)) + 1;
            cells_[k] = needed[k];
        }
        const double most = most_cells(count);
        auto all = [&] {
            double product = 1;
            for (const double c : cells_) product *= c;
            return product;
        };
        while (all() > most) {
            double& longest = *std::max_element(cells_.begin(), cells_.end());
            longest = std::max(3.0, std::min(std::ceil(longest / 2), std::ceil(longest * most / all())));
        }
        for (std::size_t k = 0; k < std::size_t(dimension); ++k) {
            wraps_[k] = cells_[k] < needed[k];
            size_[k] = std::int64_t(cells_[k]);
            per_cells_[k] = 1 / cells_[k];
        }
        starts_.reserve(std::size_t(most_cells(std::max(count, room))) + 1); // for the next times as well
        starts_.assign(std::size_t(all()) + 1, 0);
    }
    /// The cell of a body.
    [[gnu::always_inline]] std::uint32_t cell_of(const Boxes<S>& boxes, std::size_t i) const {
        std::int64_t cell = 0;
        for (int k = dimension - 1; k >= 0; --k)
            cell = cell * size_[std::size_t(k)] +
                   on_axis(std::size_t(k), index_of(std::size_t(k), double(boxes.lower(k)[i])));
        return std::uint32_t(cell);
    }
    /// Another body in a cell.
    /// \return how many were there before
    [[gnu::always_inline]] std::uint32_t count_in(std::uint32_t cell) { return starts_[std::size_t(cell) + 1]++; }
    /// From how many are in each cell to where each begins.
    void sum_up() {
        starts_[0] = std::uint32_t(first);
        for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    }
    /// Where a cell begins.
    [[gnu::always_inline]] std::size_t start_of(std::uint32_t cell) const { return starts_[cell]; }

    template <class Inside> void arrange(Inside& inside, Lot<S>& lot) const {
        for (std::size_t c = 0; c + 1 < starts_.size(); ++c)
            if (starts_[c + 1] - starts_[c] > 1) inside.arrange(lot, starts_[c], starts_[c + 1]);
    }

    /// How many rows of cells there are.
    std::size_t rows() const {
        return std::size_t(dimension == 3 ? size_[1] * size_[std::size_t(dimension) - 1] : size_[1]);
    }
    /// Each two of its bodies in one cell or in cells that share a corner, the first of them in one of these rows.
    template <bool join_cells, class Inside, class F>
    void neighbours(Inside& inside, const Lot<S>& lot, std::size_t begin, std::size_t end, F&& touch) const {
        const auto height = std::size_t(size_[1]);
        std::size_t y = begin % height, z = begin / height;
        for (std::size_t n = begin; n < end; ++n) {
            row<join_cells>(inside, lot, std::int64_t(y), std::int64_t(z), touch);
            if (++y == height) y = 0, ++z;
        }
    }
    /// Each of these bodies of the finer levels, which are before it, with those of its own bodies that may reach it.
    template <class F> void visitors(const Lot<S>& lot, std::size_t begin, std::size_t end, F&& touch) const {
        for (std::size_t p = begin; p < end; ++p) {
            std::array<std::int64_t, 3> from{}, to{};
            for (std::size_t k = 0; k < std::size_t(dimension); ++k) {
                from[k] = index_of(k, double(lot[p].lower(k))) - 1;
                to[k] = index_of(k, double(lot[p].upper(k)));
                if (!wraps_[k]) from[k] = std::max<std::int64_t>(from[k], 0), to[k] = std::min(to[k], size_[k] - 1);
            }
            for (std::int64_t z = from[2]; z <= to[2]; ++z)
                for (std::int64_t y = from[1]; y <= to[1]; ++y) {
                    const std::int64_t base = base_of(y, z);
                    runs(from[0], to[0], [&](std::int64_t a, std::int64_t b) {
                        scan(lot, p, starts_[std::size_t(base + a)], starts_[std::size_t(base + b)],
                             [&](std::size_t q) { touch(p, q); });
                    });
                }
        }
    }

private:
    static constexpr double cells_a_body = 4;
    static double most_cells(std::size_t bodies) { return std::max(64.0, cells_a_body * double(bodies)); }

    /// The cell on an axis, counted from the lowest.
    /// Behind the lowest cutting off is rounding down; before it there is no body, and 0 is as good as any.
    [[gnu::always_inline]] std::int64_t index_of(std::size_t k, double coordinate) const {
        return std::int64_t(coordinate * per_metre_ - lowest_[k]);
    }
    /// The same, where cells wrap around.
    [[gnu::always_inline]] std::int64_t on_axis(std::size_t k, std::int64_t index) const {
        if (!wraps_[k]) return index;
        const std::int64_t rest =
            index -
            size_[k] * floor_of(double(index) * per_cells_[k]); // the quotient may be off by one at a whole number
        return rest < 0 ? rest + size_[k] : rest >= size_[k] ? rest - size_[k] : rest;
    }
    std::int64_t base_of(std::int64_t y, std::int64_t z) const {
        if constexpr (dimension == 3) return (on_axis(2, z) * size_[1] + on_axis(1, y)) * size_[0];
        return on_axis(1, y) * size_[0];
    }
    /// Cells from..to of a row, three at most, as runs [a, b): one, or two where they wrap around.
    template <class F> [[gnu::always_inline]] void runs(std::int64_t from, std::int64_t to, F&& run) const {
        if (from > to) return;
        if (!wraps_[0]) return run(from, to + 1);
        const std::int64_t a = on_axis(0, from), b = a + (to - from) + 1;
        if (b <= size_[0]) return run(a, b);
        run(a, size_[0]);
        run(0, b - size_[0]);
    }

    /// One row of cells with itself and with the rows after it. Of two neighbours one is after the other: no pair of
    /// cells comes twice, and where cells wrap around there are three on the axis at least, so that none is on both
    /// sides.
    /// \tparam join_cells the lists of a row of cells are tested as one
    template <bool join_cells, class Inside, class F>
    void row(Inside& inside, const Lot<S>& lot, std::int64_t y, std::int64_t z, F& touch) const {
        const std::int64_t base = base_of(y, z);
        if (starts_[std::size_t(base)] == starts_[std::size_t(base + size_[0])]) return;
        std::array<std::int64_t, 4> after{};
        std::size_t count_after = 0;
        auto add = [&](std::int64_t other_y, std::int64_t other_z) {
            if (!wraps_[1] && (other_y < 0 || other_y >= size_[1])) return;
            if (dimension == 3 && !wraps_[std::size_t(dimension) - 1] && other_z >= size_[std::size_t(dimension) - 1])
                return;
            after[count_after++] = base_of(other_y, other_z);
        };
        add(y + 1, z);
        if constexpr (dimension == 3)
            for (int dy = -1; dy <= 1; ++dy) add(y + dy, z + 1);
        std::array<Run, 26> found; // the cells around it that are not empty: no branch for each that is
        for (std::int64_t x = 0; x < size_[0]; ++x) {
            const std::size_t from = starts_[std::size_t(base + x)], to = starts_[std::size_t(base + x + 1)];
            if (from == to) continue;
            std::size_t runs_found = 0;
            auto add_run = [&](std::size_t begin, std::size_t end) {
                found[runs_found] = {starts_[begin], starts_[end]};
                runs_found += found[runs_found].from != found[runs_found].to;
            };
            auto test = [&](std::int64_t other_base, std::int64_t a, std::int64_t b) {
                if (!wraps_[0]) a = std::max<std::int64_t>(a, 0), b = std::min(b, size_[0] - 1);
                runs(a, b, [&](std::int64_t c, std::int64_t d) {
                    if constexpr (join_cells) add_run(std::size_t(other_base + c), std::size_t(other_base + d));
                    else
                        for (; c < d; ++c) add_run(std::size_t(other_base + c), std::size_t(other_base + c + 1));
                });
            };
            test(base, x + 1, x + 1);
            for (std::size_t n = 0; n < count_after; ++n) test(after[n], x - 1, x + 1);
            inside.among(lot, from, to, touch);
            for (std::size_t n = 0; n < runs_found; ++n)
                inside.between(lot, from, to, found[n].from, found[n].to, touch);
        }
    }

    struct Run {
        std::uint32_t from, to;
    };
    double per_metre_ = 0;
    std::array<Bounds, std::size_t(dimension)> bounds_{};
    std::array<std::int64_t, std::size_t(dimension)> size_{};
    std::array<double, std::size_t(dimension)> lowest_{}, cells_{}, per_cells_{};
    std::array<bool, std::size_t(dimension)> wraps_{};
    std::vector<std::uint32_t> starts_; // where in the lot each cell begins
};

} // namespace ansatz::detail
