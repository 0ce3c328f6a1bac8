// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The role of soft bodies: what holds them together where forces do not (notes 4).

#include <ansatz/world/roles.hpp>

namespace ansatz {

namespace modules {
struct SoftBodies; // soft_bodies/module.hpp
}

namespace roles {
/// Holds the constraints of a world behind the integrator: Xpbd, VertexBlockDescent; at most one. What it holds is not
/// a force any more.
struct Solver {
    using module = modules::SoftBodies; ///< it comes with
};
} // namespace roles

} // namespace ansatz
