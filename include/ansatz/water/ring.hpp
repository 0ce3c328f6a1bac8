// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WaterRing`: the columns around a body that lies in water. What it displaces rises there, and there its level is
/// read.
///
/// Under the body it cannot be: what it presses up would be the level that it floats at, and it would climb on its own
/// water. The ring begins at the edge of the body's footprint and is three columns wide, or as wide as the body is
/// where that is more, so that it holds about three times the body's section whatever the columns are. Its inner and
/// outer edge fade over one column, so that a body that drifts crosses no step. Each column counts by its footprint,
/// and a column without water does not count.
///
/// Where walls leave less of it than 1.5 times the section of the body, the rest is shared by all columns of the pool:
/// a pool smaller than a ring is its own ring. Where dry ground does, the body has room for a part of its water only
/// (`room`), and in a ring without water it is dry. Rings overlap freely: each body's water is added.

#include <ansatz/water/column_grid.hpp>

#include <numbers>

namespace ansatz {

/// What a body covers of the plane of x and z, in m.
struct Footprint {
    double x = 0;       ///< of its middle
    double z = 0;       ///< of its middle
    double half_x = 0;  ///< half of its length along x; nothing for a point
    double half_z = 0;  ///< half of its length along z
    bool round = false; ///< a disc of half_x, or a rectangle
    double section = 0; ///< m^2, at the water line where it is largest

    /// How far a place is outside of it, m; nothing within.
    /// \param channel whether only x counts
    double distance(double at_x, double at_z, bool channel) const {
        const double dx = std::abs(at_x - x), dz = channel ? 0.0 : std::abs(at_z - z);
        if (round) return std::max(0.0, std::sqrt(dx * dx + dz * dz) - half_x);
        const double out_x = std::max(0.0, dx - half_x), out_z = std::max(0.0, dz - half_z);
        return std::sqrt(out_x * out_x + out_z * out_z);
    }
};

/// The columns around a body, each with its share; the shares sum to 1. To ask for more than the shares, visit the
/// columns while they are weighed, in one pass.
/// \tparam Wet tells of the number of a column how much it counts: 0 where there is no water, up to 1
template <class Wet> class WaterRing {
public:
    /// Around a footprint whose middle is covered by the grid.
    WaterRing(const ColumnGrid& grid, const Footprint& foot, const Wet& wet)
        : WaterRing(grid, foot, wet, [](std::size_t, std::size_t, std::size_t, double) {}) {}
    /// The same, and `visit(number, i, j, weight)` for each column that counts: its share is its weight over `total()`.
    template <class F>
    WaterRing(const ColumnGrid& grid, const Footprint& foot, const Wet& wet, F&& visit)
        : grid_(grid), foot_(foot), wet_(wet), channel_(grid.columns_z() == 1) {
        const auto i = grid.x().column(foot.x), j = grid.z().column(foot.z);
        cell_ = channel_ ? grid.x().width(i) : std::max(grid.x().width(i), grid.z().width(j));
        const double size = channel_ ? 2 * foot.half_x : std::sqrt(foot.section / std::numbers::pi);
        width_ = std::max(3 * cell_, size);
        const double reach = width_ + cell_;
        auto range = [](const detail::ColumnAxis& axis, double low, double high, std::size_t& begin, std::size_t& end) {
            begin = axis.column(std::max(axis.begin(), low));
            end = axis.column(std::min(axis.end(), high)) + 1;
        };
        range(grid.x(), foot.x - foot.half_x - reach, foot.x + foot.half_x + reach, begin_x_, end_x_);
        range(grid.z(), foot.z - foot.half_z - reach, foot.z + foot.half_z + reach, begin_z_, end_z_);
        weigh(visit);
    }
    /// Whether there is water.
    bool wet() const { return total_ > 0; }
    /// The sum of the weights, m^2.
    double total() const { return total_; }
    /// How much of what the body displaces may rise here, 0 to 1: less than all where there is little water.
    double room() const { return room_; }
    /// By how much the level that is read rises for each cubic metre that is pressed up, 1/m^2.
    double feedback() const { return feedback_; }
    /// The rows of columns along z that have a share, from the first to behind the last.
    std::size_t begin_row() const { return everywhere_ > 0 ? 0 : begin_z_; }
    std::size_t end_row() const { return everywhere_ > 0 ? grid_.columns_z() : end_z_; } ///< behind the last
    /// Calls `f(number of the column, its share)` for each column that counts, in the order of their numbers or,
    /// where all columns of the pool have a share, twice.
    template <class F> void each(F&& f) const {
        each_with_area([&](std::size_t n, double share, double) { f(n, share); });
    }
    /// The same, and the footprint of the column, m^2.
    template <class F> void each_with_area(F&& f) const {
        if (!wet()) return;
        const double by = 1 / total_;
        near([&](std::size_t n, std::size_t, std::size_t, double part, double area) {
            const double weight = part * area * wet_(n);
            if (weight > 0) f(n, weight * by, area);
        });
        if (everywhere_ > 0)
            everywhere([&](std::size_t n, std::size_t, std::size_t, double area, double wet) {
                f(n, everywhere_ * area * wet * by, area);
            });
    }

private:
    template <class F> void weigh(F& visit) {
        double columns = 0, squares = 0, both = 0; // of the ring, wet or not, m^2; and sums for the feedback
        near([&](std::size_t n, std::size_t i, std::size_t j, double part, double area) {
            const double wet = wet_(n), weight = part * area * wet;
            columns += part * area;
            if (!(weight > 0)) return;
            total_ += weight;
            squares += weight * part * wet;
            both += weight * wet;
            visit(n, i, j, weight);
        });
        const double least = 1.5 * foot_.section;
        if (columns < least || columns == 0) {
            const double more = least > 0 ? (least - columns) / grid_.area().value() : 1.0;
            squares += 2 * more * both; // a column with two shares rises by both of them
            everywhere([&](std::size_t n, std::size_t i, std::size_t j, double area, double wet) {
                everywhere_ = more;
                total_ += more * area * wet;
                squares += more * more * area * wet * wet;
                visit(n, i, j, more * area * wet);
            });
        }
        room_ = total_ < least ? total_ / least : 1.0;
        feedback_ = total_ > 0 ? squares / (total_ * total_) : 0.0;
    }
    static double fade(double part) { return std::min(1.0, std::max(0.0, part)); }
    template <class F> void near(F&& f) const {
        const double over = 1 / cell_, outer = width_ + cell_;
        for (std::size_t j = begin_z_; j < end_z_; ++j) {
            const double z = grid_.z().centre(j), dz = grid_.z().width(j);
            for (std::size_t i = begin_x_; i < end_x_; ++i) {
                const double d = foot_.distance(grid_.x().centre(i), z, channel_);
                const double part = fade(d * over) * fade((outer - d) * over);
                if (part > 0) f(grid_.index(i, j), i, j, part, grid_.x().width(i) * dz);
            }
        }
    }
    template <class F> void everywhere(F&& f) const {
        for (std::size_t j = 0, n = 0; j < grid_.columns_z(); ++j)
            for (std::size_t i = 0; i < grid_.columns_x(); ++i, ++n) {
                const double wet = wet_(n);
                if (wet > 0) f(n, i, j, grid_.x().width(i) * grid_.z().width(j), wet);
            }
    }
    const ColumnGrid& grid_;
    const Footprint& foot_;
    const Wet& wet_;
    bool channel_;
    double cell_ = 0, width_ = 0, total_ = 0, everywhere_ = 0, room_ = 0, feedback_ = 0;
    std::size_t begin_x_ = 0, end_x_ = 0, begin_z_ = 0, end_z_ = 0;
};

} // namespace ansatz
