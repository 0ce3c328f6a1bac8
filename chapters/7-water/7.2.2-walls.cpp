// SPDX-License-Identifier: BSL-1.0
// 7.2.2 Walls: a wave comes back upright, comes back upside down, or does not come back

// No water passes a solid wall, so the surface is level there and the wave is mirrored as it is. Where the level is
// held, at the mouth of a river, it is mirrored upside down. A piece of the sea has no walls at all: its border should
// let waves out, and one that knows its own column only can do so for those from straight ahead. (A part of 7.2 that
// the notes do not name.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
/// A hump of 10 cm in the middle of a channel of 20 m, 15 s later. It divides in two, and each half meets one wall.
//! [channel]
template <class Seen> Surface<WaterColumns> channel_after(Wall wall, Seen&& seen) {
    Surface water{WaterColumns{.wave_speed = 1.0 * metre_per_second, .walls = Walls::all(wall)},
                  ColumnGrid(400, 1, 0.05 * metre, 1.0 * metre), 1.0 * metre};
    for (std::size_t i = 0; i < 400; ++i) {
        const double x = water.grid().centre_x(i).value() - 10;
        water.set_height(i, 0, (1 + 0.1 * std::exp(-x * x)) * metre);
    }
    for (int n = 0; n < 300; ++n) {
        seen(n, water);
        water.step(0.05 * second);
    }
    return water;
}
//! [channel]
/// To a millionth.
double rounded(double x) { return std::round(1e6 * x) / 1e6 + 0.0; }
} // namespace

int main() {
    workbook::Claims claim;
    workbook::Plot plot("7.2.2", "A hump of 10 cm has divided, and each half has met a wall");
    plot.x("x").y("height above the still level");
    double high[3], low[3];
    const Wall walls[] = {Wall::reflects, Wall::holds, Wall::absorbs};
    const char* const names[] = {"reflects", "holds", "absorbs"};
    std::vector<std::vector<VectorQuantity<unit::Length>>> lines(60 * 3); // of the film: wall after wall
    for (int k = 0; k < 3; ++k) {
        const auto water = channel_after(walls[k], [&](int n, const auto& now) {
            for (std::size_t i = 0; n % 5 == 0 && i < 400; i += 3)
                lines[std::size_t(3 * (n / 5) + k)].push_back(
                    metres(now.grid().centre_x(i).value(), 25 * (now.height(i, 0).value() - 1) - 5 * k, 0));
        });
        std::vector<Length> x, y;
        for (std::size_t i = 0; i < 400; ++i) {
            x.push_back(water.grid().centre_x(i));
            y.push_back(water.height(i, 0) - 1.0 * metre);
        }
        high[k] = std::max_element(y.begin(), y.end())->value();
        low[k] = std::min_element(y.begin(), y.end())->value();
        const double more = (water.volume() - 20.0 * cubic_metre).value();
        std::cout << "A wall that " << names[k] << ": from " << rounded(low[k]) << " m to " << rounded(high[k])
                  << " m, " << rounded(more) << " m^3 more than still water\n";
        plot.line(names[k], x, y);
    }
    claim("a solid wall sends it back upright", high[0] > 0.049 && low[0] > -0.001);
    claim("one that holds the level sends it back upside down", low[1] < -0.049 && high[1] < 0.001);
    claim("one that absorbs keeps less than a hundredth", high[2] < 0.001 && low[2] > -0.001);
    plot.write();
    workbook::Film film(
        "7.2.2", "Waves against three kinds of walls (heights 25 times as large)",
        "A hump divides in two. At walls that reflect both halves come back upright, at walls that hold the level "
        "upside down, and at walls that absorb they leave.",
        {.middle = metres(10, -4.5, 0), .width = 21.0 * metre, .height = 15.0 * metre});
    for (int k = 0; k < 3; ++k)
        film.scenery().note(metres(0.2, -5 * k + 1.6, 0), std::string("a wall that ") + names[k]);
    for (std::size_t n = 0; n < 60; ++n) {
        auto& frame = film.frame(double(n) * 0.25 * second);
        for (std::size_t k = 0; k < 3; ++k)
            frame.filled(lines[3 * n + k], (-5.0 * double(k) - 1.6) * metre, workbook::paints::sea);
    }
    film.still(42).write();
    return claim.result();
}
