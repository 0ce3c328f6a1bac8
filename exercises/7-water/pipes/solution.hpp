// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

using namespace ansatz;

namespace exercise {

struct Column {
    Quantity<unit::Length> bed;    ///< height of the ground
    Quantity<unit::Length> height; ///< of the water over it
    Quantity<unit::Length> length; ///< along the channel
};
inline Quantity<unit::Length> level(const Column& column) { return column.bed + column.height; }

struct Channel {
    std::vector<Column> columns;                   ///< from west to east
    std::vector<Quantity<unit::VolumeFlow>> flows; ///< flows[i] from column i to i + 1; negative: from i + 1 to i
    Quantity<unit::Length> across;                 ///< how wide it is
};

/// 7.2.4: how deep the water is at the face between two columns, in m.
inline Quantity<unit::Length> depth(const Column& here, const Column& there) {
    // task 1: return todo(1);
    return max(level(here), level(there)) - max(here.bed, there.bed);
    // end of task 1
}

/// 7.2.4: what runs from `here` to `there` after a step, in m^3/s, where `flow` ran before.
inline Quantity<unit::VolumeFlow> next_flow(Quantity<unit::VolumeFlow> flow, const Column& here, const Column& there,
                                            Quantity<unit::Length> across, Quantity<unit::Acceleration> g,
                                            Quantity<unit::Frequency> damping, Quantity<unit::Time> dt) {
    // task 2: return todo(2);
    const auto way = 0.5 * (here.length + there.length);
    const auto area = across * depth(here, there);
    const auto push = g * area * (level(here) - level(there)) / way;
    const auto runs = (flow + push * dt) * std::exp(-double(damping * dt));
    const Quantity<unit::VolumeFlow> most = area * way / dt;
    return max(-most, min(runs, most));
    // end of task 2
}

/// 7.2.4: which part of what wants to leave a column in a step may leave it, 0 to 1. `west` and `east` run through its
/// two faces, positive eastwards.
inline double part(const Column& column, Quantity<unit::VolumeFlow> west, Quantity<unit::VolumeFlow> east,
                   Quantity<unit::Length> across, Quantity<unit::Time> dt) {
    // task 3: return todo(3);
    const auto none = 0.0 * cubic_metre / second;
    const Quantity<unit::Volume> wants = (max(none, east) + max(none, -west)) * dt;
    const auto has = max(0.0 * cubic_metre, column.height * column.length * across); // rounding may leave a hair less
    return wants > has ? double(has / wants) : 1.0;
    // end of task 3
}

/// 7.2.4: a step of all columns.
inline void step(Channel& channel, Quantity<unit::Acceleration> g, Quantity<unit::Frequency> damping,
                 Quantity<unit::Time> dt) {
    // task 4: todo(4);
    auto& [columns, flows, across] = channel;
    for (std::size_t i = 0; i < flows.size(); ++i)
        flows[i] = next_flow(flows[i], columns[i], columns[i + 1], across, g, damping, dt);
    const auto none = 0.0 * cubic_metre / second;
    std::vector<double> parts;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto west = i > 0 ? flows[i - 1] : none, east = i < flows.size() ? flows[i] : none;
        parts.push_back(part(columns[i], west, east, across, dt));
    }
    for (std::size_t i = 0; i < flows.size(); ++i) flows[i] *= flows[i] > none ? parts[i] : parts[i + 1];
    for (std::size_t i = 0; i < flows.size(); ++i) {
        columns[i].height -= flows[i] * dt / (columns[i].length * across);
        columns[i + 1].height += flows[i] * dt / (columns[i + 1].length * across);
    }
    // end of task 4
}

} // namespace exercise
