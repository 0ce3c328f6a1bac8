// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences about the roles of motion: what is wrong with an integrator, a force, an effect, or with a list of
/// them; and what to write instead. world/check.hpp asks for them, and says how they are made.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/world/check.hpp>

namespace ansatz::detail {

template <class I, class S> struct IntegratorFacts {
    static constexpr bool columns = DeclaresWrites<I>;
    static constexpr bool position = !columns || contains<Position, writes_of<I>>;
    static constexpr bool references = !columns || !position || !copies_what_it_advances<I, S>();
    static constexpr bool verbs = !columns || !position || !references || IntegratorIn<I, S>;
    static constexpr bool ok = columns && position && references && verbs;
};
template <class I, class S> struct CheckIntegrator {
    using Facts = IntegratorFacts<I, S>;
    static_assert(Facts::columns, "Ansatz: an integrator without columns; declare what it advances, e.g. "
                                  "`using writes = Columns<Position, Velocity>;`");
    static_assert(Facts::position, "Ansatz: an integrator must advance the position; put Position into its `writes`");
    static_assert(Facts::references,
                  "Ansatz: an integrator cannot change what it declares to change, because it takes it by value or by "
                  "const reference; write e.g. advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt)");
    static_assert(Facts::verbs,
                  "Ansatz: an integrator with a wrong signature; it needs `stages` and, for every stage k, "
                  "advance(Stage<k>, written columns by reference..., scratch by reference..., a, dt), "
                  "or solve(x, v, laws, dt); without a Velocity column also mean_velocity, velocity_now and history");
};

template <class P, class S> struct ForceFacts {
    static constexpr bool columns = DeclaresReads<P>;
    static constexpr bool binds = !columns || Binds<P, S>;
    static constexpr bool prepare = !columns || !binds || PreparesIn<P, S>;
    static constexpr bool answer = !columns || !binds || !answers_wrongly<P, S>();
    static constexpr bool verbs = !columns || !binds || !prepare || !answer || ForceIn<P, S>;
    static constexpr bool ok = columns && binds && prepare && answer && verbs;
};
template <class P, class S> struct CheckForce {
    using Facts = ForceFacts<P, S>;
    static_assert(Facts::columns,
                  "Ansatz: a force without columns; declare what it reads, e.g. `using reads = Columns<Velocity>;`, "
                  "or `Columns<>` for nothing");
    static_assert(Facts::binds,
                  "Ansatz: a force that cannot be bound to a space; it needs `template <class S> struct In` with a "
                  "constructor from the policy, e.g. `explicit In(const MyForce& f)`");
    static_assert(Facts::prepare,
                  "Ansatz: a policy whose prepare the world cannot call; write `void prepare(const auto& context)`");
    static_assert(
        Facts::answer,
        "Ansatz: a force that answers with another quantity; acceleration(...) returns S::Acceleration (m/s^2), "
        "force(...) returns S::Force (N), in the scalar and dimension of S");
    static_assert(
        Facts::verbs,
        "Ansatz: a force with a wrong signature; its In<S> needs acceleration(columns..., context) that returns "
        "S::Acceleration, or force(columns..., context) that returns S::Force, with the declared columns in "
        "order; a force between bodies needs `couples_bodies` and couple(view, context)");
};

template <class D, class S> struct DegreeFacts {
    static constexpr bool columns = NamesDegree<D>;
    static constexpr bool binds = !columns || Binds<D, S>;
    static constexpr bool prepare = !columns || !binds || PreparesIn<D, S>;
    static constexpr bool verbs = !columns || !binds || !prepare || accelerates<D, S>();
    static constexpr bool moves = !columns || !binds || !prepare || !verbs || DegreeOfFreedomIn<D, S>;
    static constexpr bool ok = columns && binds && prepare && verbs && moves;
};
template <class D, class S> struct CheckDegree {
    using Facts = DegreeFacts<D, S>;
    static_assert(Facts::columns, "Ansatz: a degree of freedom names the columns that stand for position and velocity; "
                                  "e.g. `using position = Orientation; using velocity = AngularVelocity;`");
    static_assert(Facts::binds,
                  "Ansatz: a degree of freedom that cannot be bound to a space; it needs `template <class S> struct "
                  "In` with a constructor from the policy, e.g. `explicit In(const Turning& t)`");
    static_assert(Facts::prepare,
                  "Ansatz: a policy whose prepare the world cannot call; write `void prepare(const auto& context)`");
    static_assert(Facts::verbs, "Ansatz: a degree of freedom with a wrong signature; its In<S> needs "
                                "acceleration(position, velocity, read columns..., context)");
    static_assert(Facts::moves, "Ansatz: a degree of freedom whose columns do not go together; integrators write x + v "
                                "* dt, x += v * dt, v + a * dt and v += a * dt with its position x, its velocity v and "
                                "what its acceleration answers");
};

template <class E, class S> struct EffectFacts {
    static constexpr bool columns = DeclaresWrites<E>;
    static constexpr bool place = !columns || HasPlace<E>;
    static constexpr bool prepare = !columns || !place || !Binds<E, S> || PreparesIn<E, S>;
    static constexpr bool references = !columns || !place || !copies_what_it_changes<E, S>(writes_of<E>{});
    static constexpr bool verbs = !columns || !place || !prepare || !references || EffectIn<E, S>;
    static constexpr bool ok = columns && place && prepare && references && verbs;
};
template <class E, class S> struct CheckEffect {
    using Facts = EffectFacts<E, S>;
    static_assert(
        Facts::columns,
        "Ansatz: an effect without columns; declare what it changes, e.g. `using writes = Columns<Velocity>;`");
    static_assert(Facts::place, "Ansatz: an effect without a place in the step; say where it acts, e.g. "
                                "`static constexpr Place place = Place::after_integration;`");
    static_assert(Facts::prepare,
                  "Ansatz: a policy whose prepare the world cannot call; write `void prepare(const auto& context)`");
    static_assert(
        Facts::references,
        "Ansatz: an effect cannot change what it declares to change, because it takes it by value or by const "
        "reference; write e.g. apply(typename S::Velocity& v, const auto& context)");
    static_assert(
        Facts::verbs,
        "Ansatz: an effect with a wrong signature; it needs `template <class S> struct In`, made from the policy, "
        "with apply(written columns by reference..., read columns..., context)");
};

template <class... P> struct MotionCounts {
    static constexpr int integrators = count_of_role<roles::Integrator, P...>;
    static constexpr int resters = (0 + ... + int(puts_to_rest<P>));
    static constexpr bool ok = integrators == 1 && resters <= 1;
};
template <class... P> struct CheckMotionCounts {
    using Facts = MotionCounts<P...>;
    static_assert(Facts::integrators >= 1, "Ansatz: World has no integrator; add one, e.g. SemiImplicitEuler");
    static_assert(Facts::integrators <= 1,
                  "Ansatz: World has more than one integrator; keep exactly one, e.g. SemiImplicitEuler");
    static_assert(Facts::resters <= 1, "Ansatz: World has more than one policy that puts bodies to rest; keep one");
};

template <class P, class S> constexpr auto check_of_motion() {
    if constexpr (PlaysRole<P, roles::Integrator>)
        return std::type_identity<FactsAndSentences<IntegratorFacts<P, S>, CheckIntegrator<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Force>)
        return std::type_identity<FactsAndSentences<ForceFacts<P, S>, CheckForce<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::DegreeOfFreedom>)
        return std::type_identity<FactsAndSentences<DegreeFacts<P, S>, CheckDegree<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Effect>)
        return std::type_identity<FactsAndSentences<EffectFacts<P, S>, CheckEffect<P, S>>>{};
    else return std::type_identity<FactsAndSentences<NoFacts, CheckNothing>>{}; // its systems are checked below
}

/// A force under an integrator that solves with derivatives.
template <class P, class S>
inline constexpr bool has_jacobian =
    !(PlaysRole<P, roles::Force> || couples_bodies<P>) || DifferentiableIn<P, S> || DifferentiableCouplingIn<P, S>;
template <class P, class S> struct CheckJacobian {
    static_assert(has_jacobian<P, S> || !IsCoupling<P>::value,
                  "Ansatz: an implicit integrator needs the Jacobian of every force, and this one has none "
                  "that can be used: where it couples bodies, give its In<S> jacobian(view, context, add) "
                  "and stiffnesses(view, f), or take an explicit integrator, e.g. SemiImplicitEuler");
    static_assert(has_jacobian<P, S> || IsCoupling<P>::value,
                  "Ansatz: an implicit integrator needs the Jacobian of every force, and this one has none; give its "
                  "In<S> jacobian(columns..., context), or take an explicit integrator, e.g. SemiImplicitEuler");
};

/// Whether what an integrator needs to advance all bodies together is more than a name.
template <class I> inline constexpr bool linear_solver_is_here = true;
template <class I>
    requires requires { typename I::linear_solver; }
inline constexpr bool linear_solver_is_here<I> = requires { sizeof(typename I::linear_solver); };
template <class I, class S> constexpr bool solver_is_there() {
    if constexpr (linear_solver_is_here<I>) return requires { sizeof(typename I::template Together<S>); };
    return false;
}
template <class I, class S> inline constexpr bool solver_is_here = solver_is_there<I, S>();

/// An observer that asks for the velocity under an integrator that keeps none.
template <class P, class I>
inline constexpr bool observable =
    !PlaysRole<P, roles::Observer> || !derives_velocity<I> || !contains<Velocity, reads_of<P>>;
template <class P, class I> struct CheckObservable {
    static_assert(
        observable<P, I>,
        "Ansatz: an observer reads Velocity, but this integrator keeps the history of positions and no velocity; "
        "ask world.velocity(body) between the steps, or take VelocityVerlet");
};

template <class... P> struct TogetherFacts {
    using S = space_of<P...>;
    using I = typename Composition<P...>::Integrator;
    static constexpr bool implicit = requires { requires I::needs_jacobian; };
    static constexpr bool differentiable = !implicit || (has_jacobian<P, S> && ...);
    static constexpr bool apart = solves_together<I, S> || is_staged<I> || !Composition<P...>::coupled;
    static constexpr bool solver = !Composition<P...>::together || solver_is_here<I, S>;
    static constexpr bool degrees = Composition<P...>::Degrees::empty || (is_staged<I> && !derives_velocity<I>);
    static constexpr bool rows = !(gives_rows<P, S> || ...) || solves_rows<P...>(modules_of<P...>{});
    static constexpr bool ok = differentiable && apart && solver && degrees && rows && (observable<P, I> && ...);
};
template <class... P> struct CheckTogether {
    static_assert(TogetherFacts<P...>::apart,
                  "Ansatz: this integrator advances one body by itself, but a force of this world couples bodies; "
                  "take an integrator of stages, e.g. RungeKutta4");
    static_assert(TogetherFacts<P...>::rows,
                  "Ansatz: a policy gives rows of joints, and nothing in this world solves them; take SoftSubsteps as "
                  "its response, with a broadphase and a Narrowphase, e.g. SortAndSweep{}, Narrowphase<Sphere>{}");
    static_assert(TogetherFacts<P...>::degrees,
                  "Ansatz: this integrator advances translation alone, because it keeps a history of positions or "
                  "solves for them; beside a degree of freedom take one of stages that keeps a velocity, e.g. "
                  "SemiImplicitEuler or RungeKutta4");
    static_assert(
        TogetherFacts<P...>::solver,
        "Ansatz: where forces couple bodies, an implicit integrator solves one system for all of them, and its "
        "solver is not included; add #include <ansatz/motion/integrators/conjugate_gradient.hpp> for "
        "ImplicitEuler, <ansatz/motion/integrators/cholesky.hpp> for ImplicitEulerBy<Cholesky>, "
        "<ansatz/motion/integrators/matrix_free.hpp> for ImplicitEulerBy<MatrixFree>");
};

/// The sentences about an integrator and the other policies of its world, the first one to read first.
template <class... P> constexpr bool read_together_in_motion() {
    using S = space_of<P...>;
    using I = typename Composition<P...>::Integrator;
    if constexpr (!TogetherFacts<P...>::differentiable) return read_sentences<CheckJacobian<P, S>...>;
    else if constexpr (!(observable<P, I> && ...)) return read_sentences<CheckObservable<P, I>...>;
    else return read_sentences<CheckTogether<P...>>;
}

} // namespace ansatz::detail
