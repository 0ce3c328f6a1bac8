// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its loop over a grid of one row.
#include <ansatz/water/pipes.hpp>
#include <ansatz/world.hpp>

#include <vector>

namespace exercise {

struct Column {
    ansatz::Quantity<ansatz::unit::Length> bed, height, length;
};
inline ansatz::Quantity<ansatz::unit::Length> level(const Column& column) { return column.bed + column.height; }

struct Channel {
    std::vector<Column> columns;
    std::vector<ansatz::Quantity<ansatz::unit::VolumeFlow>> flows;
    ansatz::Quantity<ansatz::unit::Length> across;
};

inline void step(Channel& channel, ansatz::Quantity<ansatz::unit::Acceleration> g,
                 ansatz::Quantity<ansatz::unit::Frequency> damping, ansatz::Quantity<ansatz::unit::Time> dt) {
    using namespace ansatz;
    std::vector<Quantity<unit::Length>> lengths;
    Pipes::State<double> state;
    for (const Column& c : channel.columns) {
        lengths.push_back(c.length);
        state.height.push_back(c.height.value());
        state.bed.push_back(c.bed.value());
        state.flow_z.push_back(0.0);
    }
    for (const auto& flow : channel.flows) state.flow_x.push_back(flow.value());
    if (channel.columns.size() < 3) { // the library's grids have three: dry ground, far above the water
        lengths.push_back(1.0 * metre);
        state.height.push_back(0.0);
        state.bed.push_back(1e6);
        state.flow_x.push_back(0.0);
        state.flow_z.push_back(0.0);
    }
    state.flow_x.push_back(0.0); // the eastern wall
    Pipes::In<double> loop(Pipes{g, damping}, ColumnGrid(lengths, {channel.across}), 0.0 * metre);
    loop.advance(state, dt);
    for (std::size_t n = 0; n < channel.columns.size(); ++n) channel.columns[n].height = state.height[n] * metre;
    for (std::size_t n = 0; n < channel.flows.size(); ++n) channel.flows[n] = state.flow_x[n] * cubic_metre / second;
}

/// What is left of a flow through the face between two columns after a step.
inline ansatz::Quantity<ansatz::unit::VolumeFlow>
next_flow(ansatz::Quantity<ansatz::unit::VolumeFlow> flow, const Column& here, const Column& there,
          ansatz::Quantity<ansatz::unit::Length> across, ansatz::Quantity<ansatz::unit::Acceleration> g,
          ansatz::Quantity<ansatz::unit::Frequency> damping, ansatz::Quantity<ansatz::unit::Time> dt) {
    Channel both{{here, there}, {flow}, across};
    step(both, g, damping, dt);
    return both.flows[0];
}

/// Of a flow that is far too large so much passes as the depth carries over the way in a step; it comes from the column
/// with the higher level, which has enough for that.
inline ansatz::Quantity<ansatz::unit::Length> depth(const Column& here, const Column& there) {
    using namespace ansatz;
    const Column& high = level(here) < level(there) ? there : here;
    const Column& low = level(here) < level(there) ? here : there;
    const auto one = 1.0 * metre;
    const auto most = next_flow(1e9 * cubic_metre / second, {high.bed, high.height, one}, {low.bed, low.height, one},
                                one, 0.0 * metre_per_second_squared, 0.0 * hertz, 1.0 * second);
    return most * (1.0 * second) / (one * one);
}

/// The column between two that are long, dry and deep down, without gravity: what is left of a flow that leaves it.
inline double part(const Column& column, ansatz::Quantity<ansatz::unit::VolumeFlow> west,
                   ansatz::Quantity<ansatz::unit::VolumeFlow> east, ansatz::Quantity<ansatz::unit::Length> across,
                   ansatz::Quantity<ansatz::unit::Time> dt) {
    using namespace ansatz;
    const auto none = 0.0 * cubic_metre / second;
    const Column beside{column.bed - 10.0 * metre, 0.0 * metre, 1e9 * metre};
    Channel three{{beside, column, beside}, {west < none ? west : none, east > none ? east : none}, across};
    const auto before = three.flows;
    step(three, 0.0 * metre_per_second_squared, 0.0 * hertz, dt);
    for (std::size_t face = 0; face < 2; ++face)
        if (before[face] != none) return three.flows[face] / before[face];
    return 1;
}

} // namespace exercise
