// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Velocity = Quantity<unit::Velocity>;
using Time = Quantity<unit::Time>;

/// 7.2.2: how fast the last column rises after a step, in m/s, beside a solid wall.
inline Velocity solid(Velocity rate, Length height, Length inside, Velocity c, Length width, Time dt) {
    // task 1: return todo(1);
    return rate + c * c * (inside - height) / (width * width) * dt;
    // end of task 1
}

/// 7.2.2: the same beside a wall at which the `level` is held.
inline Velocity held(Velocity rate, Length height, Length inside, Length level, Velocity c, Length width, Time dt) {
    // task 2: return todo(2);
    const auto pulled = 2.0 * c * c * (level - height) / (width * width) * dt;
    return solid(rate, height, inside, c, width, dt) + pulled;
    // end of task 2
}

/// 7.2.2: the same beside a wall that waves leave through.
inline Velocity open(Velocity rate, Length height, Length inside, Velocity c, Length width, Time dt) {
    // task 3: return todo(3);
    const double part = 0.5 * double(c * dt / width);
    return (solid(rate, height, inside, c, width, dt) - part * rate) / (1 + part);
    // end of task 3
}

/// What is at an end of a channel.
enum class End { solid, held, open };
struct Channel {
    std::vector<Length> heights; ///< from west to east
    std::vector<Velocity> rates;
    Length width;   ///< of each column
    Velocity c;     ///< of waves
    Length level;   ///< what a wall that holds holds
    End west, east; ///< its walls
};

/// 7.2.2: a step of the channel.
inline void step(Channel& channel, Time dt) {
    // task 4: todo(4);
    auto& heights = channel.heights;
    auto& rates = channel.rates;
    const auto c = channel.c;
    const auto width = channel.width;
    const std::size_t last = heights.size() - 1;
    auto at = [&](End end, std::size_t n, std::size_t inside) {
        const auto rate = rates[n];
        const auto h = heights[n], in = heights[inside];
        if (end == End::held) return held(rate, h, in, channel.level, c, width, dt);
        return end == End::open ? open(rate, h, in, c, width, dt) : solid(rate, h, in, c, width, dt);
    };
    rates[0] = at(channel.west, 0, 1);
    rates[last] = at(channel.east, last, last - 1);
    for (std::size_t n = 1; n < last; ++n)
        rates[n] += c * c * (heights[n - 1] + heights[n + 1] - 2.0 * heights[n]) / (width * width) * dt;
    for (std::size_t n = 0; n <= last; ++n) heights[n] += rates[n] * dt;
    // end of task 4
}

} // namespace exercise
