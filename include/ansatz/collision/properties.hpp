// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `World::add` takes of a body that collides: its shape, or that it only notices, or that it meets nothing.

#include <ansatz/collision/roles.hpp>
#include <ansatz/world/properties.hpp>

#include <concepts>

namespace ansatz {

/// The description of a shape, e.g. `Sphere{0.5 * metre}`; see collision/shapes.hpp. A world with a Narrowphase takes
/// one for each body, or `shapeless`.
template <class T>
concept ShapeDescription = std::same_as<typename T::shape, T>;

/// A body that others meet without being pushed, and that is pushed by none: its contacts are reported, and that is
/// all.
struct Sensor {
    using module = modules::Collision; ///< whose property it is
};
inline constexpr Sensor sensor{}; ///< reports what enters it, and pushes nothing

namespace detail {
template <ShapeDescription T> struct ModuleOfProperty<T> {
    using type = modules::Collision;
};
} // namespace detail

} // namespace ansatz
