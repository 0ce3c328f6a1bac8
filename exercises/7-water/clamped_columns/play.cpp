// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.2.3 with your clamp in it: a channel is pushed in time with its swing, and its heights are
// kept between half a metre and one and a half.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/clamped_columns.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <span>

using namespace ansatz;

const std::size_t count = 40;
const auto width = 0.25 * metre, low = 0.5 * metre, high = 1.5 * metre;
const auto dt = 0.05 * second;
const int steps = 1200;

/// The western column, and in the end the volume and what was cut off for good: the same loop, another clamp.
template <class Clamping> std::vector<double> run(std::vector<double>& west, Clamping&& clamp) {
    const ColumnGrid grid(count, 1, width, 1.0 * metre);
    const WaterColumns::In<double> loop(WaterColumns{2.0 * metre_per_second}, grid, 1.0 * metre);
    std::vector<double> heights(count, 1.0), rates(count, 0.0);
    double gone = 0;
    for (int n = 0; n < steps; ++n) {
        loop.advance(heights, rates, dt);
        // The seiche of 10 m at 2 m/s takes 10 s; a push at the western end, taken back at the eastern.
        const double push = 0.03 * std::sin(2 * std::acos(-1.0) * n * dt.value() / 10);
        heights.front() += push, heights.back() -= push;
        gone += clamp(grid, heights);
        west.push_back(heights.front());
    }
    return {*std::max_element(west.begin(), west.end()), grid.volume(std::span<const double>(heights)).value(), gone};
}

int main() {
    workbook::Play table("A channel of 10 m^3 is pushed at its seiche for a minute, between 0.5 m and 1.5 m.",
                         {"highest in the west, m", "volume, m^3", "gone, m^3"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.clamped_columns", "The western column of a pool that is pushed at its seiche");
    plot.x("time", "s").y("height", "m");
    std::vector<double> times;
    for (int n = 0; n < steps; ++n) times.push_back((n + 1) * dt.value());
    auto yours = [](const ColumnGrid&, std::vector<double>& heights) {
        exercise::Columns columns;
        for (const double h : heights) columns.push_back({h * metre, 0.25 * square_metre});
        const double gone = exercise::clamp(columns, low, high).value();
        for (std::size_t n = 0; n < heights.size(); ++n) heights[n] = columns[n].height.value();
        return gone;
    };
    std::vector<double> unused(count, 0.0);
    auto library = [&](const ColumnGrid& grid, std::vector<double>& heights) {
        return clamp_columns(Clamp{low, high}, grid, std::span<double>(heights), std::span<double>(unused)).value();
    };
    auto show = [&](const char* who, auto&& clamp) {
        std::vector<double> west, heights(count, 1.0);
        const auto numbers = run(west, clamp);
        plot.line(who, times, west);
        heights[3] = 2;
        const ColumnGrid grid(count, 1, width, 1.0 * metre);
        table.row(who, numbers, int(count), [=]() mutable {
            auto now = heights;
            clamp(grid, now);
        });
    };
    show("yours", yours);
    show("library", library);
    plot.write();
    return table.print();
}
