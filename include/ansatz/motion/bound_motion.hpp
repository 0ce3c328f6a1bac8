// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BoundMotion`: the forces and effects of a world, bound to its space and prepared once for each part of a step.

#include <ansatz/motion/facts.hpp>
#include <ansatz/world/context.hpp>

#include <tuple>

namespace ansatz {

/// The forces and effects of a world, bound to its space.
template <class C> struct BoundMotion {
    /// The space.
    using S = typename C::S;
    typename C::Laws laws;                                        ///< the forces
    typename C::template Effects<Place::before_forces> before;    ///< the effects before the integrator
    typename C::template Effects<Place::after_integration> after; ///< those after it
    typename C::template Effects<Place::end_of_step> end;         ///< those at the end of the step

    /// Binds a world's policies.
    template <class Policies> static BoundMotion from(const Policies& policies) {
        return {bind<typename C::Laws>(policies, typename C::laws{}),
                bind<typename C::template Effects<Place::before_forces>>(
                    policies, typename C::template effects<Place::before_forces>{}),
                bind<typename C::template Effects<Place::after_integration>>(
                    policies, typename C::template effects<Place::after_integration>{}),
                bind<typename C::template Effects<Place::end_of_step>>(
                    policies, typename C::template effects<Place::end_of_step>{})};
    }
    /// What can be computed once for all bodies.
    void prepare(const Context<S>& context) {
        laws.prepare(context);
        before.prepare(context);
        after.prepare(context);
        end.prepare(context);
    }

private:
    template <class To, class Policies, class... Q> static To bind(const Policies& policies, Types<Q...>) {
        return To(std::get<Q>(policies)...);
    }
};

} // namespace ansatz
