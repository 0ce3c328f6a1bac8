// SPDX-License-Identifier: BSL-1.0
// The scene of section 7.4.2 with your formulas in it: a ball of 300 kg/m^3 is let go above the water, and bobs.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

const double radius = 0.5, mass_of_ball = 300 * 4.0 / 3 * std::acos(-1.0) * radius * radius * radius;
const auto dt = 1.0 / 120 * second;

/// Its height over the water in each of 600 steps of semi-implicit Euler, and a little resistance.
std::vector<double> yours() {
    std::vector<double> heights;
    auto y = 1.0 * metre;
    auto v = 0.0 * metre_per_second;
    for (int n = 0; n < 600; ++n) {
        const auto volume = exercise::submerged(radius * metre, radius * metre - y);
        v += dt * exercise::acceleration(mass_of_ball * kilogram, volume, 1000.0 * kilogram_per_cubic_metre,
                                         9.81 * metre_per_second_squared);
        v *= 1 - 1.0 * (dt.value() * 1000 * volume.value() / mass_of_ball);
        y += dt * v;
        heights.push_back(y.value());
    }
    return heights;
}
std::vector<double> library() {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{3.0 * metre_per_second}, ColumnGrid(20, 20, 1.0 * metre), 5.0 * metre}});
    const auto ball = world.add(position(metres(10, 6, 10)), mass(mass_of_ball * kilogram));
    world.add(Floating{.body = ball, .by = Sphere{radius * metre}, .damping = 1.0 / second, .presses = false});
    std::vector<double> heights;
    for (int n = 0; n < 600; ++n) {
        world.step(dt);
        heights.push_back(y(world.position(ball)).value() - 5);
    }
    return heights;
}

int main() {
    workbook::Play table("A ball of 300 kg/m^3 falls into the water and bobs. Where is it after 1 s, 2 s and 5 s?",
                         {"1 s, m", "2 s, m", "5 s, m"});
    table.timed("ns a call");
    workbook::Plot plot("play-water.buoyancy", "A ball that bobs: yours and the library's");
    plot.x("time", "s").y("height over the water", "m");
    auto show = [&](const char* who, const std::vector<double>& heights, auto&& thousand) {
        std::vector<double> times;
        for (std::size_t n = 0; n < heights.size(); ++n) times.push_back(double(n + 1) / 120);
        plot.line(who, times, heights);
        table.row(who, {heights[119], heights[239], heights[599]}, 1000, thousand);
    };
    static volatile double sink = 0.3;
    show("yours", yours(), [] {
        for (int i = 0; i < 1000; ++i) sink = exercise::submerged(0.7 * metre, (0.3 + 0 * sink) * metre).value();
    });
    show("library", library(), [] {
        for (int i = 0; i < 1000; ++i) sink = submerged(Sphere{0.7 * metre}, (0.3 + 0 * sink) * metre).volume.value();
    });
    plot.write();
    return table.print();
}
