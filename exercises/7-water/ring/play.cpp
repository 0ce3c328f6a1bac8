// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.4.2 with your ring in it: a box is let down into a channel, centimetre by centimetre, and the
// water rises around it.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/ring.hpp>
#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

const std::size_t count = 40;
const double width = 0.25, half = 0.75; // m
const auto section = 2 * half * 1.0 * square_metre;

int main() {
    workbook::Play table("A box 1.5 m long is held 0.6 m deep in a channel of 10 m and 2 m of water.",
                         {"displaced, m^3", "level around it, m", "volume of all, m^3"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.ring", "What a box displaces rises around it: yours and the library's");
    plot.x("x", "m").y("height", "m");
    const ColumnGrid grid(count, 1, width * metre, 1.0 * metre);
    const Footprint foot{.x = 5, .z = 0.5, .half_x = half, .half_z = 0.5, .section = section.value()};
    const auto wet = [](std::size_t) { return 1.0; };
    const WaterRing ring(grid, foot, wet);
    const auto bottom = 1.4 * metre;
    std::vector<double> x;
    for (std::size_t n = 0; n < count; ++n) x.push_back(grid.centre_x(n).value());
    auto show = [&](const char* who, double volume, const std::vector<double>& heights, double level, auto&& once) {
        double all = 0;
        for (const double h : heights) all += h * width;
        plot.line(who, x, heights);
        table.row(who, {volume, level, all}, int(count), once);
    };

    exercise::Columns columns(count, {2.0 * metre, width * square_metre, 0.0});
    // The library's ring says which columns they are: share over footprint, the largest being 1.
    double most = 0;
    ring.each([&](std::size_t, double share) { most = std::max(most, share); });
    ring.each([&](std::size_t n, double share) { columns[n].part = share / most; });
    const auto before = columns;
    const auto volume = exercise::displaced(columns, section, bottom);
    exercise::press_up(columns, volume);
    std::vector<double> yours;
    for (const auto& c : columns) yours.push_back(c.height.value());
    show("yours", volume.value(), yours, exercise::level(columns).value(), [&] {
        static volatile double sink = 0;
        sink = exercise::displaced(before, section, bottom).value();
    });

    std::vector<double> library(count, 2.0);
    const double pressed = section.value() * (2.0 - bottom.value()) / (1 - section.value() * ring.feedback());
    double level = 0;
    ring.each_with_area([&](std::size_t n, double share, double area) { library[n] += share * pressed / area; });
    ring.each([&](std::size_t n, double share) { level += share * library[n]; });
    show("library", pressed, library, level, [&] {
        static volatile double sink = 0;
        sink = WaterRing(grid, foot, wet).feedback();
    });
    plot.write();
    return table.print();
}
