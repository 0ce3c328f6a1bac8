// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its loop over a grid of one row.
#include <ansatz/water/water_columns.hpp>
#include <ansatz/world.hpp>

#include <span>
#include <vector>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Velocity = ansatz::Quantity<ansatz::unit::Velocity>;
using Time = ansatz::Quantity<ansatz::unit::Time>;

enum class End { solid, held, open };
struct Channel {
    std::vector<Length> heights;
    std::vector<Velocity> rates;
    Length width;
    Velocity c;
    Length level;
    End west, east;
};

inline ansatz::Wall wall(End end) {
    if (end == End::held) return ansatz::Wall::holds;
    return end == End::open ? ansatz::Wall::absorbs : ansatz::Wall::reflects;
}
inline void step(Channel& channel, Time dt) {
    using namespace ansatz;
    const WaterColumns water{.wave_speed = channel.c, .walls = {wall(channel.west), wall(channel.east)}};
    const ColumnGrid grid(channel.heights.size(), 1, channel.width, 1.0 * metre);
    const WaterColumns::In<double> loop(water, grid, channel.level);
    std::vector<double> heights, rates;
    for (const auto& h : channel.heights) heights.push_back(h.value());
    for (const auto& v : channel.rates) rates.push_back(v.value());
    loop.advance(std::span(heights), std::span(rates), dt);
    for (std::size_t n = 0; n < heights.size(); ++n) {
        channel.heights[n] = heights[n] * metre;
        channel.rates[n] = rates[n] * metre_per_second;
    }
}

/// The last of three columns.
inline Velocity beside(End end, Velocity rate, Length height, Length inside, Length level, Velocity c, Length width,
                       Time dt) {
    const Velocity none = 0.0 * ansatz::metre_per_second;
    Channel three{{inside, inside, height}, {none, none, rate}, width, c, level, End::solid, end};
    step(three, dt);
    return three.rates[2];
}
inline Velocity solid(Velocity rate, Length height, Length inside, Velocity c, Length width, Time dt) {
    return beside(End::solid, rate, height, inside, height, c, width, dt);
}
inline Velocity held(Velocity rate, Length height, Length inside, Length level, Velocity c, Length width, Time dt) {
    return beside(End::held, rate, height, inside, level, c, width, dt);
}
inline Velocity open(Velocity rate, Length height, Length inside, Velocity c, Length width, Time dt) {
    return beside(End::open, rate, height, inside, height, c, width, dt);
}

} // namespace exercise
