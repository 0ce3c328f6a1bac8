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
    return todo(1);
}

/// What the links do to each body that is moved down by so much from where it hangs, beyond what holds its weight;
/// downwards is positive. moved[0] is that of the first body; there are as many as links.
inline std::vector<Force> forces(const std::vector<Length>& moved, Quantity<unit::Stiffness> stiffness) {
    return todo(2);
}

/// omega of a wave in which each body is behind the one before it by this angle, from 0 to pi. How long the links are
/// does not matter.
inline Frequency angular_frequency(double angle, const Chain& chain) {
    return todo(3);
}

/// How many links a second a group of such waves runs.
inline Frequency group_speed(double angle, const Chain& chain) {
    return todo(4);
}

} // namespace exercise
