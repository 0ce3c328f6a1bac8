// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.2.2 with your walls in it: a hump divides, and each half meets a wall.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/water_columns.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <span>
#include <vector>

using namespace ansatz;

const std::size_t count = 400;
const auto width = 0.05 * metre, level = 1.0 * metre;
const auto c = 1.0 * metre_per_second;
const auto dt = 0.04 * second;

std::vector<double> hump() {
    std::vector<double> all;
    for (std::size_t n = 0; n < count; ++n) {
        const double x = 0.05 * (double(n) + 0.5) - 10;
        all.push_back(1 + 0.1 * std::exp(-x * x));
    }
    return all;
}

int main() {
    workbook::Play table("A hump of 10 cm in 20 m of water: held in the west, open in the east. After 15 s:",
                         {"5 m from the west, m", "5 m from the east, m", "volume, m^2"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.walls", "Half a hump at a wall that holds, half at one that is open");
    plot.x("x", "m").y("height", "m");
    std::vector<double> x;
    for (std::size_t n = 0; n < count; ++n) x.push_back(0.05 * (double(n) + 0.5));
    auto show = [&](const char* who, auto&& heights, auto&& step) {
        for (int n = 0; n < 375; ++n) step();
        const std::vector<double> now = heights();
        double volume = 0;
        for (const double h : now) volume += 0.05 * h;
        plot.line(who, x, now);
        table.row(who, {now[100], now[300], volume}, int(count), step);
    };

    exercise::Channel channel{{}, {}, width, c, level, exercise::End::held, exercise::End::open};
    for (const double h : hump()) {
        channel.heights.push_back(h * metre);
        channel.rates.push_back(0.0 * metre_per_second);
    }
    show(
        "yours",
        [&] {
            std::vector<double> all;
            for (const auto& h : channel.heights) all.push_back(h.value());
            return all;
        },
        [&] { exercise::step(channel, dt); });

    const WaterColumns::In<double> loop({.wave_speed = c, .walls = {Wall::holds, Wall::absorbs}},
                                        ColumnGrid(count, 1, width, 1.0 * metre), level);
    std::vector<double> heights = hump(), rates(count, 0.0);
    show(
        "library", [&] { return heights; }, [&] { loop.advance(std::span(heights), std::span(rates), dt); });
    plot.write();
    return table.print();
}
