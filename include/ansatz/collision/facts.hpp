// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What follows from a list of policies for bodies that collide: which policies find pairs and contacts, which
/// responses act on what, and what has to be found for them.

#include <ansatz/collision/response/solver_rows.hpp>
#include <ansatz/collision/roles.hpp>
#include <ansatz/world/columns.hpp>
#include <ansatz/world/space.hpp>
#include <ansatz/world/types.hpp>

#include <type_traits>

namespace ansatz {

namespace detail {

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
/// Whether a response answers all contacts of a step together.
template <class R> inline constexpr bool answers_as_one = requires { requires R::as_one; };
template <class... R> constexpr bool any_answers_as_one(Types<R...>) { return (answers_as_one<R> || ...); }

} // namespace detail

/// The facts of collision about a list of policies: a base of `Composition`.
template <class... P> struct CollisionFacts {
    using Narrowphase = typename detail::FirstIn<detail::filter<detail::IsNarrowphase, P...>>::type; ///< finds contacts
    using Broadphase = typename detail::FirstIn<detail::filter<detail::IsBroadphase, P...>>::type;   ///< finds pairs
    using filters = detail::filter<detail::IsFilter, P...>; ///< which pairs are tested
    /// The responses that act on something.
    template <Level At> using responses = detail::filter<detail::RespondsAt<At>::template Is, P...>;
    /// Whether a response takes a step in substeps.
    static constexpr bool substeps = responses<Level::substeps>::size > 0;
    /// Whether contacts act in the step that follows.
    static constexpr bool acts_next = substeps || responses<Level::accelerations>::size > 0;
    /// Whether bodies that do not touch yet are tested.
    static constexpr bool anticipates = acts_next;
    /// Whether bodies are followed through the step.
    static constexpr bool continuous = requires { requires Narrowphase::continuous; };
    /// Whether bodies that meet are moved apart.
    static constexpr bool separates = responses<Level::positions>::size > 0;
    /// The policies that give rows to the solver of the substeps: joints.
    using row_givers =
        std::conditional_t<substeps, detail::filter<detail::GivesRowsIn<space_of<P...>>::template Is, P...>, Types<>>;
    /// Whether a response answers all contacts together.
    static constexpr bool as_one =
        detail::any_answers_as_one(detail::joined_types<responses<Level::velocities>, responses<Level::positions>>{});
    /// Whether those that touch, and all but touch, are separated as one: what lies on each other is found before it
    /// intersects.
    static constexpr bool holds_near = !anticipates && detail::any_answers_as_one(responses<Level::positions>{});
    /// Whether a column means something to a filter or a response.
    template <class C>
    static constexpr bool collisions_read =
        (((PlaysRole<P, roles::Filter> || PlaysRole<P, roles::Response>)&&detail::contains<C, reads_of<P>>) || ...);
};

} // namespace ansatz
