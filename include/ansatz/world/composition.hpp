// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Composition<P...>`: what follows at compile time from a list of policies. Which space, which modules they come
/// with, and the one list of columns that the world stores: the union of what its policies declared, and nothing else.
/// What only a module can say, such as which forces there are, stands in that module's facts, of which this is made.

#include <ansatz/world/elements.hpp>
#include <ansatz/world/modules.hpp>
#include <ansatz/world/space.hpp>

#include <type_traits>

namespace ansatz {

namespace detail {

template <class P> inline constexpr bool is_datum = requires { typename P::datum_type; };
template <class P> struct IsControl : std::bool_constant<PlaysRole<P, roles::StepControl>> {};
template <class P> struct IsObserver : std::bool_constant<PlaysRole<P, roles::Observer>> {};
template <class S> struct KeepsStateIn {
    template <class P> struct Is : std::bool_constant<keeps_state<P, S>> {};
};

/// The columns that a policy needs: what its role's module says, or what it declares itself.
template <class P, class S> struct NeedsIn {
    using type = union_of<writes_of<P>, reads_of<P>>;
};
template <class P, class S>
    requires requires { typename module_of_role<role_of<P>>::template needs<P, S>; }
struct NeedsIn<P, S> {
    using type = typename module_of_role<role_of<P>>::template needs<P, S>;
};

template <class C> inline constexpr bool is_transient = requires { requires C::transient; };
template <class List> struct Transient;
template <class... C> struct Transient<Columns<C...>> {
    using type = union_of<std::conditional_t<is_transient<C>, Columns<C>, Columns<>>...>;
};

// A module that runs the loops says which columns have lanes, and which of them are no part of the state.
template <class Facts, class Needed> struct StoredBy {
    using type = Needed;
};
template <class Facts, class Needed>
    requires requires { typename Facts::template stored_of<Needed>; }
struct StoredBy<Facts, Needed> {
    using type = typename Facts::template stored_of<Needed>;
};
template <class Facts> struct MadeAnew {
    using type = Columns<>;
};
template <class Facts>
    requires requires { typename Facts::made_anew; }
struct MadeAnew<Facts> {
    using type = typename Facts::made_anew;
};

template <class Modules, class... P> struct AllFacts;
template <class... M, class... P> struct AllFacts<Types<M...>, P...> : FactsIn<M, P...>::type... {};

} // namespace detail

/// The facts about a list of policies.
template <class... P> struct Composition : detail::AllFacts<detail::modules_of<P...>, P...> {
private:
    using Facts = detail::AllFacts<detail::modules_of<P...>, P...>;

public:
    /// The space.
    using S = space_of<P...>;
    using policies = Types<P...>;                             ///< all of them
    using modules = detail::modules_of<P...>;                 ///< what they come with, the upper ones first
    using controls = detail::filter<detail::IsControl, P...>; ///< what decides how a step is taken
    static constexpr bool controlled = controls::size > 0;    ///< whether something does
    static constexpr bool executed = count_of_role<roles::Execution, P...> > 0; ///< whether a policy runs the loops
    using observers = detail::filter<detail::IsObserver, P...>;                 ///< the observers
    using keepers =
        detail::filter<detail::KeepsStateIn<S>::template Is, P...>;    ///< the policies that keep a state of their own
    using element_keepers = detail::filter<detail::HasElements, P...>; ///< those of them that keep elements

    /// Everything that some policy needs.
    using needed = union_of<typename detail::NeedsIn<P, S>::type...>;
    /// What the world stores.
    using stored = typename detail::StoredBy<Facts, needed>::type;
    /// What makes up the state: stored, and not made anew in every step.
    using state = difference_of<stored, typename detail::MadeAnew<Facts>::type>;
    /// Columns that the step sets back to zero when it has used them.
    using transient = typename detail::Transient<stored>::type;

    template <class C>
    static constexpr bool stores = detail::contains<C, stored>; ///< whether the world stores a column
    /// Whether bodies have a mass of their own.
    static constexpr bool has_mass = stores<InverseMass>;
};

} // namespace ansatz
