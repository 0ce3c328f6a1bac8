// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Modules: what a world has because one of its policies plays a role that comes with it.
///
/// `roles::Force` comes with `modules::Motion`, `roles::Narrowphase` with `modules::Collision`. The frame knows
/// neither; it knows that a module may have the following, each of them only where it is needed:
///
/// | member | what it is |
/// |---|---|
/// | `static constexpr int layer` | its place above the modules that it may use (motion is 0) |
/// | `using stands_on = Types<...>` | modules that come with it |
/// | `template <class... P> struct Facts` | what follows from a list of policies; a base of `Composition` |
/// | `template <class... P> struct Counts`, `CheckCounts` | how many of each role there may be: `ok`, sentences |
/// | `template <class P, class S> using FactsOf, SentencesOf` | the same for one policy of one of its roles |
/// | `template <class P, class S> using needs` | the columns that a policy of one of its roles needs |
/// | `template <class C, class Data> struct State` | a part of a world's value; a base of `WorldData` |
/// | `template <class C> struct Bound` | policies bound to the space; a base of `BoundPolicies` |
/// | `template <class W, class C> class Door` | members of `World` |
/// | `template <class C> using systems` | what it does in a step, at which phase (schedule.hpp) |
/// | `template <class C, class... Property> struct AddFacts`, `CheckAdd` | properties that `add` may be given |
///
/// and the functions that world/hooks.hpp calls: when bodies are added, removed and changed, when room is made, when a
/// world is hashed and saved. A change is told to the modules of higher layers first, so that derived values are marked
/// stale before their sources are read.

#include <ansatz/world/roles.hpp>
#include <ansatz/world/types.hpp>

#include <type_traits>
#include <utility>

namespace ansatz::detail {

/// Whether a module is more than a name: its header is included.
template <class M> inline constexpr bool module_is_here = requires { sizeof(M); };
template <class M> constexpr int layer_of() {
    if constexpr (requires { M::layer; }) return M::layer;
    return 0;
}

template <class List> struct ByLayer;
template <class... M> struct ByLayer<Types<M...>> {
    template <int Layer> struct At {
        template <class One> struct Is : std::bool_constant<layer_of<One>() == Layer> {};
    };
    static_assert(((layer_of<M>() >= 0 && layer_of<M>() <= 3) && ...), "Ansatz: a module's layer is 0, 1, 2 or 3");
    using type = joined_types<filter<At<3>::template Is, M...>, filter<At<2>::template Is, M...>,
                              filter<At<1>::template Is, M...>, filter<At<0>::template Is, M...>>;
};

template <class M> struct StandsOn {
    using type = Types<>;
};
template <class M>
    requires requires { typename M::stands_on; }
struct StandsOn<M> {
    using type = typename M::stands_on;
};
template <class List> struct WithThoseBelow;
template <class... M> struct WithThoseBelow<Types<M...>> {
    template <class List> struct Each;
    template <class... N> struct Each<Types<N...>> {
        using type = distinct<N...>;
    };
    using type = typename Each<joined_types<Types<M...>, typename StandsOn<M>::type...>>::type;
};
/// The modules that come with these policies, and those that they stand on; the upper ones first.
template <class... P>
using modules_of = typename ByLayer<typename WithThoseBelow<distinct<module_of_role<role_of<P>>...>>::type>::type;

// What stands in for a list of policies that is no world, so that only the sentence about it is read.
template <class M> struct StandIn {
    using type = Types<>;
};
template <class M>
    requires requires { typename M::StandIn; }
struct StandIn<M> {
    using type = Types<typename M::StandIn>;
};

/// Calls `f.operator()<M>()` for each module of a list.
template <class F, class... M> constexpr void each_module(Types<M...>, F&& f) { (f.template operator()<M>(), ...); }

// Bases made of what modules bring; of what a module does not bring, an empty one.
template <class M> struct Nothing {};
template <class M, class... P> struct FactsIn {
    using type = Nothing<M>;
};
template <class M, class... P>
    requires requires { sizeof(typename M::template Facts<P...>); }
struct FactsIn<M, P...> {
    using type = typename M::template Facts<P...>;
};
template <class M, class C, class Data> struct StateIn {
    using type = Nothing<M>;
};
template <class M, class C, class Data>
    requires requires { typename M::template State<C, Data>; }
struct StateIn<M, C, Data> {
    using type = typename M::template State<C, Data>;
};
template <class M, class W, class C> struct DoorIn {
    using type = Nothing<M>;
};
template <class M, class W, class C>
    requires requires { typename M::template Door<W, C>; }
struct DoorIn<M, W, C> {
    using type = typename M::template Door<W, C>;
};
template <class M, class C> struct BoundIn {
    using type = Nothing<M>;
};
template <class M, class C>
    requires requires { typename M::template Bound<C>; }
struct BoundIn<M, C> {
    using type = typename M::template Bound<C>;
};
template <class M, class C> struct SystemsIn {
    using type = Types<>;
};
template <class M, class C>
    requires requires { typename M::template systems<C>; }
struct SystemsIn<M, C> {
    using type = typename M::template systems<C>;
};

} // namespace ansatz::detail
