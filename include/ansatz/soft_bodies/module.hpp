// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `modules::SoftBodies`: what a world has because a Solver holds its bodies together. The solver takes the step in
/// substeps of its own, in each of which forces move the bodies and constraints hold them; contacts are found and
/// answered behind all of them. Where a response takes the step in substeps (SoftSubsteps), the solver uses the same
/// ones.

#include <ansatz/motion/module.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/roles.hpp>

#include <string_view>
#include <type_traits>
#include <vector>

namespace ansatz {

namespace detail {

template <class P> struct IsSolver : std::bool_constant<PlaysRole<P, roles::Solver>> {};

template <class Q, class S> struct ConstraintTypesIn {
    using type = Types<>;
};
template <class Q, class S>
    requires requires { typename Bound<Q, S>::constraint_types; }
struct ConstraintTypesIn<Q, S> {
    using type = typename Bound<Q, S>::constraint_types;
};
template <class List, class S> struct ConstraintTypesOf;
template <class... Q, class S> struct ConstraintTypesOf<Types<Q...>, S> {
    static constexpr bool all_named = ((ConstraintTypesIn<Q, S>::type::size > 0) && ...);
    template <class List> struct Each;
    template <class... K> struct Each<Types<K...>> {
        using type = distinct<K...>;
    };
    using type = typename Each<joined_types<typename ConstraintTypesIn<Q, S>::type...>>::type;
};

template <class... P> struct SoftBodiesFacts {
    using solver = typename FirstIn<filter<IsSolver, P...>>::type; ///< the one
    template <class Q>
    struct Holds : std::bool_constant<IsCoupling<Q>::value && GivesConstraints<Q, space_of<P...>>> {};
    using held = filter<Holds, P...>; ///< the policies whose constraints it holds
    /// What they give.
    using constraint_types = typename ConstraintTypesOf<held, space_of<P...>>::type;
};

template <class... P> struct SoftBodiesCounts {
    static constexpr int solvers = count_of_role<roles::Solver, P...>;
    static constexpr bool keeps_velocity = !MotionFacts<P...>::history;
    static constexpr bool something = SoftBodiesFacts<P...>::held::size > 0;
    static constexpr bool named = ConstraintTypesOf<typename SoftBodiesFacts<P...>::held, space_of<P...>>::all_named;
    static constexpr bool ok = solvers <= 1 && keeps_velocity && something && named;
};
template <class... P> struct CheckSoftBodiesCounts {
    using Facts = SoftBodiesCounts<P...>;
    static_assert(Facts::solvers <= 1, "Ansatz: World has more than one solver; keep one, e.g. Xpbd{}");
    static_assert(
        Facts::keeps_velocity,
        "Ansatz: a solver corrects velocities with positions, and this integrator keeps a history of positions "
        "instead of a velocity; take SemiImplicitEuler or VelocityVerlet, e.g. World{SemiImplicitEuler{}, "
        "Springs{}, Xpbd{}}");
    static_assert(Facts::something || !Facts::keeps_velocity,
                  "Ansatz: World has a solver and nothing that it could hold; add Springs or Ropes, e.g. "
                  "World{SemiImplicitEuler{}, Springs{}, Xpbd{}}");
    static_assert(
        Facts::named,
        "Ansatz: a policy that gives constraints and does not say of which types; its In<S> needs e.g. `using "
        "constraint_types = Types<MyConstraint<S>>;`");
};

/// Whether a response takes the step in substeps: there is one driver of substeps in a world.
template <class C> inline constexpr bool takes_substeps = requires { requires C::substeps; };

/// The solver takes the step in substeps.
struct SolverSubsteps {
    static constexpr Phase phase = phases::substeps, until = between(phases::positions, phases::fields);
    static constexpr std::string_view name = "substeps of the solver";
    template <class StepT, class Inside> static void run(StepT& step, const Inside& inside) {
        using P = typename StepT::Composition_::solver;
        using Time = typename StepT::S::Time;
        const int parts = std::get<P>(step.policies).substeps;
        const Time h = Time(step.context.dt()) / typename StepT::S::Scalar(parts);
        PartOfStep<StepT, Inside> part(step, inside);
        for (int i = 1; i < parts; ++i) part(h);
        part.last(h);
    }
};
/// It holds the constraints behind the integrator.
struct HoldConstraints {
    static constexpr Phase phase = phases::positions;
    static constexpr std::string_view name = "constraints";
    template <class StepT> static void run(StepT& step) {
        using P = typename StepT::Composition_::solver;
        auto& kept = step.data.solver.value;
        ConstraintSystem<StepT> system(step, kept.bodies);
        const Bound<P, typename StepT::S> solver(std::get<P>(step.policies));
        system.hold([&](auto& one) { solver.solve(one, kept.own); });
    }
};

template <class P, class S> struct SolverFacts {
    static constexpr bool binds = Binds<P, S>;
    static constexpr bool ok = binds;
};
template <class P, class S> struct CheckSolver {
    static_assert(SolverFacts<P, S>::binds,
                  "Ansatz: a solver that cannot be bound to a space; it needs `template <class S> struct In` with a "
                  "constructor from the policy, e.g. `explicit In(const MySolver&)`");
};

} // namespace detail

/// What a world holds of its solver: room, no state.
/// \tparam C the world's composition
template <class C> struct SolverState {
    /// Kept between steps.
    struct Kept {
        std::vector<HeldBody<typename C::S>> bodies; ///< by slot
        typename detail::Bound<typename C::solver, typename C::S>::template Kept<typename C::constraint_types>
            own; ///< the solver's
    };
    detail::Cache<Kept> solver; ///< the room
};

namespace modules {

/// Bodies are held together by a solver.
struct SoftBodies {
    /// \cond members: the table of world/modules.hpp says what they are
    static constexpr int layer = 2;
    using stands_on = Types<Motion>;
    static constexpr bool changes_velocities = true; // behind the integration
    template <class Q, class S> static constexpr bool holds_instead = GivesConstraints<Q, S>;

    template <class... P> using Facts = detail::SoftBodiesFacts<P...>;
    template <class... P> using Counts = detail::SoftBodiesCounts<P...>;
    template <class... P> using CheckCounts = detail::CheckSoftBodiesCounts<P...>;
    template <class P, class S> using FactsOf = detail::SolverFacts<P, S>;
    template <class P, class S> using SentencesOf = detail::CheckSolver<P, S>;
    template <class P, class S> using needs = Columns<Position, Velocity, InverseMass, HeldAcceleration>;

    template <class C, class Data> using State = SolverState<C>;
    template <class C>
    using systems = std::conditional_t<detail::takes_substeps<C>, Types<detail::HoldConstraints>,
                                       Types<detail::SolverSubsteps, detail::HoldConstraints>>;
    /// \endcond
};

} // namespace modules
} // namespace ansatz
