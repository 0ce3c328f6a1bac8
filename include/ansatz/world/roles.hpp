// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The roles that a policy can play in a `World`, and how many of each a world takes.
///
/// A policy says what it is with one line, `using role = ansatz::roles::Force;`. The order in which policies are listed
/// never matters: the world finds each by its role. Use these tags when you write a policy of your own; a reader of a
/// program never needs them. A new *kind* of policy would be a new role, and that is the one thing that touches
/// `world/`.

#include <ansatz/core/compiler_flags.hpp>

#include <concepts>

namespace ansatz {

namespace roles {
struct Space {};       ///< scalar type and dimension; at most one, `Space<double, 3>` without it
struct Integrator {};  ///< advances one body by its stages; exactly one
struct Force {};       ///< a law of one body, or couples bodies; any number
struct Effect {};      ///< acts on declared columns at a named place of the step; any number
struct Broadphase {};  ///< pairs that may touch; at most one
struct Filter {};      ///< which pairs are looked at; at most one
struct Narrowphase {}; ///< contacts of those pairs; exactly one with a broadphase, none without
struct Response {};    ///< what contacts do; one (or a chain) with a narrowphase, none without
struct StepControl {}; ///< whether a step is taken as it is, in parts, or refused; at most one
struct Observer {};    ///< sees, never changes; any number
} // namespace roles

namespace detail {

template <class P> struct RoleOf {
    using type = void;
};
template <class P>
    requires requires { typename P::role; }
struct RoleOf<P> {
    using type = typename P::role;
};

template <class R, class... Known> inline constexpr bool one_of = (std::same_as<R, Known> || ...);

template <class R>
inline constexpr bool known_role =
    one_of<R, roles::Space, roles::Integrator, roles::Force, roles::Effect, roles::Broadphase, roles::Filter,
           roles::Narrowphase, roles::Response, roles::StepControl, roles::Observer>;

} // namespace detail

/// The role of a policy, or `void` for a type that names none.
template <class P> using role_of = typename detail::RoleOf<P>::type;

/// A policy is a type that names one of the known roles. What else it must have depends on the role; see concepts.hpp.
template <class P>
concept Policy = detail::known_role<role_of<P>>;

/// `P` is a policy that plays the role `Role`.
template <class P, class Role>
concept PlaysRole = std::same_as<role_of<P>, Role>;

/// How many of the policies `P...` play `Role`.
template <class Role, class... P> constexpr int count_of_role = (0 + ... + int(PlaysRole<P, Role>));

} // namespace ansatz
