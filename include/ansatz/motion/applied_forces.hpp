// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `AppliedForces`: forces from your program, through `World::apply_force` (notes 1.2).
///
/// Use it for engines, explosions and fingers: what is applied between two steps acts through every stage of the next
/// step, then is gone. Not for a law that can be written down: that is a Force policy, which cannot be forgotten. Costs
/// one vector for each body.

#include <ansatz/world/concepts.hpp>

namespace ansatz {

/// \f$ \mathbf F = \sum \mathbf F_{applied} \f$, the resultant of what was applied (Newton's second law sums vectors).
struct AppliedForces {
    using role = roles::Force;
    using reads = Columns<AppliedForce>;

    template <class S> struct In {
        explicit In(const AppliedForces&) {}
        [[gnu::always_inline]] typename S::Force force(const typename S::Force& applied, const auto&) const {
            return applied;
        }
    };
};

} // namespace ansatz
