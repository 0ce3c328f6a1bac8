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
    return todo(1);
}

/// 7.2.2: the same beside a wall at which the `level` is held.
inline Velocity held(Velocity rate, Length height, Length inside, Length level, Velocity c, Length width, Time dt) {
    return todo(2);
}

/// 7.2.2: the same beside a wall that waves leave through.
inline Velocity open(Velocity rate, Length height, Length inside, Velocity c, Length width, Time dt) {
    return todo(3);
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
    todo(4);
}

} // namespace exercise
