// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.2.4 with your flows in it: a wave runs up a beach, and back.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/pipes.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

using namespace ansatz;

const std::size_t count = 120;
const double width = 0.25; // m
const auto dt = 0.02 * second;
const auto g = 9.81 * metre_per_second_squared;
const auto damping = 0.1 / second;
const int steps = 400;

/// A bed that rises from the middle of the channel on, and still water of a metre with a wave of 0.4 m in the west.
double bed(std::size_t n) { return std::max(0.0, 0.1 * (double(n) * width - 15)); }
double height(std::size_t n) {
    const double x = double(n) * width, wave = 0.4 * std::exp(-(x - 5) * (x - 5) / 2);
    return std::max(0.0, 1 - bed(n)) + (bed(n) < 1 ? wave : 0);
}

int main() {
    workbook::Play table("A wave of 40 cm runs up a beach of 1 in 10. In 8 s, and then:",
                         {"highest dry ground reached, m", "lowest height, m", "volume, m^3"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.pipes", "A wave of 40 cm on a beach, 8 s later: yours and the library's");
    plot.x("x", "m").y("level", "m");
    std::vector<double> x, ground;
    for (std::size_t n = 0; n < count; ++n) {
        x.push_back((double(n) + 0.5) * width);
        ground.push_back(bed(n));
    }
    plot.line("bed", x, ground);
    auto show = [&](const char* who, auto&& heights, auto&& step) {
        double reached = 0, lowest = 1;
        std::vector<double> now;
        for (int k = 0; k < steps; ++k) {
            step();
            now = heights();
            for (std::size_t n = 0; n < count; ++n) {
                if (now[n] > 1e-3) reached = std::max(reached, bed(n));
                lowest = std::min(lowest, now[n]);
            }
        }
        double volume = 0;
        std::vector<double> level;
        for (std::size_t n = 0; n < count; ++n) {
            volume += now[n] * width;
            level.push_back(bed(n) + now[n]);
        }
        plot.line(who, x, level);
        table.row(who, {reached, lowest, volume}, int(count), step);
    };

    exercise::Channel channel{{}, std::vector<Quantity<unit::VolumeFlow>>(count - 1), 1.0 * metre};
    for (std::size_t n = 0; n < count; ++n)
        channel.columns.push_back({bed(n) * metre, height(n) * metre, width * metre});
    show(
        "yours",
        [&] {
            std::vector<double> all;
            for (const auto& c : channel.columns) all.push_back(c.height.value());
            return all;
        },
        [&] { exercise::step(channel, g, damping, dt); });

    Pipes::State<double> state;
    for (std::size_t n = 0; n < count; ++n) {
        state.height.push_back(height(n));
        state.bed.push_back(bed(n));
    }
    state.flow_x.assign(count, 0.0);
    state.flow_z.assign(count, 0.0);
    Pipes::In<double> loop(Pipes{g, damping}, ColumnGrid(count, 1, width * metre, 1.0 * metre), 1.0 * metre);
    show(
        "library", [&] { return state.height; }, [&] { loop.advance(state, dt); });
    plot.write();
    return table.print();
}
