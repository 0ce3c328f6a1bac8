// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `AppliedForces`: forces from your program, through `World::apply_force` (notes 1.2).
///
/// Use it for engines, explosions and fingers: what is applied between two steps acts through every stage of the next
/// step, then is gone. Not for a law that can be written down: that is a Force policy, which cannot be forgotten. Costs
/// one vector for each body.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/world/checked_value.hpp>
#include <ansatz/world/inside.hpp>

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

    /// What a world with this policy has beside its other members.
    template <class W, class C> class Door {
    public:
        /// Adds to the force (in N) that acts during the next step, in every stage of it. A body of infinite mass does
        /// not notice.
        /// \throws std::out_of_range for a stale handle, std::invalid_argument for a force that is not finite
        template <class Q> void apply_force(Handle body, const Q& f) {
            auto& world = static_cast<W&>(*this);
            const auto inside = detail::Key::inside(world);
            auto& lanes = inside.data.lanes;
            const auto slot = inside.data.bodies.slot(body, "World::apply_force");
            detail::Key::get_ready(world, "World::apply_force");
            const auto force = detail::finite_vector<typename C::S, unit::Force>("World::apply_force", "force", f);
            if (!(lanes.template get<InverseMass>(slot).value() > typename C::S::Scalar(0))) return;
            const auto total = lanes.template get<AppliedForce>(slot) + force;
            if (!is_finite(total))
                refuse_value("World::apply_force", "force", f, "the sum of the forces applied is finite");
            // The velocity now is what it was before the force; the history begins anew with both.
            inside.template tell<hook::HoldVelocity>(slot);
            if constexpr (C::history) // forces see the velocity that is held now
                inside.template tell<hook::BeforeChange<Velocity>>();
            inside.template tell<hook::BeforeChange<AppliedForce>>();
            lanes.template set<AppliedForce>(slot, total);
            inside.template tell<hook::Wake>(slot);
        }
    };
};

} // namespace ansatz
