// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Cases of Saint-Venant's equations with a closed form, as SWASHES has them, for both orders of the scheme: dams that
/// break, a lake that rocks, a simple wave before its shock.

#include "tests/water/support.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace water_tests {

inline constexpr double g = 9.81;

/// Steps with steps as long as are taken, and holds heights above zero.
template <class Surface_> void run(Surface_& water, double until) {
    for (double t = 0; t < until;) {
        const double dt = std::min(water.longest_step().value(), until - t);
        water.step(dt * second);
        t += dt;
        for (const auto& h : water.heights()) REQUIRE(h >= 0);
    }
}
/// The error of heights against a closed form of x: the mean of what is off over the mean of what is there.
template <class Surface_, class F> double off(const Surface_& water, F&& exact) {
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < water.grid().columns_x(); ++i) {
        const double h = exact(water.grid().centre_x(i).value());
        wrong += std::abs(water.height(i, 0).value() - h);
        all += h;
    }
    return wrong / all;
}
inline ColumnGrid channel(std::size_t count, double length) {
    return ColumnGrid(count, 1, length / double(count) * metre, 1.0 * metre);
}

/// The hump of SWASHES, 4 m long and 0.2 m high, in a channel of 25 m.
inline std::vector<double> hump(const ColumnGrid& channel) {
    std::vector<double> bed;
    for (std::size_t i = 0; i < channel.columns_x(); ++i) {
        const double x = channel.centre_x(i).value() - 10;
        bed.push_back(std::abs(x) < 2 ? 0.2 - 0.05 * x * x : 0.0);
    }
    return bed;
}

/// The dam of SWASHES, at 5 m of 10 m, 5 mm high, after 6 s: Ritter's over dry ground, Stoker's over wet.
struct Dam {
    double low, high = 0.005, c = std::sqrt(g * high);
    double middle = 0, u = 2 * c, shock = 2 * c; // behind the front, which has this speed
    explicit Dam(double low_) : low(low_) {
        if (!(low > 0)) return;
        double below = low, above = high; // of the middle: what the rarefaction gives and what the shock takes
        for (int n = 0; n < 100; ++n) {
            const double h = 0.5 * (below + above);
            const double left = 2 * (c - std::sqrt(g * h)),
                         right = (h - low) * std::sqrt(g * (h + low) / (2 * h * low));
            (left > right ? below : above) = h;
        }
        middle = 0.5 * (below + above);
        u = 2 * (c - std::sqrt(g * middle));
        shock = middle * u / (middle - low);
    }
    double operator()(double x) const {
        const double xi = (x - 5) / 6;
        if (xi <= -c) return high;
        if (xi <= u - std::sqrt(g * middle)) return 4 / (9 * g) * (c - xi / 2) * (c - xi / 2);
        return xi <= shock ? middle : low;
    }
    template <class Policy> Surface<Policy> broken(const Policy& policy, std::size_t count) const {
        Surface water(policy, channel(count, 10), 0.0 * metre);
        set_heights(water, [&](double x, double) { return x < 5 ? high : low; });
        run(water, 6);
        return water;
    }
};

/// Thacker's lake in a parabola, 4 m long.
struct Lake {
    double a = 1, h0 = 0.5, omega = std::sqrt(2 * g * h0) / a, period = 2 * pi / omega;
    double operator()(double x, double t) const {
        const double part = (x - 2) / a + 1 / (2 * a) * std::cos(omega * t);
        return std::max(0.0, -h0 * (part * part - 1));
    }
    template <class Policy> Surface<Policy> at_rest(const Policy& policy, std::size_t count) const {
        const auto grid = channel(count, 4);
        std::vector<double> bed;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = grid.centre_x(i).value() - 2;
            bed.push_back(h0 * (x * x / (a * a) - 1));
        }
        Surface water(policy, grid, std::span<const double>(bed), 0.0 * metre);
        set_heights(water, [&](double x, double) { return (*this)(x, 0); });
        return water;
    }
};

/// A hump of 10 cm on 1 m of water in 20 m of channel that all runs to larger x, and has no shock in its first second:
/// u = 2 (c - c0), and each c goes on with u + c.
struct SimpleWave {
    double c0 = std::sqrt(g);
    static double first_c(double x) { return std::sqrt(g * (1 + 0.1 * std::exp(-(x - 6) * (x - 6)))); }
    double operator()(double x, double t) const {
        double low = x - 20, high = x; // of where the c that is at x now was at first
        for (int n = 0; n < 60; ++n) {
            const double from = 0.5 * (low + high);
            (from + (3 * first_c(from) - 2 * c0) * t < x ? low : high) = from;
        }
        return first_c(low) * first_c(low) / g;
    }
    /// The wave as it is at first, and then a second later.
    template <class Policy> double error(const Policy& policy, std::size_t count) const {
        const auto grid = channel(count, 20);
        auto state = Surface(policy, grid, 0.0 * metre).state();
        for (std::size_t i = 0; i < count; ++i) {
            const double c = first_c(grid.centre_x(i).value());
            state.height[i] = c * c / g;
            state.momentum_x[i] = c * c / g * 2 * (c - c0);
        }
        Surface water(policy, grid, 0.0 * metre, state);
        run(water, 1);
        return off(water, [&](double x) { return (*this)(x, 1); });
    }
};

} // namespace water_tests
