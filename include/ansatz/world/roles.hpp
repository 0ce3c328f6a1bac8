// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a role is, and the roles that belong to no module.
///
/// A policy says what it is with one line, `using role = ansatz::roles::Force;`. The order in which policies are listed
/// never matters: the world finds each by its role. Use these tags when you write a policy of your own; a reader of a
/// program never needs them.
///
/// A role that comes with a module says so, `using module = Motion;`, and stands with its concept, its sentences and
/// how many of it a world takes in that module's folder (motion/roles.hpp). A world in which a policy plays such a role
/// has what the module brings (modules.hpp). So a new kind of policy is a new header, and touches no other.

#include <ansatz/core/compiler_flags.hpp>

#include <concepts>

namespace ansatz {

namespace roles {
struct Space {};       ///< scalar type and dimension; at most one, `Space<double, 3>` without it
struct StepControl {}; ///< whether a step is taken as it is, in substeps, or refused; at most one
struct Observer {};    ///< sees, never changes; any number
struct Execution {};   ///< runs the loops of a step; at most one, serial without it
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

template <class R> struct ModuleOfRole {
    using type = void;
};
template <class R>
    requires requires { typename R::module; }
struct ModuleOfRole<R> {
    using type = typename R::module;
};
/// The module that a role comes with, or `void`.
template <class R> using module_of_role = typename ModuleOfRole<R>::type;

template <class R, class... Known> inline constexpr bool one_of = (std::same_as<R, Known> || ...);

template <class R>
inline constexpr bool known_role = one_of<R, roles::Space, roles::StepControl, roles::Observer, roles::Execution> ||
                                   !std::is_void_v<module_of_role<R>>;

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
