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
    double x = 0, z = 0;           ///< its middle
    double half_x = 0, half_z = 0; ///< half of its lengths; nothing for a point
    bool round = false;            ///< a disc of half_x, or a rectangle
    double section = 0;            ///< m^2, at the water line where it is largest

    /// How far a place is outside of it, m; nothing within.
    /// \param channel whether only x counts
    double distance(double at_x, double at_z, bool channel) const {
        const double dx = std::abs(at_x - x), dz = channel ? 0.0 : std::abs(at_z - z);
        if (round) return std::max(0.0, std::hypot(dx, dz) - half_x);
        return std::hypot(std::max(0.0, dx - half_x), std::max(0.0, dz - half_z));
    }
};

/// The columns around a body, each with its share; the shares sum to 1.
/// \tparam Wet tells of the number of a column how much it counts: 0 where there is no water, up to 1
template <class Wet> class WaterRing {
public:
    /// Around a footprint whose middle is covered by the grid.
    WaterRing(const ColumnGrid& grid, const Footprint& foot, const Wet& wet)
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
        double columns = 0; // m^2 of the ring, wet or not
        near([&](std::size_t n, double area) {
            columns += area;
            total_ += area * wet_(n);
        });
        const double least = 1.5 * foot.section;
        if (columns < least || columns == 0) {
            double all = 0; // m^2 of water
            everywhere([&](std::size_t, double area) { all += area; });
            if (all > 0) everywhere_ = least > 0 ? (least - columns) / grid.area().value() : 1.0;
            total_ += everywhere_ * all;
        }
        room_ = total_ < least ? total_ / least : 1.0;
    }
    /// Whether there is water.
    bool wet() const { return total_ > 0; }
    /// How much of what the body displaces may rise here, 0 to 1: less than all where there is little water.
    double room() const { return room_; }
    /// Calls `f(number of the column, its share)` for each column that counts, in the order of their numbers or,
    /// where all columns of the pool have a part, twice.
    template <class F> void each(F&& f) const {
        if (!wet()) return;
        near([&](std::size_t n, double area) {
            const double weight = area * wet_(n);
            if (weight > 0) f(n, weight / total_);
        });
        if (everywhere_ > 0) everywhere([&](std::size_t n, double area) { f(n, everywhere_ * area / total_); });
    }
    /// By how much the level that is read rises for each cubic metre that is pressed up, 1/m^2.
    double feedback() const {
        // A column with two parts rises by both of them.
        double sum = 0;
        if (!wet()) return 0;
        near([&](std::size_t n, double part) {
            const double area = area_of(n), other = everywhere_ * area * wet_(n);
            sum += (square(part * wet_(n) + other) - square(other)) / square(total_) / area;
        });
        if (everywhere_ > 0)
            everywhere([&](std::size_t n, double area) { sum += square(everywhere_ * area / total_) / area_of(n); });
        return sum;
    }

private:
    static double square(double x) { return x * x; }
    double area_of(std::size_t n) const {
        return grid_.x().width(n % grid_.columns_x()) * grid_.z().width(n / grid_.columns_x());
    }
    static double fade(double part) { return std::min(1.0, std::max(0.0, part)); }
    template <class F> void near(F&& f) const {
        for (std::size_t j = begin_z_; j < end_z_; ++j)
            for (std::size_t i = begin_x_; i < end_x_; ++i) {
                const double d = foot_.distance(grid_.x().centre(i), grid_.z().centre(j), channel_);
                const double part = fade(d / cell_) * fade((width_ + cell_ - d) / cell_);
                if (!(part > 0)) continue;
                const std::size_t n = grid_.index(i, j);
                f(n, part * grid_.x().width(i) * grid_.z().width(j));
            }
    }
    template <class F> void everywhere(F&& f) const {
        for (std::size_t j = 0, n = 0; j < grid_.columns_z(); ++j)
            for (std::size_t i = 0; i < grid_.columns_x(); ++i, ++n) {
                const double area = grid_.x().width(i) * grid_.z().width(j) * wet_(n);
                if (area > 0) f(n, area);
            }
    }
    const ColumnGrid& grid_;
    const Footprint& foot_;
    const Wet& wet_;
    bool channel_;
    double cell_ = 0, width_ = 0, total_ = 0, everywhere_ = 0, room_ = 0;
    std::size_t begin_x_ = 0, end_x_ = 0, begin_z_ = 0, end_z_ = 0;
};

} // namespace ansatz
