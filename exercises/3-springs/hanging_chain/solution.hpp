// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

using namespace ansatz;

namespace exercise {

using Length = Quantity<unit::Length>;
using Force = Quantity<unit::Force>;
using Frequency = Quantity<unit::Frequency>;

/// Equal bodies below a hook. Each of the links is a spring from one body up to the next, the first one to the hook.
struct Chain {
    int links; ///< as many as there are bodies; 1 at least
    Quantity<unit::Mass> mass;
    Quantity<unit::Stiffness> stiffness;
    Length rest_length; ///< of one link
};

/// 3.3: how far below the hook this body hangs at rest; from 1, the first below the hook, to chain.links.
inline Length hangs_at(int body, const Chain& chain, Quantity<unit::Acceleration> g) {
    // task 1: return todo(1);
    Length below = 0.0 * metre;
    for (int link = 1; link <= body; ++link) {
        const int carries = chain.links - link + 1;
        below += chain.rest_length + double(carries) * chain.mass * g / chain.stiffness;
    }
    return below;
    // end of task 1
}

/// What the links do to each body that is moved down by so much from where it hangs, beyond what holds its weight;
/// downwards is positive. moved[0] is that of the first body; there are as many as links.
inline std::vector<Force> forces(const std::vector<Length>& moved, Quantity<unit::Stiffness> stiffness) {
    // task 2: return todo(2);
    std::vector<Force> on(moved.size(), 0.0 * newton);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Length above = i == 0 ? 0.0 * metre : moved[i - 1];
        const Force pull = stiffness * (moved[i] - above); // how much harder the link above body i pulls
        on[i] -= pull;
        if (i > 0) on[i - 1] += pull;
    }
    return on;
    // end of task 2
}

/// omega of a wave in which each body is behind the one before it by this angle, from 0 to pi. How long the links are
/// does not matter.
inline Frequency angular_frequency(double angle, const Chain& chain) {
    // task 3: return todo(3);
    return 2 * std::sin(angle / 2) * sqrt(chain.stiffness / chain.mass);
    // end of task 3
}

/// How many links a second a group of such waves runs.
inline Frequency group_speed(double angle, const Chain& chain) {
    // task 4: return todo(4);
    return std::cos(angle / 2) * sqrt(chain.stiffness / chain.mass);
    // end of task 4
}

} // namespace exercise
