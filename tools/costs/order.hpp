// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The order of convergence that a ladder of steps shows, and where it shows none.
///
/// Between two neighbours of the ladder the error changes as a power of the step; that power is the
/// slope there. At large steps the slopes still drift, at small ones rounding flattens them, and a
/// diverged run has none. An order is believed only where three neighbouring slopes ("halvings")
/// agree within 0.1; the finest such place counts, because an order is a statement about small steps.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "row.hpp"

namespace ansatz::workbook {

/// How far neighbouring slopes may differ, and how far a fitted order may be off the known one.
inline constexpr double order_tolerance = 0.1;

/// An order, and the points (indices into the given ladder, first to last) that show it.
struct OrderFit {
    double order;
    std::size_t first, last;
};

/// One point of a ladder. A diverged run, a missing error and an error of exactly zero have no logarithm.
struct Rung {
    double step;
    Number error;
};

/// Fits the order of a ladder that is sorted from the coarsest step to the finest.
/// Nothing comes back where no three slopes in a row agree, and where they agree on "the error does
/// not fall" (a floor of rounding, a scheme that converges to something else): zero is no order.
inline std::optional<OrderFit> fit_order(const std::vector<Rung>& ladder) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> slopes; // slopes[i] lies between the rungs i and i + 1
    for (std::size_t i = 0; i + 1 < ladder.size(); ++i) {
        const Rung &coarse = ladder[i], &fine = ladder[i + 1];
        const bool usable = coarse.error && fine.error && *coarse.error > 0 && *fine.error > 0 &&
                            coarse.step > fine.step && fine.step > 0;
        slopes.push_back(usable ? std::log(*coarse.error / *fine.error) / std::log(coarse.step / fine.step) : none);
    }

    // Do the slopes [begin, end) agree? A NaN among them agrees with nothing.
    const auto agree = [&](std::size_t begin, std::size_t end) {
        double low = slopes[begin], high = slopes[begin];
        for (std::size_t i = begin; i < end; ++i) {
            if (std::isnan(slopes[i])) return false;
            low = std::min(low, slopes[i]);
            high = std::max(high, slopes[i]);
        }
        return high - low <= order_tolerance;
    };

    for (std::size_t end = slopes.size(); end >= 3; --end) {
        std::size_t begin = end - 3;
        if (!agree(begin, end)) continue;
        while (begin > 0 && agree(begin - 1, end)) --begin;
        // Least squares of log error over log step, through all points whose slopes agree.
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (std::size_t i = begin; i <= end; ++i) {
            const double x = std::log(ladder[i].step), y = std::log(*ladder[i].error);
            n += 1;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
        const double order = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        if (order < 0.25) continue; // flat: look further up, before the floor
        return OrderFit{order, begin, end};
    }
    return std::nullopt;
}

/// Fits every curve (one axis, choice and problem) and writes its order into the rows that show it.
inline void fit_orders(Rows& rows, const std::string& axis) {
    std::vector<bool> done(rows.size(), false);
    for (std::size_t first = 0; first < rows.size(); ++first) {
        if (done[first] || rows[first].axis != axis) continue;
        std::vector<std::size_t> curve;
        for (std::size_t i = first; i < rows.size(); ++i) {
            const bool same = rows[i].axis == axis && rows[i].choice == rows[first].choice &&
                              rows[i].problem == rows[first].problem &&
                              rows[i].parameter.name == rows[first].parameter.name;
            if (!same) continue;
            done[i] = true;
            if (rows[i].parameter.value) curve.push_back(i);
        }
        std::stable_sort(curve.begin(), curve.end(),
                         [&](auto a, auto b) { return *rows[a].parameter.value > *rows[b].parameter.value; });
        std::vector<Rung> ladder;
        for (std::size_t i : curve)
            ladder.push_back({*rows[i].parameter.value, rows[i].diverged ? Number{} : rows[i].error});
        if (const auto fit = fit_order(ladder))
            for (std::size_t i = fit->first; i <= fit->last; ++i) rows[curve[i]].order = fit->order;
    }
}

/// Is a fitted order further off the known one than the fit can be?
inline bool order_is_off(const Row& row) {
    return row.order && row.known_order && std::abs(*row.order - *row.known_order) > order_tolerance;
}

} // namespace ansatz::workbook
