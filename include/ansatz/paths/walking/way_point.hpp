// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WayPoint`: a corner of a path that is walked, as `way_points` finds them on a grid and `Walk` takes them.

#include <ansatz/units.hpp>

namespace ansatz::paths {

/// A corner of a path.
struct WayPoint {
    VectorParameter<unit::Length> place; ///< m; two components will do
    /// m, how far before it the walker may leave the line towards it, and how far behind it be back on the next;
    /// zero where every bit of the corner is needed: it stops there and turns.
    Parameter<unit::Length> cut = 0.0 * metre;
};

} // namespace ansatz::paths
