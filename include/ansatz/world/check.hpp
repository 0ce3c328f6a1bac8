// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The sentences: what is wrong with a list of policies, in words, and what to write instead.
///
/// Each policy is checked in a struct of its own, so that the compiler's note ("required from CheckForce<MyDrag, ...>")
/// names the culprit; one assertion a rule, never inside a fold, where g++ hides the text. The facts stand apart from
/// the sentences, because a struct whose assertion failed is no constant for clang any more, and a page of errors would
/// follow the one to read. The concepts say the same facts for code that must ask instead of stop.

#include <ansatz/world/concepts.hpp>

#include <string_view>

namespace ansatz::detail {

/// Makes the compiler look at the sentences of `Check...`.
template <class... Check> inline constexpr bool read_sentences = ((sizeof(Check) > 0) && ... && true);

template <class P> struct RoleFacts {
    static constexpr bool named = !std::is_void_v<role_of<P>>;
    static constexpr bool known = !named || known_role<role_of<P>>;
    static constexpr bool check = !names_check<P> || HasCheck<P>;
    static constexpr bool ok = named && known && check;
};
template <class P> struct CheckRole {
    static_assert(
        RoleFacts<P>::named,
        "Ansatz: unknown policy: this type names no role; give it one, e.g. `using role = ansatz::roles::Force;`");
    static_assert(
        RoleFacts<P>::known,
        "Ansatz: unknown role: a policy's role is one of ansatz::roles: Space, Integrator, Force, Effect, Broadphase, "
        "Filter, Narrowphase, Response, StepControl, Observer");
    static_assert(RoleFacts<P>::check,
                  "Ansatz: a policy whose check the world cannot call; write `void check() const`");
};

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

template <class O, class S> struct ObserverFacts {
    static constexpr bool writes_nothing = writes_of<O>::size == 0;
    static constexpr bool observe = !writes_nothing || ObserverIn<O, S>;
    static constexpr bool ok = writes_nothing && observe;
};
template <class O, class S> struct CheckObserver {
    using Facts = ObserverFacts<O, S>;
    static_assert(
        Facts::writes_nothing,
        "Ansatz: an observer sees and never changes; it declares `reads` and no `writes` (an Effect may write)");
    static_assert(Facts::observe,
                  "Ansatz: an observer whose observe the world cannot call; write `void observe(const auto& view)`");
};

struct NoFacts {
    static constexpr bool ok = true;
};
struct CheckNothing {};

/// What is looked at in the roles that come with the module of collisions, which says it there (collision/check.hpp).
/// Without that module nothing can be said about them, or done with them.
template <class Role> struct ChecksOfRole {
    template <class P, class S> struct Facts {
        static constexpr bool ok = false;
    };
    template <class P, class S> struct Sentences {
        static_assert(
            Facts<P, S>::ok,
            "Ansatz: broadphases, filters, narrowphases and responses need the module that they belong to; add "
            "#include <ansatz/collision.hpp>");
    };
};
template <class Role>
inline constexpr bool of_collisions = std::same_as<Role, roles::Broadphase> || std::same_as<Role, roles::Filter> ||
                                      std::same_as<Role, roles::Narrowphase> || std::same_as<Role, roles::Response>;

template <class F, class C> struct FactsAndSentences {
    using Facts = F;
    using Sentences = C;
};
template <class P, class S> struct FactsOfCollisions {
    using Facts = typename ChecksOfRole<role_of<P>>::template Facts<P, S>;
    /// Named only when they are read.
    struct Sentences : ChecksOfRole<role_of<P>>::template Sentences<P, S> {};
};
template <class P, class S> constexpr auto check_for() {
    if constexpr (PlaysRole<P, roles::Integrator>)
        return std::type_identity<FactsAndSentences<IntegratorFacts<P, S>, CheckIntegrator<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Force>)
        return std::type_identity<FactsAndSentences<ForceFacts<P, S>, CheckForce<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Effect>)
        return std::type_identity<FactsAndSentences<EffectFacts<P, S>, CheckEffect<P, S>>>{};
    else if constexpr (PlaysRole<P, roles::Observer>)
        return std::type_identity<FactsAndSentences<ObserverFacts<P, S>, CheckObserver<P, S>>>{};
    else if constexpr (of_collisions<role_of<P>>) return std::type_identity<FactsOfCollisions<P, S>>{};
    else return std::type_identity<FactsAndSentences<NoFacts, CheckNothing>>{};
}
template <class P, class S> using FactsFor = typename decltype(check_for<P, S>())::type::Facts;
template <class P, class S> using CheckFor = typename decltype(check_for<P, S>())::type::Sentences;

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

template <class... P> struct CountFacts {
    static constexpr int integrators = count_of_role<roles::Integrator, P...>;
    static constexpr int spaces = count_of_role<roles::Space, P...>;
    static constexpr int broadphases = count_of_role<roles::Broadphase, P...>;
    static constexpr int filters = count_of_role<roles::Filter, P...>;
    static constexpr int narrowphases = count_of_role<roles::Narrowphase, P...>;
    static constexpr int responses = count_of_role<roles::Response, P...>;
    static constexpr int in_substeps = (0 + ... + int(RespondsAt<Level::substeps>::template here<P>()));
    static constexpr int in_next_step = (0 + ... + int(RespondsAt<Level::accelerations>::template here<P>()));
    static constexpr int at_velocities = (0 + ... + int(RespondsAt<Level::velocities>::template here<P>()));
    static constexpr bool acting = in_substeps <= 1 && (in_substeps == 0 || (in_next_step == 0 && at_velocities == 0));
    static constexpr int controls = count_of_role<roles::StepControl, P...>;
    static constexpr int resters = (0 + ... + int(puts_to_rest<P>));
    static constexpr int data = (0 + ... + int(is_datum<P>));
    static constexpr bool ok = integrators == 1 && spaces <= 1 && broadphases <= 1 && filters <= 1 &&
                               narrowphases == broadphases && (responses >= 1) == (narrowphases == 1) &&
                               filters <= broadphases && acting && resters <= 1 && controls <= 1 && data <= 1;
};
template <class... P> struct CheckCounts {
    using Facts = CountFacts<P...>;
    static_assert(Facts::integrators >= 1, "Ansatz: World has no integrator; add one, e.g. SemiImplicitEuler");
    static_assert(Facts::integrators <= 1,
                  "Ansatz: World has more than one integrator; keep exactly one, e.g. SemiImplicitEuler");
    static_assert(Facts::spaces <= 1, "Ansatz: World has more than one Space; keep one, e.g. Space<float, 2>");
    static_assert(Facts::broadphases <= 1,
                  "Ansatz: World has more than one broadphase; keep one, or nest them as one policy");
    static_assert(Facts::filters <= 1, "Ansatz: World has more than one collision filter; keep one");
    static_assert(Facts::narrowphases <= 1, "Ansatz: World has more than one narrowphase; keep one");
    static_assert(Facts::broadphases == 0 || Facts::narrowphases >= 1,
                  "Ansatz: World has a broadphase but no narrowphase to look at its pairs; add one");
    static_assert(Facts::narrowphases == 0 || Facts::broadphases >= 1,
                  "Ansatz: World has a narrowphase but no broadphase to find its pairs; add one");
    static_assert(Facts::responses == 0 || Facts::narrowphases >= 1,
                  "Ansatz: World has a response but no narrowphase to find contacts; add one");
    static_assert(Facts::narrowphases == 0 || Facts::responses >= 1,
                  "Ansatz: World finds contacts but has no response to them; add one");
    static_assert(Facts::filters == 0 || Facts::broadphases >= 1,
                  "Ansatz: World has a collision filter but no broadphase whose pairs it could filter; add one");
    static_assert(
        Facts::in_substeps <= 1,
        "Ansatz: World has more than one response that takes a step in parts; keep one, e.g. SoftSubsteps<Friction>{}");
    static_assert(Facts::in_substeps == 0 || Facts::in_next_step == 0,
                  "Ansatz: World has a response that takes a step in parts (SoftSubsteps) and one whose contacts are "
                  "forces of the next step (Penalty), which "
                  "would hold the same bodies twice; keep one of the two");
    static_assert(Facts::in_substeps == 0 || Facts::at_velocities == 0,
                  "Ansatz: World has a response that takes a step in parts (SoftSubsteps) and one that changes "
                  "velocities at its end (Impulse), which would "
                  "answer the same contacts twice; keep one of the two");
    static_assert(Facts::resters <= 1, "Ansatz: World has more than one policy that puts bodies to rest; keep one");
    static_assert(
        Facts::controls <= 1,
        "Ansatz: World has more than one policy that decides how a step is taken; keep one, e.g. StepLimit<Divide>{}");
    static_assert(Facts::data <= 1,
                  "Ansatz: World has more than one Datum; keep one, e.g. of a struct that holds them all");
};

template <class P, class... All> inline constexpr bool stands_once = (0 + ... + int(std::same_as<P, All>)) == 1;
template <class P, class... All> struct CheckOnce {
    static_assert(stands_once<P, All...>,
                  "Ansatz: World has the same policy twice; each type of policy stands once in the list");
};

template <class... C> constexpr bool names_differ(Columns<C...>) {
    auto times = [](std::string_view name) { return (0 + ... + int(C::name == name)); };
    return ((times(C::name) == 1) && ...);
}

/// Two policies of one name would be one in a saved file.
template <class P> constexpr std::string_view name_or_none() {
    if constexpr (requires { std::string_view(P::name); }) return P::name;
    return {};
}
template <class... P> constexpr bool policies_named_apart() {
    [[maybe_unused]] auto times = [](std::string_view name) { return (0 + ... + int(name_or_none<P>() == name)); };
    return ((name_or_none<P>().empty() || times(name_or_none<P>()) == 1) && ...);
}

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

template <class... P> struct TogetherFacts {
    using S = space_of<P...>;
    using I = typename Composition<P...>::Integrator;
    static constexpr bool implicit = requires { requires I::needs_jacobian; };
    static constexpr bool differentiable = !implicit || (has_jacobian<P, S> && ...);
    static constexpr bool apart = solves_together<I, S> || is_staged<I> || !Composition<P...>::coupled;
    static constexpr bool solver = !Composition<P...>::together || solver_is_here<I, S>;
    static constexpr bool named = names_differ(typename Composition<P...>::needed{});
    static constexpr bool policies_named = policies_named_apart<P...>();
    static constexpr bool ok = differentiable && apart && solver && named && policies_named;
};
template <class... P> struct CheckTogether {
    static_assert(TogetherFacts<P...>::apart,
                  "Ansatz: this integrator advances one body by itself, but a force of this world couples bodies; "
                  "take an integrator of stages, e.g. RungeKutta4");
    static_assert(
        TogetherFacts<P...>::solver,
        "Ansatz: where forces couple bodies, an implicit integrator solves one system for all of them, and its "
        "solver is not included; add #include <ansatz/motion/integrators/conjugate_gradient.hpp> for "
        "ImplicitEuler, <ansatz/motion/integrators/cholesky.hpp> for ImplicitEulerBy<Cholesky>");
    static_assert(TogetherFacts<P...>::named,
                  "Ansatz: two columns of this world have the same name, by which they are saved and hashed; give "
                  "each its own `static constexpr std::string_view name`");
    static_assert(TogetherFacts<P...>::policies_named,
                  "Ansatz: two policies of this world have the same name, by which they are saved; give "
                  "each its own `static constexpr std::string_view name`");
};

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

/// All sentences about one list of policies, in an order in which the first is the one to read.
template <class... P> constexpr bool check_world() {
    using S = space_of<P...>;
    if constexpr (!(RoleFacts<P>::ok && ...)) return !read_sentences<CheckRole<P>...>;
    else if constexpr (!CountFacts<P...>::ok) return !read_sentences<CheckCounts<P...>>;
    else if constexpr (!(stands_once<P, P...> && ...)) return !read_sentences<CheckOnce<P, P...>...>;
    else if constexpr (!(FactsFor<P, S>::ok && ...)) return !read_sentences<CheckFor<P, S>...>;
    else if constexpr (!TogetherFacts<P...>::differentiable) return !read_sentences<CheckJacobian<P, S>...>;
    else if constexpr (!(observable<P, typename Composition<P...>::Integrator> && ...))
        return !read_sentences<CheckObservable<P, typename Composition<P...>::Integrator>...>;
    else if constexpr (!TogetherFacts<P...>::ok) return !read_sentences<CheckTogether<P...>>;
    else return true;
}
template <class... P> inline constexpr bool is_world = check_world<P...>();

/// A list that is no world is taken for an empty one, so that only the sentence is read.
template <bool IsWorld, class... P> struct ComposedOf {
    using type = Composition<P...>;
};
template <class... P> struct ComposedOf<false, P...> {
    using type = Composition<NoIntegrator>;
};

} // namespace ansatz::detail
