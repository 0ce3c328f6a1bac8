// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The roles of water in a world: what advances with the step and holds no body, and what carries bodies in it.

#include <ansatz/world/roles.hpp>

namespace ansatz {

namespace modules {
struct Water; // water/module.hpp
}

namespace roles {
/// A field of its own that advances with the step: Pools; any number.
struct Field {
    using module = modules::Water; ///< it comes with
};
/// Water carries bodies: Buoyancy; at most one.
struct Buoyancy {
    using module = modules::Water; ///< it comes with
};
} // namespace roles

} // namespace ansatz
