// SPDX-License-Identifier: BSL-1.0
// 7.2.3 Clamp: a pool that is pushed in time with its own swing, without a limit, with damping, and between two limits

// Somebody rocks a pool at its seiche, 2 L / c. Each push adds to the last, and the swing grows without end. Damping
// ends it where a swing loses what it is given. A clamp ends it as well; one that cuts heights and does nothing else
// takes the water away with the crest, and its columns stick. (A part of 7.2.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

using namespace ansatz;

namespace {
constexpr std::size_t count = 50;
const ColumnGrid pool(count, 1, 0.2 * metre, 1.0 * metre); // 10 m
const auto speed = 3.0 * metre_per_second;

struct Driven {
    std::vector<double> times, west;
    double highest = 0, lowest = 1e9, volume = 0; // of the last third; m^3 more than at first
    std::size_t at_limit = 0;                     // columns that were on 1.25 m at the same time, at most
};

/// A minute of rocking. `after` may do something to the heights after each step.
//! [driven]
template <class Policy>
Driven rocked(const Policy& policy, const std::function<void(std::vector<double>&)>& after = {}) {
    Surface water{policy, pool, 1.0 * metre};
    const double dt = 0.05, period = 2 * 10 / 3.0;
    const auto before = water.volume();
    Driven all;
    for (int n = 0; n < 1200; ++n) {
        std::vector<double> heights(water.heights().begin(), water.heights().end());
        const double push = 0.06 * dt * std::cos(2 * std::numbers::pi * n * dt / period);
        for (std::size_t i = 0; i < 5; ++i) { // what is taken from one end is poured in at the other
            heights[i] += push;
            heights[count - 1 - i] -= push;
        }
        if (after) after(heights);
        water.set_heights(heights);
        water.step(dt * second);
        //! [driven]
        const auto now = water.heights();
        all.times.push_back(n * dt);
        all.west.push_back(now[0]);
        const auto at_limit = std::count_if(now.begin(), now.end(), [](double h) { return std::abs(h - 1.25) < 1e-3; });
        all.at_limit = std::max(all.at_limit, std::size_t(at_limit));
        if (n < 800) continue;
        all.highest = std::max(all.highest, *std::max_element(now.begin(), now.end()));
        all.lowest = std::min(all.lowest, *std::min_element(now.begin(), now.end()));
    }
    all.volume = (water.volume() - before).value();
    return all;
}

void print(const std::string& name, const Driven& d) {
    std::cout << name << ": in the last 20 s from " << d.lowest << " m to " << d.highest << " m, "
              << (std::abs(d.volume) < 1e-9 ? 0.0 : d.volume) << " m^3 more than at first\n";
}
} // namespace

int main() {
    workbook::Claims claim;
    const auto free = rocked(WaterColumns{speed});
    const auto damped = rocked(WaterColumns{speed, 0.3 / second});
    const auto clamped = rocked(ClampedColumns{{speed}, {0.75 * metre, 1.25 * metre}});
    const auto cut = rocked(WaterColumns{speed}, [](std::vector<double>& heights) {
        for (double& h : heights) h = std::clamp(h, 0.95, 1.25); // heights alone, and no room below
    });
    print("left alone    ", free);
    print("damped        ", damped);
    print("ClampedColumns", clamped);
    print("heights alone ", cut);
    claim("pushed in time, a pool swings higher and higher", free.highest > 1.5);
    claim("damping ends it", damped.highest < 1.1);
    claim("between two limits it stays, and no water is lost",
          clamped.highest <= 1.25 && clamped.lowest >= 0.75 && std::abs(clamped.volume) < 1e-12);
    claim("a clamp of the heights alone makes water", cut.volume > 0.1);
    std::cout << "Columns on the upper limit at the same time: " << cut.at_limit << " where heights alone are clamped, "
              << clamped.at_limit << " in ClampedColumns\n";

    workbook::Plot plot("7.2.3", "The western column of a pool that is pushed once in each swing");
    plot.x("time in seconds").y("height in metres");
    plot.line("left alone", free.times, free.west)
        .line("damped", damped.times, damped.west)
        .line("clamped", clamped.times, clamped.west)
        .write();
    return claim.result();
}
