// SPDX-License-Identifier: BSL-1.0
// 7.2.3 Clamp: a pool that is pushed in time with its own swing, without a limit, with damping, with a bed, and between
// two limits

// Somebody rocks a pool at its seiche, 2 L / c. Each push adds to the last, and the swing grows without end. Damping
// ends it where a swing loses what it is given, and pipes where a column falls dry: there is no more to push then. A
// clamp ends it as well; one that cuts heights and does nothing else makes water, or loses it with the crest, and its
// columns stick at the limit: a plateau. (A part of 7.2.)

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "say.hpp"

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
    std::vector<double> swings, crests;           // when each swing began, and its highest column
    double highest = 0, lowest = 1e9, volume = 0; // of the last third; m^3 more than at first
    std::size_t at_limit = 0;                     // columns that were on 1.25 m at the same time, at most
    std::vector<double> plateau;                  // their heights then, m
};

/// Minutes of rocking. `after` may do something to the heights after each step.
//! [driven]
template <class Policy>
Driven rocked(const Policy& policy, int minutes, const std::function<void(std::vector<double>&)>& after = {}) {
    Surface water{policy, pool, 1.0 * metre};
    const double dt = 0.05, period = 2 * 10 / 3.0;
    const auto before = water.volume();
    Driven all;
    for (int n = 0; n < 1200 * minutes; ++n) {
        std::vector<double> heights(water.heights().begin(), water.heights().end());
        const double push = 0.06 * dt * std::cos(2 * std::numbers::pi * n * dt / period);
        for (std::size_t i = 0; i < 5; ++i) { // what is taken from one end is poured in at the other
            const double moved = std::clamp(push, -heights[i], heights[count - 1 - i]); // no more than there is
            heights[i] += moved;
            heights[count - 1 - i] -= moved;
        }
        if (after) after(heights);
        water.set_heights(heights);
        // Waves in pipes are faster the deeper it is.
        const double substeps = std::ceil(dt * second / water.longest_step());
        for (double substep = 0; substep < substeps; ++substep) water.step(dt / substeps * second);
        //! [driven]
        const auto now = water.heights();
        all.times.push_back(n * dt);
        all.west.push_back(now[0]);
        const auto at_limit = std::count_if(now.begin(), now.end(), [](double h) { return std::abs(h - 1.25) < 1e-3; });
        if (std::size_t(at_limit) > all.at_limit) {
            all.at_limit = std::size_t(at_limit);
            all.plateau.assign(now.begin(), now.end());
        }
        const double crest = *std::max_element(now.begin(), now.end());
        const auto swing = std::size_t(n * dt / period);
        if (swing == all.crests.size()) {
            all.swings.push_back(double(swing) * period);
            all.crests.push_back(crest);
        }
        all.crests.back() = std::max(all.crests.back(), crest);
        if (n < 1200 * minutes - 400) continue;
        all.highest = std::max(all.highest, crest);
        all.lowest = std::min(all.lowest, *std::min_element(now.begin(), now.end()));
    }
    all.volume = (water.volume() - before).value();
    return all;
}

void row(workbook::Columns& table, const std::string& name, const Driven& d) {
    table.row(name, workbook::printed(d.lowest < 1e-9 ? 0.0 : d.lowest, " m"), workbook::printed(d.highest, " m"),
              workbook::printed(std::abs(d.volume) < 1e-9 ? 0.0 : d.volume, " m^3"));
}
} // namespace

int main() {
    workbook::Claims claim;
    const auto free = rocked(WaterColumns{speed}, 1); // in a second minute its columns would run below the ground
    const auto damped = rocked(WaterColumns{speed, 0.3 / second}, 4);
    const Pipes over_ground{9.0 * metre_per_second_squared}; // in a depth of 1 m their waves run at 3 m/s, too
    const auto pipes = rocked(over_ground, 4);
    const auto clamped = rocked(ClampedColumns{{speed}, {0.75 * metre, 1.25 * metre}}, 4);
    const auto cut = rocked(WaterColumns{speed}, 1, [](std::vector<double>& heights) {
        for (double& h : heights) h = std::clamp(h, 0.95, 1.25); // heights alone, and no room below
    });
    workbook::Columns table({"in the last 20 s", "the lowest", "the highest", "more water than at first"});
    row(table, "left alone", free);
    row(table, "damped", damped);
    row(table, "Pipes", pipes);
    row(table, "ClampedColumns", clamped);
    row(table, "heights alone", cut);
    std::cout << table;
    claim("pushed in time, a pool swings higher and higher", free.highest > 1.5);
    claim("damping ends it", damped.highest < 1.1);
    claim("pipes end it where the ground falls dry: none runs below it, no water is lost, and 4 min are as 1",
          pipes.lowest >= 0 && std::abs(pipes.volume) < 1e-12 &&
              pipes.highest < 1.1 * *std::max_element(pipes.crests.begin(), pipes.crests.begin() + 9));
    claim("between two limits it stays, and no water is lost",
          clamped.highest <= 1.25 && clamped.lowest >= 0.75 && std::abs(clamped.volume) < 1e-12);
    claim("a clamp of the heights alone makes water", cut.volume > 0.1);
    claim("and a plateau at the limit", cut.at_limit >= 2 * clamped.at_limit);
    workbook::say() << "Columns on the upper limit at the same time: " << cut.at_limit
                    << " where heights alone are clamped, " << clamped.at_limit << " in ClampedColumns\n";

    workbook::Plot plot("7.2.3", "The western column of a pool that is pushed once in each swing");
    plot.x("time in seconds").y("height in metres");
    plot.line("left alone", free.times, free.west)
        .line("damped", damped.times, damped.west)
        .line("clamped", clamped.times, clamped.west)
        .write();
    workbook::Plot swings("7.2.3-swings", "The highest column of each swing");
    swings.x("time in seconds").y("height in metres");
    swings.line("left alone", free.swings, free.crests)
        .line("damped", damped.swings, damped.crests)
        .line("Pipes", pipes.swings, pipes.crests)
        .line("ClampedColumns", clamped.swings, clamped.crests)
        .write();
    workbook::Plot profile("7.2.3-plateau", "The pool when most of its columns stand on the limit");
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(pool.centre_x(i).value());
    profile.x("x in metres").y("height in metres");
    profile.line("heights alone clamped", places, cut.plateau).line("ClampedColumns", places, clamped.plateau).write();
    return claim.result();
}
