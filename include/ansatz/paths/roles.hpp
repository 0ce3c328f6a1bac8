// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The roles that a search is composed of, and how the policy of a role is picked from a list in any order.
///
/// A search is `AStar{graph, policies...}`. Every policy names its role; a role that no policy takes has a default, and
/// two policies of one role are refused in a sentence. What each role must be able to do stands beside its policies.

#include <ansatz/core/compiler_flags.hpp>

#include <type_traits>

namespace ansatz::paths {

namespace roles {
struct Heuristic {};  ///< estimates what is left: h
struct Queue {};      ///< the open list: hands out the least f
struct Cost {};       ///< the number that g, h and f are
struct Reopening {};  ///< what happens when a node of the closed list is reached on a cheaper way
struct Successors {}; ///< which nodes are visited from a node: every edge's, or fewer
struct Goals {};      ///< what is to be reached: a vertex, any of several, or a condition
struct Engine {};     ///< runs the loop: ours, Boost.Graph's, or one for any angle
struct Weights {};    ///< a property map of the edges' weights, where the graph has none of its own
struct Index {};      ///< a property map that numbers the vertices, where the graph has none of its own
} // namespace roles

/// A policy that takes this role.
template <class Policy, class Role>
concept HasRole = requires { typename Policy::role; } && std::is_same_v<typename Policy::role, Role>;

namespace detail {

template <class Policy>
inline constexpr bool has_known_role =
    HasRole<Policy, roles::Heuristic> || HasRole<Policy, roles::Queue> || HasRole<Policy, roles::Cost> ||
    HasRole<Policy, roles::Reopening> || HasRole<Policy, roles::Engine> || HasRole<Policy, roles::Weights> ||
    HasRole<Policy, roles::Index> || HasRole<Policy, roles::Successors> || HasRole<Policy, roles::Goals>;

template <class Role, class... Policies> inline constexpr int count_of = (0 + ... + int(HasRole<Policies, Role>));

/// The policy of this role, or the default.
template <class Role, class Default, class... Policies> struct Pick {
    using type = Default;
};
template <class Role, class Default, class First, class... Rest> struct Pick<Role, Default, First, Rest...> {
    using type = typename std::conditional_t<HasRole<First, Role>, std::type_identity<First>,
                                             Pick<Role, Default, Rest...>>::type;
};
template <class Role, class Default, class... Policies> using pick = typename Pick<Role, Default, Policies...>::type;

/// The heuristic and the cost that come with an engine where none are given; without wishes of its own, the default's.
template <class Engine, class Default> struct HeuristicOfEngine {
    using type = Default;
};
template <class Engine, class Default>
    requires requires { typename Engine::default_heuristic; }
struct HeuristicOfEngine<Engine, Default> {
    using type = typename Engine::default_heuristic;
};
template <class Engine, class Default> struct CostOfEngine {
    using type = Default;
};
template <class Engine, class Default>
    requires requires { typename Engine::default_cost; }
struct CostOfEngine<Engine, Default> {
    using type = typename Engine::default_cost;
};
/// Whether an engine can do with a heuristic.
template <class Engine, class Heuristic> inline constexpr bool admits = true;
template <class Engine, class Heuristic>
    requires requires { Engine::template admits<Heuristic>; }
inline constexpr bool admits<Engine, Heuristic> = Engine::template admits<Heuristic>;

template <class Role, class Default> constexpr Default take() { return Default{}; }
/// Its value: the one that was given, or one that is made.
template <class Role, class Default, class First, class... Rest>
constexpr pick<Role, Default, First, Rest...> take(const First& first, const Rest&... rest) {
    if constexpr (HasRole<First, Role>) return first;
    else return take<Role, Default>(rest...);
}

} // namespace detail
} // namespace ansatz::paths
