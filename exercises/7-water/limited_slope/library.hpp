// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its limiter for columns of one width, and what it makes of the ends.
#include <ansatz/water/second_order_shallow_water.hpp>
#include <ansatz/world.hpp>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Push = decltype(1.0 * ansatz::square_metre * ansatz::metre_per_second_squared);

struct Column {
    Length bed, height;
};
inline Length level(const Column& column) { return column.bed + column.height; }

inline Length half_rise(Length west, Length here, Length east, double steepness) {
    using namespace ansatz;
    const detail::LinesAlong<double> lines(detail::ColumnAxis("x", 3, 1.0 * metre), steepness);
    return lines[1].half(west.value(), here.value(), east.value()) * metre;
}

inline Column end(const Column& west, const Column& here, const Column& east, double steepness, double side) {
    const Length height = here.height + side * half_rise(west.height, here.height, east.height, steepness);
    return {level(here) + side * half_rise(level(west), level(here), level(east), steepness) - height, height};
}
inline Column west_end(const Column& west, const Column& here, const Column& east, double steepness) {
    return end(west, here, east, steepness, -1);
}
inline Column east_end(const Column& west, const Column& here, const Column& east, double steepness) {
    return end(west, here, east, steepness, 1);
}

/// As the header has it: -2 g h times half of the rise of the level.
inline Push pushed(const Column& west_end, const Column& east_end, ansatz::Quantity<ansatz::unit::Acceleration> g) {
    const Length mean = 0.5 * (west_end.height + east_end.height), rise = 0.5 * (level(east_end) - level(west_end));
    return -2.0 * g * mean * rise;
}

} // namespace exercise
