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
    return todo(1);
}

/// 7.2.4: what runs from `here` to `there` after a step, in m^3/s, where `flow` ran before.
inline Quantity<unit::VolumeFlow> next_flow(Quantity<unit::VolumeFlow> flow, const Column& here, const Column& there,
                                            Quantity<unit::Length> across, Quantity<unit::Acceleration> g,
                                            Quantity<unit::Frequency> damping, Quantity<unit::Time> dt) {
    return todo(2);
}

/// 7.2.4: which part of what wants to leave a column in a step may leave it, 0 to 1. `west` and `east` run through its
/// two faces, positive eastwards.
inline double part(const Column& column, Quantity<unit::VolumeFlow> west, Quantity<unit::VolumeFlow> east,
                   Quantity<unit::Length> across, Quantity<unit::Time> dt) {
    return todo(3);
}

/// 7.2.4: a step of all columns.
inline void step(Channel& channel, Quantity<unit::Acceleration> g, Quantity<unit::Frequency> damping,
                 Quantity<unit::Time> dt) {
    todo(4);
}

} // namespace exercise
