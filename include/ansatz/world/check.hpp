// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences: what is wrong with a list of policies, in words, and what to write instead.
///
/// Each policy is checked in a struct of its own, so that the compiler's note ("required from CheckForce<MyDrag, ...>")
/// names the culprit; one assertion a rule, never inside a fold, where g++ hides the text. The concepts say the same
/// facts for code that must ask instead of stop.

#include <ansatz/world/concepts.hpp>

namespace ansatz::detail {

template <class P> struct CheckRole {
    static_assert(!std::is_void_v<role_of<P>>,
                  "Ansatz: unknown policy: this type names no role; give it one, e.g. `using role = ansatz::roles::Force;`");
    static_assert(std::is_void_v<role_of<P>> || known_role<role_of<P>>,
                  "Ansatz: unknown role: a policy's role is one of ansatz::roles: Space, Integrator, Force, Effect, Broadphase, "
                  "Filter, Narrowphase, Response, Observer");
    static constexpr bool ok = Policy<P>;
};

template <class I, class S> struct CheckIntegrator {
    static constexpr bool columns = DeclaresWrites<I>;
    static_assert(columns, "Ansatz: an integrator without columns; declare what it advances, e.g. "
                           "`using writes = Columns<Position, Velocity>;`");
    static constexpr bool position = !columns || contains<Position, writes_of<I>>;
    static_assert(position, "Ansatz: an integrator must advance the position; put Position into its `writes`");
    static constexpr bool verbs = !columns || !position || IntegratorIn<I, S>;
    static_assert(verbs, "Ansatz: an integrator with a wrong signature; it needs `stages` and, for every stage k, "
                         "advance(Stage<k>, written columns by reference..., scratch by reference..., a, dt), "
                         "or solve(x, v, laws, dt); without a Velocity column also mean_velocity, velocity_now and history");
    static constexpr bool ok = columns && position && verbs;
};

template <class P, class S> struct CheckForce {
    static constexpr bool columns = DeclaresReads<P>;
    static_assert(columns, "Ansatz: a force without columns; declare what it reads, e.g. `using reads = Columns<Velocity>;`, "
                           "or `Columns<>` for nothing");
    static constexpr bool binds = !columns || Binds<P, S>;
    static_assert(binds, "Ansatz: a force that cannot be bound to a space; it needs `template <class S> struct In` with a "
                         "constructor from the policy, e.g. `explicit In(const MyForce& f)`");
    static constexpr bool verbs = !columns || !binds || ForceIn<P, S>;
    static_assert(verbs, "Ansatz: a force with a wrong signature; its In<S> needs acceleration(columns..., context) that returns "
                         "S::Acceleration, or force(columns..., context) that returns S::Force, with the declared columns in "
                         "order; a force between bodies needs `couples_bodies` and couple(view, context)");
    static constexpr bool ok = columns && binds && verbs;
};

template <class E, class S> struct CheckEffect {
    static constexpr bool columns = DeclaresWrites<E>;
    static_assert(columns, "Ansatz: an effect without columns; declare what it changes, e.g. `using writes = Columns<Velocity>;`");
    static constexpr bool place = !columns || requires { { E::place } -> std::convertible_to<Place>; };
    static_assert(place, "Ansatz: an effect without a place in the step; say where it acts, e.g. "
                         "`static constexpr Place place = Place::after_integration;`");
    static constexpr bool verbs = !columns || !place || EffectIn<E, S>;
    static_assert(verbs, "Ansatz: an effect with a wrong signature; it needs `template <class S> struct In`, made from the policy, "
                         "with apply(written columns by reference..., read columns..., context)");
    static constexpr bool ok = columns && place && verbs;
};

template <class O, class S> struct CheckObserver {
    static constexpr bool ok = ObserverIn<O, S>;
    static_assert(ok, "Ansatz: an observer sees and never changes; it declares `reads` and no `writes` (an Effect may write)");
};

/// The roles whose concepts come with the collision module; here they only have to be told apart.
template <class P, class S> struct CheckNothing {
    static constexpr bool ok = true;
};

template <class P, class S> constexpr auto check_for() {
    if constexpr (PlaysRole<P, roles::Integrator>)
        return std::type_identity<CheckIntegrator<P, S>>{};
    else if constexpr (PlaysRole<P, roles::Force>)
        return std::type_identity<CheckForce<P, S>>{};
    else if constexpr (PlaysRole<P, roles::Effect>)
        return std::type_identity<CheckEffect<P, S>>{};
    else if constexpr (PlaysRole<P, roles::Observer>)
        return std::type_identity<CheckObserver<P, S>>{};
    else
        return std::type_identity<CheckNothing<P, S>>{};
}

/// A force under an integrator that solves with derivatives.
template <class P, class S> struct CheckJacobian {
    static constexpr bool ok = !PlaysRole<P, roles::Force> || DifferentiableIn<P, S>;
    static_assert(ok, "Ansatz: an implicit integrator needs the Jacobian of every force, and this one has none; give its In<S> "
                      "jacobian(columns..., context), or take an explicit integrator, e.g. SemiImplicitEuler");
};

template <bool Each, class... P> struct CheckCounts {
    static constexpr int integrators = count_of_role<roles::Integrator, P...>;
    static_assert(integrators >= 1, "Ansatz: World has no integrator; add one, e.g. SemiImplicitEuler");
    static_assert(integrators <= 1, "Ansatz: World has more than one integrator; keep exactly one, e.g. SemiImplicitEuler");
    static_assert(count_of_role<roles::Space, P...> <= 1, "Ansatz: World has more than one Space; keep one, e.g. Space<float, 2>");
    static constexpr int broadphases = count_of_role<roles::Broadphase, P...>;
    static constexpr int narrowphases = count_of_role<roles::Narrowphase, P...>;
    static constexpr int responses = count_of_role<roles::Response, P...>;
    static_assert(broadphases <= 1, "Ansatz: World has more than one broadphase; keep one, or nest them as one policy");
    static_assert(count_of_role<roles::Filter, P...> <= 1, "Ansatz: World has more than one collision filter; keep one");
    static_assert(narrowphases <= 1, "Ansatz: World has more than one narrowphase; keep one");
    static_assert(broadphases == 0 || narrowphases >= 1,
                  "Ansatz: World has a broadphase but no narrowphase to look at its pairs; add one");
    static_assert(narrowphases == 0 || broadphases >= 1,
                  "Ansatz: World has a narrowphase but no broadphase to find its pairs; add one");
    static_assert(responses == 0 || narrowphases >= 1, "Ansatz: World has a response but no narrowphase to find contacts; add one");
    static_assert(narrowphases == 0 || responses >= 1,
                  "Ansatz: World finds contacts but has no response to them; add one");
    static_assert(count_of_role<roles::Filter, P...> == 0 || broadphases >= 1,
                  "Ansatz: World has a collision filter but no broadphase whose pairs it could filter; add one");
    static_assert((0 + ... + int(puts_to_rest<P>)) <= 1, "Ansatz: World has more than one policy that puts bodies to rest; keep one");
    static constexpr bool ok = integrators == 1;
};

template <class P, class... All> constexpr int times_in = (0 + ... + int(std::same_as<P, All>));

template <class P, class... All> struct CheckOnce {
    static constexpr bool ok = times_in<P, All...> == 1;
    static_assert(ok, "Ansatz: World has the same policy twice; each type of policy stands once in the list");
};

template <class C, class... P> struct CheckTogether {
    using S = typename C::S;
    using I = typename C::Integrator;
    static constexpr bool implicit = requires { requires I::needs_jacobian; };
    static constexpr bool solving = !is_staged<I>;
    static constexpr bool differentiable = [] {
        if constexpr (implicit) return (CheckJacobian<P, S>::ok && ...);
        return true;
    }();
    static constexpr bool foreign = C::coupled && solving && !implicit;
    static_assert(!foreign, "Ansatz: this integrator advances one body by itself, but a force of this world couples bodies; take an "
                            "integrator of stages, e.g. RungeKutta4");
    static constexpr bool ok = differentiable && !foreign;
};

/// All sentences about one list of policies, in an order in which the first is the one to read.
template <class... P> struct CheckWorld {
    static constexpr bool roles_ok = (CheckRole<P>::ok && ...);
    static constexpr bool counts_ok = [] {
        if constexpr (roles_ok) return CheckCounts<true, P...>::ok && (CheckOnce<P, P...>::ok && ...);
        return false;
    }();
    static constexpr bool policies_ok = [] {
        if constexpr (counts_ok) return (decltype(check_for<P, space_of<P...>>())::type::ok && ...);
        return false;
    }();
    static constexpr bool ok = [] {
        if constexpr (policies_ok) return CheckTogether<Composition<P...>, P...>::ok;
        return false;
    }();
};

} // namespace ansatz::detail
