// SPDX-License-Identifier: BSL-1.0
// A hump that is carried along at one speed, with your slopes and without any: what a limiter is for.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/second_order_shallow_water.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ansatz;

const int count = 200;
const double width = 0.1, part = 0.4; // m, and how much of a column is passed in a step
const int steps = 250;

/// A smooth hump and a block, in a channel of 20 m whose ends are joined.
double height(int n) {
    const double x = (n + 0.5) * width;
    return 0.2 + 0.8 * std::exp(-(x - 3) * (x - 3)) + (x > 6 && x < 8 ? 0.8 : 0);
}

/// The channel, and how steep the lines in its columns are.
template <class HalfRise> struct Carried {
    HalfRise half_rise;
    std::vector<double> now;

    static std::size_t beside(int n, int way) { return std::size_t((n + way + count) % count); }
    std::vector<double> euler(const std::vector<double>& from) const {
        std::vector<double> at_face, to(from);
        for (int n = 0; n < count; ++n)
            at_face.push_back(from[beside(n, 0)] +
                              half_rise(from[beside(n, -1)], from[beside(n, 0)], from[beside(n, 1)]));
        for (int n = 0; n < count; ++n) to[beside(n, 0)] += part * (at_face[beside(n, -1)] - at_face[beside(n, 0)]);
        return to;
    }
    /// Heun's: the mean of where it was and of two steps of Euler.
    void step() {
        const auto twice = euler(euler(now));
        for (std::size_t n = 0; n < now.size(); ++n) now[n] = 0.5 * (now[n] + twice[n]);
    }
};

int main() {
    workbook::Play table("Water that runs 10 m eastwards at one speed, a hump and a block of 80 cm. Then:",
                         {"off, % of the water", "lowest, m", "highest, m"});
    table.timed("ns a column");
    workbook::Plot plot("play-water.limited_slope", "A hump and a block, carried along for 10 m");
    plot.x("x", "m").y("height", "m");
    std::vector<double> x, exact;
    for (int n = 0; n < count; ++n) {
        x.push_back((n + 0.5) * width);
        exact.push_back(height((n + count - 100) % count));
    }
    plot.line("as it should be", x, exact);
    auto show = [&](const char* who, auto half_rise) {
        Carried<decltype(half_rise)> water{half_rise, {}};
        for (int n = 0; n < count; ++n) water.now.push_back(height(n));
        for (int k = 0; k < steps; ++k) water.step();
        double off = 0, all = 0;
        for (std::size_t n = 0; n < exact.size(); ++n) {
            off += std::abs(water.now[n] - exact[n]);
            all += exact[n];
        }
        plot.line(who, x, water.now);
        const auto [lowest, highest] = std::minmax_element(water.now.begin(), water.now.end());
        table.row(who, {100 * off / all, *lowest, *highest}, count, [water]() mutable { water.step(); });
    };
    show("yours", [](double west, double here, double east) {
        return exercise::half_rise(west * metre, here * metre, east * metre, 1.8).value();
    });
    const detail::LinesAlong<double> lines(detail::ColumnAxis("x", 3, width * metre), 1.8);
    show("library", [line = lines[1]](double west, double here, double east) { return line.half(west, here, east); });
    show("level columns", [](double, double, double) { return 0.0; });
    show("without a limit", [](double west, double, double east) { return 0.25 * (east - west); });
    plot.write();
    return table.print();
}
