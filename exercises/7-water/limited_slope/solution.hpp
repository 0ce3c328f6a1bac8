// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Push = decltype(1.0 * square_metre * metre_per_second_squared); ///< m^3/s^2: momentum a second and metre of width

/// A column, or the water at one of its ends.
struct Column {
    Length bed;    ///< height of the ground
    Length height; ///< of the water over it
};
inline Length level(const Column& column) { return column.bed + column.height; }

/// 7.2.6: how much the line through a column rises from its middle to its eastern face.
inline Length half_rise(Length west, Length here, Length east, double steepness) {
    // task 1: return todo(1);
    const Length none = 0.0 * metre;
    const Length middle = 0.25 * (east - west);
    const Length before = 0.5 * steepness * (here - west);
    const Length after = 0.5 * steepness * (east - here);
    if (before > none && after > none) return min(middle, min(before, after));
    if (before < none && after < none) return max(middle, max(before, after));
    return none;
    // end of task 1
}

/// 7.2.6: the water at the western face of `here`.
inline Column west_end(const Column& west, const Column& here, const Column& east, double steepness) {
    // task 2: return todo(2);
    const Length height = here.height - half_rise(west.height, here.height, east.height, steepness);
    const Length surface = level(here) - half_rise(level(west), level(here), level(east), steepness);
    return {surface - height, height};
    // end of task 2
}

/// 7.2.6: the water at the eastern face of `here`.
inline Column east_end(const Column& west, const Column& here, const Column& east, double steepness) {
    // task 2: return todo(2);
    const Length tall = here.height + half_rise(west.height, here.height, east.height, steepness);
    const Length top = level(here) + half_rise(level(west), level(here), level(east), steepness);
    return {top - tall, tall};
    // end of task 2
}

/// 7.2.6: the momentum that the water between both ends of a column gets from its own pressure and its bed.
inline Push pushed(const Column& west_end, const Column& east_end, Quantity<unit::Acceleration> g) {
    // task 3: return todo(3);
    const Length w = west_end.height, e = east_end.height;
    const Push pressure = 0.5 * g * (w * w - e * e);
    const Push weight = 0.5 * g * (w + e) * (west_end.bed - east_end.bed);
    return pressure + weight;
    // end of task 3
}

} // namespace exercise
