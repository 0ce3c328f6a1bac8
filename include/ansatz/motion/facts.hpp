// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What follows from a list of policies for the motion of bodies: which integrator, which forces act on one body and
/// which couple bodies, which effects act where, and the columns that a world stores because of how they are run.

#include <ansatz/motion/degrees_of_freedom.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/world/elements.hpp>
#include <ansatz/world/modules.hpp>

#include <type_traits>

namespace ansatz {

namespace detail {

/// Takes the place of an integrator that is missing, so that only the sentence about it is seen.
struct NoIntegrator {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto&, auto&, const auto&, const auto&) {}
};

template <class P> inline constexpr bool couples_bodies = requires { requires P::couples_bodies; };
template <class P> inline constexpr bool puts_to_rest = requires { requires P::puts_to_rest; };

template <class P> struct IsIntegrator : std::bool_constant<PlaysRole<P, roles::Integrator>> {};
/// A policy of another module's role may couple bodies, too: contacts that are forces of the next step.
template <class P> struct IsCoupling : std::bool_constant<couples_bodies<P>> {};
template <class P> struct IsDegree : std::bool_constant<PlaysRole<P, roles::DegreeOfFreedom>> {};
template <class P> struct IsLaw : std::bool_constant<PlaysRole<P, roles::Force> && !couples_bodies<P>> {};
/// What an integrator keeps that advances all bodies together.
template <class I, class S> inline constexpr bool solves_together = requires { typename I::template Together<S>; };

template <class S> struct BreaksIn {
    template <class P> struct Is : std::bool_constant < keeps_state<P, S>&& requires {
        requires P::breaks;
    } > {};
};
template <class P> struct IsRester : std::bool_constant<puts_to_rest<P>> {};

/// When an effect acts among those of its place: turn 0 unless it says otherwise, up to 2.
template <class P> constexpr int turn_of() {
    if constexpr (requires { P::turn; }) return P::turn;
    return 0;
}
template <int Turn> struct HasTurn {
    template <class P> struct Is : std::bool_constant<turn_of<P>() == Turn> {};
};
template <class List> struct InTurn;
template <class... E> struct InTurn<Types<E...>> {
    static_assert(((turn_of<E>() >= 0 && turn_of<E>() <= 2) && ...), "Ansatz: an effect's turn is 0, 1 or 2");
    using type = joined_types<filter<HasTurn<0>::Is, E...>, filter<HasTurn<1>::Is, E...>, filter<HasTurn<2>::Is, E...>>;
};

/// \tparam Late whether bodies are put to sleep behind what a module does after the integration
template <Place At, bool Late = false> struct EffectAt {
    template <class P> static constexpr bool here() {
        if constexpr (Late && puts_to_rest<P>) return false;
        if constexpr (PlaysRole<P, roles::Effect> && requires { P::place; }) return P::place == At;
        return false;
    }
    template <class P> struct Is : std::bool_constant<here<P>()> {};
};

/// An effect that also acts on bodies that are `moving`; the others act on awake bodies only.
template <class P> struct IsOnPlatforms : std::bool_constant < EffectAt<Place::before_forces>::here<P>() && requires {
    requires P::on_platforms;
} > {};

/// An effect of the whole step, which the later substeps of a divided one leave alone.
template <class P> struct IsOfEveryPart : std::bool_constant < !requires {
    requires P::once_a_step;
} > {};
template <class List> struct InEveryPart;
template <class... P> struct InEveryPart<Types<P...>> {
    using type = filter<IsOfEveryPart, P...>;
};

/// What evaluating a policy of motion needs: what it declared, and the mass where a force must become an acceleration.
template <class P, class S> constexpr auto needs_in_motion() {
    if constexpr (IsCoupling<P>::value) return union_of<reads_of<P>, Columns<CoupledForce, InverseMass>>{};
    else if constexpr (IsLaw<P>::value) return needs_of_law<P, S>{};
    else if constexpr (IsDegree<P>::value) return union_of<columns_of_degree<P>, reads_of<P>>{};
    else return union_of<writes_of<P>, reads_of<P>>{};
}
/// Systems of policies: motion/policy_systems.hpp.
template <class P, class S> struct SystemsOfPolicy;

/// Whether a policy leaves a motion that can be run backwards: an integrator says so itself; a force must depend
/// neither on the velocity nor on the time; whatever else there is must not touch the state of motion.
template <class P> constexpr bool keeps_reversible() {
    if constexpr (PlaysRole<P, roles::Integrator>) return requires { requires P::reversible; };
    else if constexpr (PlaysRole<P, roles::Force>)
        return intersection_of<reads_of<P>, Columns<Velocity, Clock>>::size == 0;
    else if constexpr (IsDegree<P>::value) return false; // its law may be one of its velocity
    else return difference_of<writes_of<P>, Columns<DrawnPosition>>::size == 0;
}

template <class S, class List> struct LawsFrom;
template <class S, class... P> struct LawsFrom<S, Types<P...>> {
    using type = Laws<S, P...>;
};
template <class S, class List> struct EffectsFrom;
template <class S, class... P> struct EffectsFrom<S, Types<P...>> {
    using type = Effects<S, P...>;
};

template <class S, class List> struct DegreesFrom {
    using type = NoDegrees;
};
template <class S, class First, class... P> struct DegreesFrom<S, Types<First, P...>> {
    using type = DegreesOfFreedom<S, false, First, P...>;
};

template <class I, class List> struct OrElse {
    using type = typename FirstIn<List>::type;
};
template <class I> struct OrElse<I, Types<>> {
    using type = I;
};

/// Whether a module of these policies says that it relates bodies to each other, so that they sleep and wake together.
template <class M> inline constexpr bool says_relates = requires { requires M::relates_bodies; };
template <class... M> constexpr bool relates_bodies(Types<M...>) { return (says_relates<M> || ...); }
/// Whether a module of these policies changes velocities behind the integration.
template <class M> inline constexpr bool says_changes = requires { requires M::changes_velocities; };
template <class... M> constexpr bool changes_velocities(Types<M...>) { return (says_changes<M> || ...); }
/// Whether a module asks the laws before the integrator does, or reads what they said behind it.
template <class M, class... P> inline constexpr bool asks_first = requires { requires M::template asks_first<P...>; };
template <class M, class... P>
inline constexpr bool looks_at_own = requires { requires M::template looks_at_own<P...>; };
/// Whether a module wakes the sleepers that a force between bodies pulls at, before the integrator does.
template <class M, class... P> inline constexpr bool says_wakes = requires { requires M::template wakes_pulled<P...>; };
template <class... P, class... M> constexpr bool wakes_pulled(Types<M...>) { return (says_wakes<M, P...> || ...); }
/// Whether a policy gives rows of joints, and whether a module solves them.
template <class P, class S> inline constexpr bool gives_rows = requires { typename P::template Rows<S>; };
template <class M, class... P> inline constexpr bool says_solves = requires { requires M::template solves_rows<P...>; };
template <class... P, class... M> constexpr bool solves_rows(Types<M...>) { return (says_solves<M, P...> || ...); }
/// Whether a module holds what a force between bodies holds, by another way than a force.
template <class M, class Q, class S>
inline constexpr bool says_holds = requires { requires M::template holds_instead<Q, S>; };
template <class Q, class S, class... M> constexpr bool held_instead(Types<M...>) {
    return (says_holds<M, Q, S> || ...);
}
/// \tparam Modules those of a world
template <class S, class Modules> struct ActsAsForce {
    template <class P> static constexpr bool acts() {
        if constexpr (IsCoupling<P>::value) return !held_instead<P, S>(Modules{});
        return false;
    }
    template <class P> struct Is : std::bool_constant<acts<P>()> {};
    template <class P> struct IsNot : std::bool_constant<IsCoupling<P>::value && !acts<P>()> {};
};
/// An integrator that solves asks at states of its own; and what an effect before the forces changes, they must see.
template <class I, class LawsT, class Before, class... P> constexpr LawsAsked how_asked() {
    constexpr auto any = []<class... M>(Types<M...>) {
        if ((asks_first<M, P...> || ...)) return LawsAsked::beforehand;
        return (looks_at_own<M, P...> || ...) ? LawsAsked::and_left : LawsAsked::here;
    };
    constexpr bool changed = intersection_of<typename Before::writes, typename LawsT::needs>::size > 0;
    return LawsT::empty || !is_staged<I> || changed ? LawsAsked::here : any(modules_of<P...>{});
}

} // namespace detail

/// The facts of motion about a list of policies: a base of `Composition`.
template <class... P> struct MotionFacts {
private:
    using S_ = space_of<P...>;
    static constexpr bool late = detail::changes_velocities(detail::modules_of<P...>{});

public:
    using Integrator =
        typename detail::OrElse<detail::NoIntegrator, detail::filter<detail::IsIntegrator, P...>>::type; ///< the one
    using laws = detail::filter<detail::IsLaw, P...>;               ///< the forces that are laws of one body
    using all_couplings = detail::filter<detail::IsCoupling, P...>; ///< the forces between bodies
    /// Of those, the ones that act as forces: a solver of positions holds the others.
    using couplings = detail::filter<detail::ActsAsForce<S_, detail::modules_of<P...>>::template Is, P...>;
    /// And those that it holds.
    using held_couplings = detail::filter<detail::ActsAsForce<S_, detail::modules_of<P...>>::template IsNot, P...>;
    using resters = detail::filter<detail::IsRester, P...>; ///< the policies that put bodies to rest
    /// The effects of a place, by their turns, so that the order of the list means nothing.
    /// Where contacts change velocities, Rest tests the velocities behind them.
    template <Place At>
    using effects = typename detail::InTurn<detail::filter<detail::EffectAt<At, late>::template Is, P...>>::type;

    /// Whether bodies meet: a module that relates them to each other says so.
    static constexpr bool collides = detail::relates_bodies(detail::modules_of<P...>{});

    /// The effects that also act on fixed bodies that move by themselves.
    using platform_effects = detail::filter<detail::IsOnPlatforms, P...>;
    /// Those of a list that act in every substep of a divided step, not in the first alone.
    template <class List> using in_every_part = typename detail::InEveryPart<List>::type;

    using Laws = typename detail::LawsFrom<S_, laws>::type; ///< the sum of the laws, bound to the space
    using degrees = detail::filter<detail::IsDegree, P...>; ///< what is advanced beside translation
    /// The same, bound to the space.
    using Degrees = typename detail::DegreesFrom<S_, degrees>::type;
    /// The effects at a place of the step.
    template <Place At> using Effects = typename detail::EffectsFrom<S_, effects<At>>::type;

    /// Whether bodies act on each other, so that stages run over all of them.
    static constexpr bool coupled = couplings::size > 0;
    /// Whether a force between bodies sees a column, so that its sums are stale when the column changes.
    template <class C>
    static constexpr bool couplings_read =
        []<class... Q>(Types<Q...>) { return (detail::contains<C, reads_of<Q>> || ...); }(couplings{});
    /// Whether the integrator takes all bodies as one system.
    static constexpr bool together =
        coupled && detail::solves_together<Integrator, S_> && !detail::is_staged<Integrator>;
    using breakers =
        detail::filter<detail::BreaksIn<S_>::template Is, P...>; ///< the forces between bodies that can break
    static constexpr bool breaks = breakers::size > 0;           ///< whether one of them can
    static constexpr bool rests = resters::size > 0;             ///< whether bodies can fall asleep
    /// Whether those that touch, or hang together, do so together.
    static constexpr bool islands = rests && (collides || detail::filter<detail::HasElements, P...>::size > 0);
    /// Whether bodies are put to sleep behind what a module does to velocities after the integration.
    static constexpr bool rests_late = rests && late;
    /// Whether the first stage of the integrator wakes those that a force between bodies pulls at.
    static constexpr bool stages_wake = rests && !detail::wakes_pulled<P...>(detail::modules_of<P...>{});
    /// The history of positions instead of a velocity: reading and changing the velocity goes through the integrator.
    static constexpr bool history = detail::derives_velocity<Integrator>;

    /// Whether a force asks for the velocity. An effect that does needs no evaluation of the forces for it.
    static constexpr bool velocity_read =
        detail::contains<Velocity,
                         union_of<std::conditional_t<PlaysRole<P, roles::Force> || detail::IsCoupling<P>::value,
                                                     reads_of<P>, Columns<>>...>>;
    /// Which place of a step asks the laws of one body: once, wherever the answer can be shared.
    static constexpr LawsAsked asked = detail::how_asked<Integrator, Laws, Effects<Place::before_forces>, P...>();
    /// The scratch that the integrator really has use for.
    using scratch = union_of<std::conditional_t<velocity_read, detail::scratch_of<Integrator>,
                                                difference_of<detail::scratch_of<Integrator>, Columns<Velocity>>>,
                             typename Degrees::template scratch<Integrator>>;
    /// Needed by a policy that acts by other means in this world.
    using idle = union_of<std::conditional_t<coupled, Columns<>, Columns<CoupledForce>>,
                          std::conditional_t<detail::solves_rows<P...>(detail::modules_of<P...>{}), Columns<>,
                                             Columns<HeldAcceleration>>>;
    /// Of the columns that are needed, those with lanes: scratch becomes columns only where stages are run over all
    /// bodies, one after the other.
    template <class Needed>
    using stored_of =
        difference_of<union_of<writes_of<Integrator>, Needed, std::conditional_t<coupled, scratch, Columns<>>>,
                      std::conditional_t<!coupled && history, union_of<idle, Columns<Velocity>>, idle>>;
    /// Of those, the ones that are made anew in every step.
    using made_anew = union_of<detail::scratch_of<Integrator>, typename Degrees::template scratch<Integrator>,
                               Columns<CoupledForce>, std::conditional_t<history, Columns<Velocity>, Columns<>>>;

    /// Whether the motion runs back to its start, but for rounding, when every velocity is negated and the same steps
    /// are made again. Any damping, with whatever factor, and Rest make it false.
    static constexpr bool reversible = (detail::keeps_reversible<P>() && ...);
};

} // namespace ansatz
