// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sheet of `peers soft_bodies`: n x n bodies, springs of two or three kinds, hung by two corners. Everybody plays
/// the same, and has its springs in the same order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace peers {

/// A sheet of 1 m x 1 m that lies flat at y = 0.
struct Sheet {
    static constexpr double mass_per_area = 0.15, gravity = 9.81, dt = 1.0 / 60; // kg/m^2, m/s^2, s

    /// Two bodies, and their distance.
    struct Link {
        std::uint32_t a, b;
        double rest; // m
    };
    int side;
    double stiffness, damping;                 // N/m, N s/m, of each spring
    std::vector<std::array<double, 3>> places; // m
    std::vector<double> masses;                // kg; 0 of the two that hold it
    std::vector<Link> links;

    /// With springs along its threads and across its cells, and those from a body to the next but one, if it bends.
    static Sheet of(int n, bool bends, double stiffness, double damping) {
        Sheet sheet{n, stiffness, damping, {}, {}, {}};
        const double apart = 1.0 / (n - 1);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double part = (i % (n - 1) ? 1.0 : 0.5) * (j % (n - 1) ? 1.0 : 0.5); // of a cell
                sheet.places.push_back({apart * i, 0, apart * j});
                sheet.masses.push_back(j == 0 && i % (n - 1) == 0 ? 0 : mass_per_area * apart * apart * part);
            }
        const auto lines = [&](int step) {
            for (int j = 0; j < n; ++j)
                for (int i = 0; i + step < n; ++i) sheet.link(j * n + i, j * n + i + step);
            for (int j = 0; j + step < n; ++j)
                for (int i = 0; i < n; ++i) sheet.link(j * n + i, (j + step) * n + i);
        };
        lines(1);
        for (int j = 0; j + 1 < n; ++j)
            for (int i = 0; i + 1 < n; ++i) {
                sheet.link(j * n + i, (j + 1) * n + i + 1);
                sheet.link(j * n + i + 1, (j + 1) * n + i);
            }
        if (bends) lines(2);
        return sheet;
    }
    std::size_t size() const { return places.size(); }

private:
    void link(int a, int b) {
        const auto &x = places[std::size_t(a)], &y = places[std::size_t(b)];
        links.push_back({std::uint32_t(a), std::uint32_t(b), std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2])});
    }
};

/// Somebody who plays it.
struct SheetOf {
    virtual ~SheetOf() = default;
    virtual void step() = 0;                                   ///< by Sheet::dt
    virtual std::array<double, 3> at(std::size_t i) const = 0; ///< where a body is, m
};

/// How far the springs are stretched, by the places alone: one measure for everybody.
struct Stretch {
    double largest = 0; ///< part of a spring's length
    double mean = 0;    ///< of all springs, those that are pressed counted as zero

    static Stretch of(const Sheet& sheet, const SheetOf& played) {
        Stretch stretch;
        for (const auto& l : sheet.links) {
            const auto x = played.at(l.a), y = played.at(l.b);
            const double strain = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]) / l.rest - 1;
            stretch.largest = std::max(stretch.largest, strain);
            stretch.mean += std::max(0.0, strain) / double(sheet.links.size());
        }
        return stretch;
    }
};

/// Bullet's soft body, where it was found.
/// \param passes over its links in a step
std::unique_ptr<SheetOf> bullet_sheet(const Sheet&, int passes);

} // namespace peers
