// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Composition<P...>`: what follows at compile time from a list of policies. Which space, which integrator, which
/// forces act on one body and which couple bodies, which effects act where, and the one list of columns that the world
/// stores: the union of what its policies declared, and nothing else.

#include <ansatz/world/elements.hpp>
#include <ansatz/world/integration.hpp>

#include <type_traits>

namespace ansatz {

/// A compile-time list of types.
template <class... T> struct Types {
    /// How many there are.
    static constexpr int size = int(sizeof...(T));
};

namespace detail {

template <class Done, template <class> class Keep, class... T> struct Filtered {
    using type = Done;
};
template <class... Done, template <class> class Keep, class First, class... Rest>
struct Filtered<Types<Done...>, Keep, First, Rest...> {
    using type = typename Filtered<std::conditional_t<Keep<First>::value, Types<Done..., First>, Types<Done...>>, Keep,
                                   Rest...>::type;
};
template <template <class> class Keep, class... T> using filter = typename Filtered<Types<>, Keep, T...>::type;

/// Takes the place of an integrator that is missing, so that only the sentence about it is seen.
struct NoIntegrator {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto&, auto&, const auto&, const auto&) {}
};
template <class> struct FirstOf {
    using type = NoIntegrator;
};
template <class First, class... Rest> struct FirstOf<Types<First, Rest...>> {
    using type = First;
};

template <class P> inline constexpr bool couples_bodies = requires { requires P::couples_bodies; };
template <class P> inline constexpr bool puts_to_rest = requires { requires P::puts_to_rest; };
template <class P> inline constexpr bool is_datum = requires { typename P::datum_type; };

template <class P> struct IsIntegrator : std::bool_constant<PlaysRole<P, roles::Integrator>> {};
template <class P>
struct IsCoupling
    : std::bool_constant<(PlaysRole<P, roles::Force> || PlaysRole<P, roles::Response>)&&couples_bodies<P>> {};
template <class P> struct IsLaw : std::bool_constant<PlaysRole<P, roles::Force> && !couples_bodies<P>> {};
template <class P> struct IsNarrowphase : std::bool_constant<PlaysRole<P, roles::Narrowphase>> {};
template <class P> struct IsBroadphase : std::bool_constant<PlaysRole<P, roles::Broadphase>> {};
template <class P> struct IsFilter : std::bool_constant<PlaysRole<P, roles::Filter>> {};
template <Level At> struct RespondsAt {
    template <class P> static constexpr bool here() {
        if constexpr (PlaysRole<P, roles::Response> && requires { P::level; }) return P::level == At;
        return false;
    }
    template <class P> struct Is : std::bool_constant<here<P>()> {};
};
template <class P> struct IsControl : std::bool_constant<PlaysRole<P, roles::StepControl>> {};
template <class P> struct IsObserver : std::bool_constant<PlaysRole<P, roles::Observer>> {};
template <class S> struct KeepsStateIn {
    template <class P> struct Is : std::bool_constant<keeps_state<P, S>> {};
};
/// What an integrator keeps that advances all bodies together.
template <class I, class S> inline constexpr bool solves_together = requires { typename I::template Together<S>; };

template <class S> struct BreaksIn {
    template <class P> struct Is : std::bool_constant < keeps_state<P, S>&& requires {
        requires P::breaks;
    } > {};
};
template <class P> struct HasElements : std::bool_constant < requires {
    typename P::Element;
} > {};
template <class P> struct IsRester : std::bool_constant<puts_to_rest<P>> {};

/// When an effect acts among those of its place: turn 0 unless it says otherwise, up to 2.
template <class P> constexpr int turn_of() {
    if constexpr (requires { P::turn; }) return P::turn;
    return 0;
}
template <int Turn> struct HasTurn {
    template <class P> struct Is : std::bool_constant<turn_of<P>() == Turn> {};
};
template <class... Lists> struct Joined;
template <class... A, class... B, class... C> struct Joined<Types<A...>, Types<B...>, Types<C...>> {
    using type = Types<A..., B..., C...>;
};
template <class List> struct InTurn;
template <class... E> struct InTurn<Types<E...>> {
    static_assert(((turn_of<E>() >= 0 && turn_of<E>() <= 2) && ...), "Ansatz: an effect's turn is 0, 1 or 2");
    using type =
        typename Joined<filter<HasTurn<0>::Is, E...>, filter<HasTurn<1>::Is, E...>, filter<HasTurn<2>::Is, E...>>::type;
};

template <Place At, bool Collides = false> struct EffectAt {
    template <class P> static constexpr bool here() {
        if constexpr (Collides && puts_to_rest<P>) return false;
        if constexpr (PlaysRole<P, roles::Effect> && requires { P::place; }) return P::place == At;
        return false;
    }
    template <class P> struct Is : std::bool_constant<here<P>()> {};
};

/// Whether a response answers all contacts of a step together.
template <class R> inline constexpr bool answers_as_one = requires { requires R::as_one; };

/// An effect that also acts on bodies that are `moving`; the others act on awake bodies only.
template <class P> struct IsOnPlatforms : std::bool_constant < EffectAt<Place::before_forces>::here<P>() && requires {
    requires P::on_platforms;
} > {};

/// An effect of the whole step, which the later parts of a divided one leave alone.
template <class P> struct IsOfEveryPart : std::bool_constant < !requires {
    requires P::once_a_step;
} > {};
template <class List> struct InEveryPart;
template <class... P> struct InEveryPart<Types<P...>> {
    using type = filter<IsOfEveryPart, P...>;
};

/// What evaluating policy `P` needs: what it declared, and the mass where a force must become an acceleration.
template <class P, class S> constexpr auto needs() {
    if constexpr (IsCoupling<P>::value) return union_of<reads_of<P>, Columns<CoupledForce, InverseMass>>{};
    else if constexpr (IsLaw<P>::value) return needs_of_law<P, S>{};
    else if constexpr (PlaysRole<P, roles::Response>)
        return union_of<writes_of<P>, reads_of<P>, Columns<InverseMass>>{};
    else return union_of<writes_of<P>, reads_of<P>>{};
}

/// Whether a policy leaves a motion that can be run backwards: an integrator says so itself; a force must depend
/// neither on the velocity nor on the time; an effect must not touch the state of motion.
template <class P> constexpr bool keeps_reversible() {
    if constexpr (PlaysRole<P, roles::Integrator>) return requires { requires P::reversible; };
    else if constexpr (PlaysRole<P, roles::Force>)
        return intersection_of<reads_of<P>, Columns<Velocity, Clock>>::size == 0;
    else return difference_of<writes_of<P>, Columns<DrawnPosition>>::size == 0;
}

template <class C> inline constexpr bool is_transient = requires { requires C::transient; };
template <class List> struct Transient;
template <class... C> struct Transient<Columns<C...>> {
    using type = union_of<std::conditional_t<is_transient<C>, Columns<C>, Columns<>>...>;
};

template <class S, class List> struct LawsFrom;
template <class S, class... P> struct LawsFrom<S, Types<P...>> {
    using type = Laws<S, P...>;
};
template <class S, class List> struct EffectsFrom;
template <class S, class... P> struct EffectsFrom<S, Types<P...>> {
    using type = Effects<S, P...>;
};

} // namespace detail

/// The facts about a list of policies.
template <class... P> struct Composition {
    /// The space.
    using S = space_of<P...>;
    using Integrator = typename detail::FirstOf<detail::filter<detail::IsIntegrator, P...>>::type; ///< the integrator
    using laws = detail::filter<detail::IsLaw, P...>;           ///< the forces that are laws of one body
    using couplings = detail::filter<detail::IsCoupling, P...>; ///< the forces between bodies
    using controls = detail::filter<detail::IsControl, P...>;   ///< what decides how a step is taken
    static constexpr bool controlled = controls::size > 0;      ///< whether something does
    using observers = detail::filter<detail::IsObserver, P...>; ///< the observers
    using resters = detail::filter<detail::IsRester, P...>;     ///< the policies that put bodies to rest
    using keepers =
        detail::filter<detail::KeepsStateIn<S>::template Is, P...>;    ///< the policies that keep a state of their own
    using element_keepers = detail::filter<detail::HasElements, P...>; ///< those of them that keep elements (springs)
    /// The effects of a place, by their turns, so that the order of the list means nothing.
    /// Where bodies collide, Rest looks at the velocities behind the responses.
    template <Place At>
    using effects = typename detail::InTurn<
        detail::filter<detail::EffectAt<At, (count_of_role<roles::Narrowphase, P...> > 0)>::template Is, P...>>::type;

    /// The effects that also act on fixed bodies that move by themselves.
    using platform_effects = detail::filter<detail::IsOnPlatforms, P...>;
    /// Those of a list that act in every part of a divided step, not in its first part alone.
    template <class List> using in_every_part = typename detail::InEveryPart<List>::type;

    using Narrowphase =
        typename detail::FirstOf<detail::filter<detail::IsNarrowphase, P...>>::type; ///< what finds contacts
    using Broadphase = typename detail::FirstOf<detail::filter<detail::IsBroadphase, P...>>::type; ///< what finds pairs
    using filters = detail::filter<detail::IsFilter, P...>;                       ///< which pairs are looked at
    static constexpr bool collides = count_of_role<roles::Narrowphase, P...> > 0; ///< whether bodies meet
    /// The responses that act on something.
    template <Level At> using responses = detail::filter<detail::RespondsAt<At>::template Is, P...>;
    static constexpr bool substeps = responses<Level::substeps>::size > 0; ///< whether a response takes a step in parts
    static constexpr bool acts_next =
        substeps || responses<Level::accelerations>::size > 0; ///< whether contacts act in the step that follows
    static constexpr bool anticipates = acts_next;             ///< whether bodies are looked at that do not touch yet
    static constexpr bool sweeps =
        requires { requires Narrowphase::sweeps; }; ///< whether bodies are followed through the step
    static constexpr bool parts = responses<Level::positions>::size > 0; ///< whether bodies that meet are moved apart
    static constexpr bool as_one =
        []<class... R>(Types<R...>) {
            return (detail::answers_as_one<R> || ...);
        }(typename detail::Joined<responses<Level::velocities>, responses<Level::positions>,
                                  Types<>>::type{}); ///< whether a response answers all contacts together
    /// Whether those that touch, and all but touch, are parted as one: what lies on each other is found before it
    /// intersects.
    static constexpr bool holds_near = !anticipates && []<class... R>(Types<R...>) {
        return (detail::answers_as_one<R> || ...);
    }(responses<Level::positions>{});

    using Laws = typename detail::LawsFrom<S, laws>::type; ///< the sum of the laws, bound to the space
    /// The effects at a place of the step.
    template <Place At> using Effects = typename detail::EffectsFrom<S, effects<At>>::type;

    /// Whether bodies act on each other, so that stages run over all of them.
    static constexpr bool coupled = couplings::size > 0;
    /// Whether a force between bodies sees a column, so that its sums are stale when the column changes.
    template <class C>
    static constexpr bool couplings_read =
        []<class... Q>(Types<Q...>) { return (detail::contains<C, reads_of<Q>> || ...); }(couplings{});
    /// Whether it means something to a filter or a response.
    template <class C>
    static constexpr bool collisions_read =
        (((PlaysRole<P, roles::Filter> || PlaysRole<P, roles::Response>)&&detail::contains<C, reads_of<P>>) || ...);
    /// Whether the integrator takes all bodies as one system.
    static constexpr bool together =
        coupled && detail::solves_together<Integrator, S> && !detail::is_staged<Integrator>;
    using breakers =
        detail::filter<detail::BreaksIn<S>::template Is, P...>; ///< the forces between bodies that can break
    static constexpr bool breaks = breakers::size > 0;          ///< whether one of them can
    static constexpr bool rests = resters::size > 0;            ///< whether bodies can fall asleep
    /// Whether those that touch, or hang together, do so together.
    static constexpr bool islands = rests && (collides || element_keepers::size > 0);
    /// The history of positions instead of a velocity: reading and changing the velocity goes through the integrator.
    static constexpr bool history = detail::derives_velocity<Integrator>;

    /// Everything that some policy needs.
    using needed = union_of<writes_of<Integrator>, decltype(detail::needs<P, S>())...>;
    /// Whether a force asks for the velocity. An effect that does needs no evaluation of the forces for it.
    static constexpr bool velocity_read =
        detail::contains<Velocity,
                         union_of<std::conditional_t<PlaysRole<P, roles::Force> || detail::IsCoupling<P>::value,
                                                     reads_of<P>, Columns<>>...>>;
    /// The scratch that the integrator really has use for.
    using scratch = std::conditional_t<velocity_read, detail::scratch_of<Integrator>,
                                       difference_of<detail::scratch_of<Integrator>, Columns<Velocity>>>;
    /// What the world stores: scratch becomes columns only where stages are run body after body.
    using stored = std::conditional_t<coupled, union_of<needed, scratch>,
                                      std::conditional_t<history, difference_of<needed, Columns<Velocity>>, needed>>;
    /// What makes up the state: stored, and not made anew in every step.
    using state = difference_of<stored, union_of<detail::scratch_of<Integrator>, Columns<CoupledForce>,
                                                 std::conditional_t<history, Columns<Velocity>, Columns<>>>>;
    /// Columns that the step sets back to zero when it has used them.
    using transient = typename detail::Transient<stored>::type;

    template <class C>
    static constexpr bool stores = detail::contains<C, stored>; ///< whether the world stores a column
    /// Whether bodies have a mass of their own.
    static constexpr bool has_mass = stores<InverseMass>;

    /// Whether the motion runs back to its start, but for rounding, when every velocity is negated and the same steps
    /// are made again. Any damping, with whatever factor, and Rest make it false.
    static constexpr bool reversible = (detail::keeps_reversible<P>() && ...);
};

} // namespace ansatz
