// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The roles of bodies that collide: which may touch, which do, and what comes of it (notes 2).

#include <ansatz/world/roles.hpp>

namespace ansatz {

namespace modules {
struct Collision; // collision/module.hpp
}

namespace roles {
/// Pairs that may touch; at most one.
struct Broadphase {
    using module = modules::Collision; ///< it comes with
};
/// Which pairs are tested; at most one.
struct Filter {
    using module = modules::Collision; ///< it comes with
};
/// Contacts of those pairs; exactly one with a broadphase, none without.
struct Narrowphase {
    using module = modules::Collision; ///< it comes with
};
/// What contacts do; one (or a chain) with a narrowphase, none without.
struct Response {
    using module = modules::Collision; ///< it comes with
};
} // namespace roles

/// On what a response acts; the order in which the responses of one world act, too.
enum class Level {
    substeps,      ///< the whole step: it runs forces and integrator several times
    accelerations, ///< in the next step, as forces between the bodies (penalty)
    velocities,    ///< at once (impulse)
    positions      ///< at once, when velocities have been changed (projection)
};

} // namespace ansatz
