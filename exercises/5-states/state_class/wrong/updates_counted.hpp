// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: updates were counted, not seconds
// Why:     A sixtieth of a second for each update is right at 60 updates a second and nowhere else.
// Read:    5.1.2
// Fails:   every-two-seconds

#include <ansatz/units.hpp>

#include <algorithm>

using namespace ansatz;

namespace exercise {

/// The guard: what all of his states share.
struct Npc {
    Quantity<unit::Length> place{};
    int shouts = 0;
};

/// 5.1.2: the class of the state patrol. He walks at 1 m/s between the posts at 0 m and 10 m, to the far one first.
struct Patrol {
    Quantity<unit::Length> post = 10.0 * metre; ///< where he is going; the state's own

    /// One update: `dt` of walking. He stops at a post, and goes for the other one from the next update on.
    void update(Npc& npc, Quantity<unit::Time> dt) {
        const auto step = 1.0 * metre_per_second * dt;
        npc.place += std::clamp(post - npc.place, -step, step);
        if (npc.place == post) post = 10.0 * metre - post; // clamp ends exactly there
    }
};

/// The class of the state alarm. He shouts when he enters it, and then every 2 s.
struct Alarm {
    Quantity<unit::Time> silent{}; ///< since the last shout; the state's own

    void enter(Npc& npc) {
        ++npc.shouts;
        silent = {};
    }
    void update(Npc& npc, Quantity<unit::Time> dt) {
        silent += 1.0 / 60 * second;
        if (silent >= 2.0 * second) {
            ++npc.shouts;
            silent = {};
        }
    }
};

} // namespace exercise
