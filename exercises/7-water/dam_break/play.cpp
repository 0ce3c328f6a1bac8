// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.2.5 with your faces in it: a dam breaks over dry ground.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/shallow_water.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;

const std::size_t count = 200;
const double width = 0.1, g = 9.81; // m, m/s^2
const int steps = 160;
const auto dt = 1.0 / steps * second;

/// Ritter (1892): a second after a dam of a metre broke at 10 m.
double ritter(double x) {
    const double c = std::sqrt(g), part = std::clamp((2 * c - (x - 10)) / (3 * c), 0.0, 1.0);
    return part * part;
}

int main() {
    workbook::Play table("A dam of a metre breaks over dry ground, in 200 columns. A second later:",
                         {"off the closed form, %", "lowest height, m", "volume, m^2"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.dam_break", "A dam of a metre, a second after it broke: yours and the library's");
    plot.x("x", "m").y("height", "m");
    std::vector<double> x, exact;
    for (std::size_t n = 0; n < count; ++n) {
        x.push_back((double(n) + 0.5) * width);
        exact.push_back(ritter(x.back()));
    }
    plot.line("Ritter's closed form", x, exact);
    auto show = [&](const char* who, auto&& heights, auto&& step) {
        for (int k = 0; k < steps; ++k) step();
        const std::vector<double> now = heights();
        double off = 0, volume = 0;
        for (std::size_t n = 0; n < count; ++n) {
            off += std::abs(now[n] - exact[n]) * width;
            volume += now[n] * width;
        }
        plot.line(who, x, now);
        table.row(who, {10 * off, *std::min_element(now.begin(), now.end()), volume}, int(count), step);
    };

    exercise::Channel channel{{}, width * metre};
    ShallowWater::State<double> state;
    for (std::size_t n = 0; n < count; ++n) {
        const double height = n < count / 2 ? 1 : 0;
        channel.columns.push_back({0.0 * metre, height * metre, exercise::Flow()});
        state.height.push_back(height);
    }
    const auto gravity = g * metre_per_second_squared;
    show(
        "yours",
        [&] {
            std::vector<double> all;
            for (const auto& c : channel.columns) all.push_back(c.height.value());
            return all;
        },
        [&] { exercise::step(channel, gravity, dt); });

    ShallowWater::In<double> loop(ShallowWater{gravity}, ColumnGrid(count, 1, width * metre, 1.0 * metre), 0.0 * metre);
    loop.prepare(state, 0.0 * metre);
    show(
        "library", [&] { return state.height; }, [&] { loop.advance(state, dt); });
    plot.write();
    return table.print();
}
