// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.1 with your heights in it: a ball that slides over a map, pushed by the normal.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water/height_map.hpp>
#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

const int points = 9;
const auto width = 0.5 * metre;
double hill(double x, double z) { return 0.3 * std::cos(1.7 * x) * std::cos(1.1 * z); }

/// A section of the surface, and where a ball is that slides on it for three seconds from (1, 1).
template <class Height, class Slope> std::vector<double> run(std::vector<double>& section, Height&& height, Slope&& n) {
    section.clear();
    for (int k = 0; k <= 160; ++k) section.push_back(height(0.025 * k, 1.3));
    double x = 1, z = 1, vx = 0, vz = 0;
    for (int step = 0; step < 600; ++step) {
        const Vector<double, 3> up = n(x, z);
        vx += 0.005 * 9.81 * up[1] * up[0];
        vz += 0.005 * 9.81 * up[1] * up[2];
        x = std::min(4.0, std::max(0.0, x + 0.005 * vx));
        z = std::min(4.0, std::max(0.0, z + 0.005 * vz));
    }
    return {height(1.1, 2.3), x, z};
}

int main() {
    workbook::Play table(
        "A map of hills. How high is it at (1.1, 2.3) m, and where does a ball slide from (1, 1) m in 3 s?",
        {"height, m", "x, m", "z, m"});
    table.timed("ns a call");
    workbook::Plot plot("play-water.height_map", "A section at z = 1.3 m: yours and the library's");
    plot.x("x", "m").y("height", "m");
    exercise::Map map{points, points, width, width, {}};
    HeightMap<double> own(points, points, width, width);
    for (std::size_t j = 0; j < points; ++j)
        for (std::size_t i = 0; i < points; ++i) {
            const auto y = hill(0.5 * double(i), 0.5 * double(j)) * metre;
            map.heights.push_back(y);
            own.set(i, j, y);
        }
    std::vector<double> along, section;
    for (int k = 0; k <= 160; ++k) along.push_back(0.025 * k);
    static volatile double sink = 0.3;
    const auto yours = run(
        section, [&](double x, double z) { return exercise::height(map, x * metre, z * metre).value(); },
        [&](double x, double z) { return exercise::normal(map, x * metre, z * metre); });
    plot.line("yours", along, section);
    table.row("yours", yours, 1000, [&] {
        for (int i = 0; i < 1000; ++i) sink = exercise::height(map, (1 + 0 * sink) * metre, 1.3 * metre).value();
    });
    const auto library = run(
        section, [&](double x, double z) { return own.height(x * metre, z * metre).value(); },
        [&](double x, double z) { return own.normal(x * metre, z * metre); });
    plot.line("library", along, section);
    table.row("library", library, 1000, [&] {
        for (int i = 0; i < 1000; ++i) sink = own.height((1 + 0 * sink) * metre, 1.3 * metre).value();
    });
    plot.write();
    return table.print();
}
