// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BoundMotion`: the integrator, the forces and the effects of a world, bound to its space and prepared once for each
/// substep.

#include <ansatz/motion/facts.hpp>
#include <ansatz/motion/integration.hpp>
#include <ansatz/world/context.hpp>

#include <tuple>

namespace ansatz {

/// The integrator, the forces and the effects of a world, bound to its space.
template <class C> struct BoundMotion {
    /// The space.
    using S = typename C::S;
    [[no_unique_address]] detail::BoundIntegrator<typename C::Integrator, S> integrator; ///< the integrator
    typename C::Laws laws;                                                               ///< the forces
    [[no_unique_address]] typename C::Degrees degrees;            ///< what is advanced beside translation
    typename C::template Effects<Place::before_forces> before;    ///< the effects before the integrator
    typename C::template Effects<Place::after_integration> after; ///< those after it
    typename C::template Effects<Place::end_of_step> end;         ///< those at the end of the step

    /// Binds a world's policies.
    template <class Policies> static BoundMotion from(const Policies& policies) {
        return {bind_integrator(policies),
                bind<typename C::Laws>(policies, typename C::laws{}),
                bind<typename C::Degrees>(policies, typename C::degrees{}),
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
        if constexpr (!C::Degrees::empty) degrees.prepare(context);
        before.prepare(context);
        after.prepare(context);
        end.prepare(context);
    }

private:
    /// A world without an integrator has a stand-in for one.
    template <class Policies> static auto bind_integrator([[maybe_unused]] const Policies& policies) {
        using I = typename C::Integrator;
        if constexpr (PlaysRole<I, roles::Integrator>) return detail::BoundIntegrator<I, S>(std::get<I>(policies));
        else return detail::BoundIntegrator<I, S>();
    }
    template <class To, class Policies, class... Q> static To bind(const Policies& policies, Types<Q...>) {
        return To(std::get<Q>(policies)...);
    }
};

} // namespace ansatz
