// SPDX-License-Identifier: BSL-1.0
// 7.2 Column approach: cuboids of water, each with a height and the rate at which it rises, and a drop into a pool

// A column of height h over a footprint of dx and dz holds V = h dx dz. (The notes say the area in the XY plane; y
// points up, so that it is XZ.) The velocity is the change of height in time, one number in the place of three, and
// each column is pulled towards its neighbours: the wave equation on a grid. What leaves one through a face enters the
// next, so that the volume stays. What is left out: the water's own flow. A boat that drifts wants it, and must ask
// another surface.

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

int main() {
    workbook::Claims claim;

    //! [volume]
    const ColumnGrid wide(3, 3, 1.0 * metre, 2.0 * metre); // y up: footprints lie in x and z
    std::vector<double> heights(wide.size());
    heights[wide.index(1, 1)] = 3;
    const auto one = wide.volume(std::span<const double>(heights));
    std::cout << "A column of 3 m over 1 m by 2 m holds " << one << '\n';
    //! [volume]
    claim("V = h dx dz", one == 6.0 * cubic_metre);

    //! [drop]
    Surface pool{WaterColumns{.wave_speed = 2.0 * metre_per_second}, ColumnGrid(101, 101, 0.1 * metre), 1.0 * metre};
    const auto& grid = pool.grid();
    for (std::size_t j = 0; j < 101; ++j)
        for (std::size_t i = 0; i < 101; ++i) {
            const double x = grid.centre_x(i).value() - 5.05, z = grid.centre_z(j).value() - 5.05;
            pool.set_height(i, j, (1 + 0.1 * std::exp(-(x * x + z * z) / 0.18)) * metre);
        }
    auto seen = pool; // for the film
    const auto before = pool.volume();
    for (int n = 0; n < 60; ++n) pool.step(1.0 / 40 * second); // 1.5 s
    //! [drop]
    std::vector<Length> along, after;
    std::size_t crest = 50;
    for (std::size_t i = 50; i < 101; ++i) {
        along.push_back(grid.centre_x(i) - grid.centre_x(50));
        after.push_back(pool.height(i, 50) - 1.0 * metre);
        if (pool.height(i, 50) > pool.height(crest, 50)) crest = i;
    }
    const auto ring = grid.centre_x(crest) - grid.centre_x(50);
    std::cout << "After 1.5 s at 2 m/s the crest is " << ring << " from the drop, "
              << pool.height(crest, 50) - 1.0 * metre << " high\n";
    claim("the ring runs at the speed of waves", abs(ring - 3.0 * metre) < 0.2 * metre);
    std::cout << "There the column " << (pool.rate(crest + 3, 50) > 0.0 * metre_per_second ? "rises" : "falls")
              << " before the crest and " << (pool.rate(crest - 4, 50) > 0.0 * metre_per_second ? "rises" : "falls")
              << " behind it\n";
    claim("the velocity of a column is the rate of its height",
          pool.rate(crest + 3, 50) > 0.0 * metre_per_second && pool.rate(crest - 4, 50) < 0.0 * metre_per_second);
    claim("what leaves a column enters its neighbours: volume to 1e-13",
          std::abs(double(pool.volume() / before) - 1) < 1e-13);
    const double diagonal = (pool.level(7.121 * metre, 7.121 * metre) - pool.level(7.98 * metre, 5.05 * metre)).value();
    std::cout << "Along a diagonal the ring is " << diagonal << " m from what it is along x\n";
    claim("the ring is round, to a hundredth of the drop", std::abs(diagonal) < 1e-3);

    // One step too long.
    //! [too_long]
    try {
        pool.step(0.05 * second);
    } catch (const std::invalid_argument& refused) {
        workbook::say() << refused.what() << '\n';
    }
    //! [too_long]
    claim("the pool takes no step beyond the limit dx / (c sqrt(2))",
          std::abs(pool.longest_step().value() - 0.1 / (2 * std::sqrt(2))) < 1e-15);

    workbook::Film film(
        "7.2", "A drop falls into a pool (heights 15 times as large)",
        "A hump of water in the middle of a square pool sinks; rings run outwards, meet the walls and come "
        "back.",
        {.middle = metres(5.05, 0.7, 5.05), .width = 10.6 * metre, .height = 6.0 * metre, .above = degrees(26)});
    for (int n = 0; n < 40; ++n) {
        std::vector<VectorQuantity<unit::Length>> surface;
        for (std::size_t j = 0; j < 101; j += 4)
            for (std::size_t i = 0; i < 101; i += 2)
                surface.push_back(metres(seen.grid().centre_x(i).value(), 1 + 15 * (seen.height(i, j).value() - 1),
                                         seen.grid().centre_z(j).value()));
        film.frame(double(n) * 0.075 * second).rows(surface, 51, 0.0 * metre, workbook::paints::sea);
        for (int k = 0; k < 3; ++k) seen.step(1.0 / 40 * second);
    }
    film.rate(40.0 / 3).still(14).write();

    workbook::Plot plot("7.2", "A drop fell into the middle of a pool 1.5 s ago; waves travel at 2 m/s");
    plot.x("distance from the drop").y("height above the still level");
    plot.line("columns", along, after).vertical(3.0 * metre, "c t").write();
    return claim.result();
}
