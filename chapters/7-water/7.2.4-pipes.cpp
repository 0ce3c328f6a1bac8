// SPDX-License-Identifier: BSL-1.0
// 7.2.4 Pipes: a flow through each face, so that water runs out where there is none, over any bed, and carries things

// Columns that pull at each other do not know how much water they have: over dry ground a height becomes negative. Give
// each face a flow, as if a pipe joined the two columns, and limit what leaves a column to what it holds: no height is
// negative, and no drop is lost. The flow is the velocity along the surface that the rate of height leaves out, and
// waves are as fast as the water is deep. (A part of 7.2.)

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
constexpr std::size_t count = 200;
const ColumnGrid channel(count, 1, 0.1 * metre, 1.0 * metre); // 20 m

/// A metre of water in the west, a centimetre in the east: the lowest height in ten seconds.
template <class Policy> Quantity<unit::Length> lowest_behind_a_dam(const Policy& policy) {
    Surface water{policy, channel, 0.0 * metre};
    for (std::size_t i = 0; i < count; ++i) water.set_height(i, 0, (i < count / 2 ? 1.0 : 0.01) * metre);
    double lowest = 1;
    for (int n = 0; n < 1000; ++n) {
        water.step(0.01 * second);
        lowest = std::min(lowest, *std::min_element(water.heights().begin(), water.heights().end()));
    }
    return lowest * metre;
}
} // namespace

int main() {
    workbook::Claims claim;

    const auto columns = lowest_behind_a_dam(WaterColumns{std::sqrt(9.81) * metre_per_second});
    const auto pipes = lowest_behind_a_dam(Pipes{});
    std::cout << "A dam breaks over a centimetre of water. The lowest height afterwards:\n  WaterColumns " << columns
              << "\n  Pipes        " << (pipes < 0.0 * metre ? "below zero" : "not below zero") << '\n';
    claim("columns go below the floor, pipes do not", columns < -0.1 * metre && pipes >= 0.0 * metre);

    // A beach, with a pool behind a bar: still water stands at two levels, and a wave comes in.
    //! [beach]
    std::vector<double> bed;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = channel.centre_x(i).value();
        bed.push_back(std::max(0.0, 0.12 * (x - 8)) - (x > 16 ? 0.9 * std::sin(0.75 * (x - 16)) : 0.0));
    }
    Surface shore{Pipes{}, channel, std::span<const double>(bed), 0.8 * metre};
    //! [beach]
    const auto still = shore.state();
    auto fastest = 0.0 * metre_per_second;
    for (int n = 0; n < 1000; ++n) shore.step(0.01 * second);
    for (std::size_t i = 0; i < count; ++i) fastest = std::max(fastest, abs(x(shore.velocity(i, 0))));
    std::cout << "Left alone for 10 s the shore's fastest water runs at "
              << (fastest < 1e-12 * metre_per_second ? "less than 1e-12 m/s" : "more than 1e-12 m/s") << '\n';
    claim("still water over any bed stays still", fastest < 1e-12 * metre_per_second);

    //! [wave]
    for (std::size_t i = 0; i < 30; ++i)
        shore.set_height(i, 0, (0.8 + 0.4 * std::pow(std::cos(0.5 * 0.1047 * double(i)), 2)) * metre);
    const auto before = shore.volume();
    double floating = 6; // m, something that floats there and goes with the flow
    std::vector<double> times, places;
    std::size_t furthest = 0;
    for (int n = 0; n < 800; ++n) {
        shore.step(0.01 * second);
        const auto here = shore.grid().column(floating * metre, 0.5 * metre);
        floating += 0.01 * x(shore.velocity(here, 0)).value();
        times.push_back(0.01 * n);
        places.push_back(floating);
        for (std::size_t i = 0; i < count; ++i)
            if (still.height[i] == 0 && shore.height(i, 0) > 1e-3 * metre) furthest = std::max(furthest, i);
    }
    //! [wave]
    workbook::say() << "The wave wets dry ground as far as " << channel.centre_x(furthest)
                    << "; what floated at 6 m came as far as " << *std::max_element(places.begin(), places.end())
                    << " m\n";
    claim("the wave runs up dry ground", furthest > 0);
    claim("what floats is carried along", *std::max_element(places.begin(), places.end()) > 6.2);
    claim("no drop is lost on the way", std::abs(double(shore.volume() / before) - 1) < 1e-13);

    std::vector<Length> at, ground, level;
    for (std::size_t i = 0; i < count; ++i) {
        at.push_back(channel.centre_x(i));
        ground.push_back(bed[i] * metre);
        level.push_back(ground[i] + shore.height(i, 0));
    }
    workbook::Plot plot("7.2.4", "A wave of 40 cm has run up a beach, 8 s later");
    plot.x("x").y("height");
    plot.line("water", at, level).reference("bed", at, ground).write();
    return claim.result();
}
