// SPDX-License-Identifier: BSL-1.0
// 7.4 Buoyancy: a fixed acceleration beside Archimedes, and what it does not know

// "The simplest is to apply a fixed acceleration in the y axis to counteract the fixed acceleration due to gravity.
// Depending on the value relative to gravity this can either slow (for entities denser than the fluid) or reverse (for
// entities less dense than the fluid) the rate of submersion." With g rho_water / rho it is exactly what Archimedes
// says of a body deep under water. It does not know how deep the body is, so that at the surface the two differ: what
// is light is thrown out as fast as it fell in, and never floats.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
constexpr double g = 9.81, radius = 0.25, rate = 240;
const double volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius; // m^3

/// The height of a ball of a density that falls into 4 m of water from a metre above it.
std::vector<Length> heights(double density, bool archimedes) {
    //! [models]
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{3.0 * metre_per_second}, ColumnGrid(20, 20, 0.5 * metre), 4.0 * metre}});
    const auto ball = world.add(position(metres(5, 5, 5)), mass(density * volume * kilogram));
    if (archimedes) world.add(Floating{.body = ball, .by = Sphere{radius * metre}, .damping = 1.0 / second});
    else world.add(Floating{.body = ball, .by = FixedLift{g * 1000 / density * metre_per_second_squared}});
    //! [models]
    std::vector<Length> all;
    for (int n = 0; n < 6 * int(rate); ++n) {
        all.push_back(y(world.position(ball)));
        world.step(1 / rate * second);
    }
    return all;
}
/// How fast it goes faster at a moment, m/s^2.
double acceleration(const std::vector<Length>& heights, double seconds) {
    const auto n = std::size_t(seconds * rate);
    return (heights[n + 1] - 2.0 * heights[n] + heights[n - 1]).value() * rate * rate;
}
} // namespace

int main() {
    workbook::Claims claim;
    const auto stone = heights(2000, false), cork = heights(250, false);
    const auto stone_exact = heights(2000, true), cork_exact = heights(250, true);

    workbook::say() << "A stone of 2000 kg/m^3 falls through the water with " << acceleration(stone, 0.7)
                    << " m/s^2, where g is -9.81\n";
    claim("the denser body is slowed, to half of g", std::abs(acceleration(stone, 0.7) + g / 2) < 1e-9);
    const double lowest = std::min_element(cork.begin(), cork.end())->value();
    std::cout << "A cork of 250 kg/m^3 is turned round " << std::round((4 - lowest) * 100) << " cm under the surface\n";
    claim("the lighter body is turned round", lowest > 3 && lowest < 4);
    const double leaps = std::max_element(cork.end() - 2 * int(rate), cork.end())->value();
    workbook::say() << "In the last two seconds the cork with a fixed acceleration still leaps to "
                    << std::round(leaps * 10) / 10 << " m; the water is 4 m deep\n";
    claim("a fixed acceleration never lets it float", leaps > 4.8);
    const double rest = cork_exact.back().value();
    std::cout << "With Archimedes it lies at " << std::round(rest * 100) / 100 << " m\n";
    claim("Archimedes does", std::abs(rest - 4) < radius);

    std::vector<Quantity<unit::Time>> times;
    for (std::size_t n = 0; n < cork.size(); ++n) times.push_back(double(n) / rate * second);
    auto shown = [&](const std::vector<Length>& all) { // down to the floor
        std::vector<Length> part = all;
        for (auto& height : part) height = std::max(height, 0.0 * metre);
        return part;
    };
    workbook::Plot plot("7.4", "A stone and a cork fall into water that is 4 m deep");
    plot.x("time").y("height");
    plot.line("cork, fixed acceleration", times, shown(cork)).line("cork, Archimedes", times, shown(cork_exact));
    plot.line("stone, fixed acceleration", times, shown(stone)).line("stone, Archimedes", times, shown(stone_exact));
    plot.write();
    return claim.result();
}
