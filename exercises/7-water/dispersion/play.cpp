// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.3 with your waves in it: two waves of nearly one length make groups, and the groups run.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/waves.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const auto depth = 3.0 * metre;
const auto gravity = 9.81 * metre_per_second_squared;

int main() {
    workbook::Play table("Two waves of 2 m and 2.2 m, 5 cm each, in water of 3 m.",
                         {"at 7 m after 4 s, m", "omega of the first, 1/s", "speed of a group, m/s"});
    table.timed("ns a call");
    workbook::Plot plot("play-water.dispersion", "Two waves after 4 s: yours and the library's");
    plot.x("x", "m").y("height", "m");
    auto show = [&](const char* who, auto&& height, double omega, double speed) {
        std::vector<double> x, y;
        for (int i = 0; i <= 400; ++i) {
            x.push_back(0.1 * i);
            y.push_back(height(0.1 * i, 4.0));
        }
        plot.line(who, x, y);
        table.row(who, {y[70], omega, speed}, 1000, [height] {
            static volatile double sink = 0;
            for (int i = 0; i < 1000; ++i) sink = height(sink, 4.0);
        });
    };
    const std::vector<exercise::Wave> waves = {{2.0 * metre, 0.05 * metre}, {2.2 * metre, 0.05 * metre}};
    show(
        "yours",
        [&](double x, double t) { return exercise::height(waves, depth, gravity, x * metre, t * second).value(); },
        exercise::angular_frequency(2.0 * metre, depth, gravity).value(),
        exercise::group_speed(2.1 * metre, depth, gravity).value());
    const Waves own({{2.0 * metre, 0.05 * metre}, {2.2 * metre, 0.05 * metre}}, depth, gravity);
    show(
        "library", [&](double x, double t) { return own.height(x * metre, 0.0 * metre, t * second).value(); },
        water::angular_frequency(2.0 * metre, depth, gravity).value(),
        water::group_speed(2.1 * metre, depth, gravity).value());
    plot.write();
    return table.print();
}
