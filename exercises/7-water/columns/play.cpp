// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.2 with your column in it: a drop into the middle of a pool, as seen along its middle.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

const std::size_t count = 41;
const auto width = 0.1 * metre;
const auto c = 2.0 * metre_per_second;
const auto dt = 0.02 * second;

std::vector<double> drop() {
    std::vector<double> heights;
    for (std::size_t j = 0; j < count; ++j)
        for (std::size_t i = 0; i < count; ++i) {
            const double x = 0.1 * (double(i) - 20), z = 0.1 * (double(j) - 20);
            heights.push_back(1 + 0.1 * std::exp(-(x * x + z * z) / 0.09));
        }
    return heights;
}
/// 40 steps of the inner columns by your rule; those at the walls stay, and no wave gets there.
std::vector<double> yours() {
    auto heights = drop();
    std::vector<double> rates(heights.size(), 0.0);
    for (int n = 0; n < 40; ++n) {
        for (std::size_t j = 1; j + 1 < count; ++j)
            for (std::size_t i = 1; i + 1 < count; ++i) {
                const std::size_t k = j * count + i;
                const exercise::Neighbours around{heights[k - 1] * metre, heights[k + 1] * metre,
                                                  heights[k - count] * metre, heights[k + count] * metre};
                rates[k] =
                    exercise::next_rate(rates[k] * metre_per_second, heights[k] * metre, around, c, width, dt).value();
            }
        for (std::size_t k = 0; k < heights.size(); ++k) heights[k] += dt.value() * rates[k];
    }
    return heights;
}
std::vector<double> library() {
    Surface pool{WaterColumns{c}, ColumnGrid(count, count, width), 1.0 * metre};
    pool.set_heights(drop());
    for (int n = 0; n < 40; ++n) pool.step(dt);
    return {pool.heights().begin(), pool.heights().end()};
}

int main() {
    workbook::Play table("A drop fell into the middle of a pool. After 0.8 s at 2 m/s its ring is 1.6 m wide.",
                         {"in the middle, m", "on the ring, m", "a column of 3 m on 1 m by 2 m, m^3"});
    table.timed("ns a call");
    workbook::Plot plot("play-water.columns", "A drop in a pool: yours and the library's");
    plot.x("x", "m").y("height", "m");
    auto show = [&](const char* who, const std::vector<double>& heights, double holds, auto&& thousand) {
        std::vector<double> x, y;
        for (std::size_t i = 0; i < count; ++i) {
            x.push_back(0.1 * double(i));
            y.push_back(heights[20 * count + i]);
        }
        plot.line(who, x, y);
        table.row(who, {y[20], y[36], holds}, 1000, thousand);
    };
    show("yours", yours(), exercise::volume(3.0 * metre, 1.0 * metre, 2.0 * metre).value(), [] {
        static volatile double sink = 0;
        const exercise::Neighbours around{1.0 * metre, 1.1 * metre, 0.9 * metre, 1.0 * metre};
        for (int i = 0; i < 1000; ++i)
            sink = exercise::next_rate(sink * metre_per_second, 1.0 * metre, around, c, width, dt).value();
    });
    const ColumnGrid thousand(40, 25, width);
    WaterColumns::In<double> loop(WaterColumns{c}, thousand, 1.0 * metre);
    std::vector<double> heights(1000, 1.0), rates(1000, 0.0);
    show("library", library(), 6, [&] { loop.advance(heights, rates, dt); });
    plot.write();
    return table.print();
}
