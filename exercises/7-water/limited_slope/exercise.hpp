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
    return todo(1);
}

/// 7.2.6: the water at the western face of `here`.
inline Column west_end(const Column& west, const Column& here, const Column& east, double steepness) {
    return todo(2);
}

/// 7.2.6: the water at the eastern face of `here`.
inline Column east_end(const Column& west, const Column& here, const Column& east, double steepness) {
    return todo(2);
}

/// 7.2.6: the momentum that the water between both ends of a column gets from its own pressure and its bed.
inline Push pushed(const Column& west_end, const Column& east_end, Quantity<unit::Acceleration> g) {
    return todo(3);
}

} // namespace exercise
