// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

using Flow = Quantity<unit::Diffusivity>; ///< h u, m^2/s: volume a second and metre of width
using Push = decltype(1.0 * square_metre * metre_per_second_squared); ///< m^3/s^2: momentum a second and metre of width

/// Water on a level bed.
struct Water {
    Quantity<unit::Length> height;
    Quantity<unit::Velocity> velocity; ///< eastwards
};
/// The same water in a mirror that stands across the channel.
inline Water mirrored(const Water& water) { return {water.height, -water.velocity}; }

/// What passes a face eastwards.
struct Passing {
    Flow volume;
    Push momentum;
};

struct Column {
    Quantity<unit::Length> bed;    ///< height of the ground
    Quantity<unit::Length> height; ///< of the water over it
    Flow flow;                     ///< h u
};
inline Quantity<unit::Length> level(const Column& column) { return column.bed + column.height; }
/// Its height, and its velocity: none where there is less water than can be seen.
inline Water water(const Column& column) {
    if (column.height < 1e-9 * metre) return {column.height, 0.0 * metre_per_second};
    return {column.height, column.flow / column.height};
}

/// What the face between two columns does to both of them.
struct Face {
    Flow volume; ///< from the western column to the eastern one
    Push west;   ///< momentum that the western column loses
    Push east;   ///< momentum that the eastern column gets
};

struct Channel {
    std::vector<Column> columns;  ///< from west to east
    Quantity<unit::Length> width; ///< of each, along the channel
};

/// 7.2.5: what runs through a face in the midst of water.
inline Passing carried(const Water& water, Quantity<unit::Acceleration> g) {
    return todo(1);
}

/// 7.2.5: what passes the face between two waters on a level bed.
inline Passing passes(const Water& west, const Water& east, Quantity<unit::Acceleration> g) {
    return todo(2);
}

/// 7.2.5: what passes the face between two columns, and what the step between their beds takes.
inline Face face(const Column& west, const Column& east, Quantity<unit::Acceleration> g) {
    return todo(3);
}

/// 7.2.5: a step of all columns.
inline void step(Channel& channel, Quantity<unit::Acceleration> g, Quantity<unit::Time> dt) {
    todo(4);
}

} // namespace exercise
