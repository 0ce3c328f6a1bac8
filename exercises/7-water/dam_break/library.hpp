// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its face, and its loop over a grid of one row.
#include <ansatz/water/shallow_water.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

namespace exercise {

using Flow = ansatz::Quantity<ansatz::unit::Diffusivity>;
using Push = decltype(1.0 * ansatz::square_metre * ansatz::metre_per_second_squared);

struct Water {
    ansatz::Quantity<ansatz::unit::Length> height;
    ansatz::Quantity<ansatz::unit::Velocity> velocity;
};
struct Passing {
    Flow volume;
    Push momentum;
};
struct Column {
    ansatz::Quantity<ansatz::unit::Length> bed, height;
    Flow flow;
};
inline ansatz::Quantity<ansatz::unit::Length> level(const Column& column) { return column.bed + column.height; }
struct Face {
    Flow volume;
    Push west, east;
};
struct Channel {
    std::vector<Column> columns;
    ansatz::Quantity<ansatz::unit::Length> width;
};

/// The library leaves the pressure of each column out of what it gets, since it acts on both of its faces.
inline Face face(const Column& west, const Column& east, ansatz::Quantity<ansatz::unit::Acceleration> g) {
    using namespace ansatz;
    const auto flow = square_metre / second;
    const auto push = square_metre * metre_per_second_squared;
    auto side = [&](const Column& c) -> detail::FaceSide<double> {
        const double h = c.height.value(), film = detail::thinnest_water<double>();
        return {h, c.bed.value(), detail::speed_of_water(c.flow.value(), h, film), 0.0, std::sqrt(g.value() * h)};
    };
    auto pressure = [&](const Column& c) { return 0.5 * g.value() * c.height.value() * c.height.value(); };
    const auto flux = detail::hll<double>(side(west), side(east), g.value());
    return {flux.mass * flow, (flux.push_low + pressure(west)) * push, (flux.push_high + pressure(east)) * push};
}

/// On a level bed.
inline Passing passes(const Water& west, const Water& east, ansatz::Quantity<ansatz::unit::Acceleration> g) {
    using namespace ansatz;
    const Face all = face({0.0 * metre, west.height, west.height * west.velocity},
                          {0.0 * metre, east.height, east.height * east.velocity}, g);
    return {all.volume, all.west};
}

/// Between two waters that are alike.
inline Passing carried(const Water& water, ansatz::Quantity<ansatz::unit::Acceleration> g) {
    return passes(water, water, g);
}

inline void step(Channel& channel, ansatz::Quantity<ansatz::unit::Acceleration> g,
                 ansatz::Quantity<ansatz::unit::Time> dt) {
    using namespace ansatz;
    ShallowWater::State<double> state;
    for (const Column& c : channel.columns) {
        state.height.push_back(c.height.value());
        state.bed.push_back(c.bed.value());
        state.momentum_x.push_back(c.flow.value());
        state.momentum_z.push_back(0.0);
    }
    ShallowWater::In<double> loop(ShallowWater{g}, ColumnGrid(channel.columns.size(), 1, channel.width, 1.0 * metre),
                                  0.0 * metre);
    loop.advance(state, dt);
    for (std::size_t n = 0; n < channel.columns.size(); ++n) {
        channel.columns[n].height = state.height[n] * metre;
        channel.columns[n].flow = state.momentum_x[n] * square_metre / second;
    }
}

} // namespace exercise
