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
    // task 1: return todo(1);
    const Flow volume = water.height * water.velocity;
    return {volume, volume * water.velocity + 0.5 * g * water.height * water.height};
    // end of task 1
}

/// 7.2.5: what passes the face between two waters on a level bed.
inline Passing passes(const Water& west, const Water& east, Quantity<unit::Acceleration> g) {
    // task 2: return todo(2);
    const auto still = 0.0 * metre_per_second;
    const auto wave_w = sqrt(g * west.height), wave_e = sqrt(g * east.height);
    const auto back = min(still, min(west.velocity - wave_w, east.velocity - wave_e));
    const auto on = max(still, max(west.velocity + wave_w, east.velocity + wave_e));
    const Passing w = carried(west, g), e = carried(east, g);
    if (back == on) return w; // dry on both sides
    const Flow volume = (on * w.volume - back * e.volume + back * on * (east.height - west.height)) / (on - back);
    const Push momentum = (on * w.momentum - back * e.momentum + back * on * (e.volume - w.volume)) / (on - back);
    return {volume, momentum};
    // end of task 2
}

/// 7.2.5: what passes the face between two columns, and what the step between their beds takes.
inline Face face(const Column& west, const Column& east, Quantity<unit::Acceleration> g) {
    // task 3: return todo(3);
    const auto none = 0.0 * metre;
    const Water w = water(west), e = water(east);
    const auto sill = max(west.bed, east.bed);
    const auto over_w = max(none, level(west) - sill);
    const auto over_e = max(none, level(east) - sill);
    const Passing over = passes({over_w, w.velocity}, {over_e, e.velocity}, g);
    Push held_w = 0.5 * g * (w.height * w.height - over_w * over_w);
    Push held_e = 0.5 * g * (e.height * e.height - over_e * over_e);
    if (over_w == none) held_w = passes(w, mirrored(w), g).momentum;
    if (over_e == none) held_e = passes(mirrored(e), e, g).momentum;
    return {over.volume, over.momentum + held_w, over.momentum + held_e};
    // end of task 3
}

/// 7.2.5: a step of all columns.
inline void step(Channel& channel, Quantity<unit::Acceleration> g, Quantity<unit::Time> dt) {
    // task 4: todo(4);
    auto& [columns, width] = channel;
    const Water first = water(columns.front()), last = water(columns.back());
    std::vector<Face> faces;
    faces.push_back({Flow(), Push(), passes(mirrored(first), first, g).momentum});
    for (std::size_t i = 0; i + 1 < columns.size(); ++i) faces.push_back(face(columns[i], columns[i + 1], g));
    faces.push_back({Flow(), passes(last, mirrored(last), g).momentum, Push()});
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i].height += dt / width * (faces[i].volume - faces[i + 1].volume);
        columns[i].flow += dt / width * (faces[i].east - faces[i + 1].west);
    }
    // end of task 4
}

} // namespace exercise
