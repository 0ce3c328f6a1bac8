// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ConstraintIn`: what a solver of positions must know of a constraint, and which policies have some.
///
/// A constraint is a number C that should be zero, kept by an energy \f$ \tfrac12 k C^2 \f$ and damped by a force \f$ c\,\dot C \f$.
/// It is a type; a solver knows none of them by name. A policy gives its constraints one by one with the verb
/// `constraints(view, f)` of its `In<S>`, which calls `f(constraint)` for each, always in the same order; Springs and
/// Ropes do. In a world with a Solver such a policy acts by its constraints and not as a force; one without the verb
/// (Attraction) stays a force in every world.
///
/// Write one as SpringConstraint is written (springs/constraint.hpp). Numbers are those of SI, since C may be a length,
/// an angle or a volume: k is then in N/m, J or J/m^6. One that holds as many bodies as its surface has (the volume of
/// a ball) is a `WideConstraintIn`.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/world/view.hpp>

#include <Eigen/Core>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

namespace ansatz {

/// What a solver needs: which bodies, by their slots; the energy's stiffness, finite and not negative; the damping; and
/// C with its gradient by each body's position.
///
/// `one_sided` says whether only C > 0 is held, as a rope is only when it is longer than it should be. One that also
/// says `static constexpr bool moves_along = true` is unchanged where all its bodies are moved by the same way, so that
/// it gives them no momentum; `VertexBlockDescent` asks for that.
///
/// `SpringConstraint` and `AnchoredSpringConstraint` are what `Springs` and `Ropes` give (notes 4).
template <class K, class S>
concept ConstraintIn = requires(const K& k, const std::array<Vector<typename S::Scalar, S::dimension>, K::bodies>& x,
                                std::array<Vector<typename S::Scalar, S::dimension>, K::bodies>& gradient) {
    { k.slots } -> std::convertible_to<std::array<std::size_t, K::bodies>>;
    { k.stiffness } -> std::convertible_to<typename S::Scalar>;
    { k.damping } -> std::convertible_to<typename S::Scalar>;
    { K::one_sided } -> std::convertible_to<bool>;
    { k.linearise(x, gradient) } -> std::same_as<typename S::Scalar>;
};

/// The same, for solvers that descend: with the part of C's second derivative by one body that is never negative.
///
/// `SpringConstraint` and `AnchoredSpringConstraint` are two, and `VertexBlockDescent` asks for it (notes 4).
template <class K, class S>
concept CurvedConstraintIn =
    ConstraintIn<K, S> &&
    requires(const K& k, const std::array<Vector<typename S::Scalar, S::dimension>, K::bodies>& x) {
        {
            k.curvature(std::size_t(0), x, x)
        } -> std::convertible_to<Eigen::Matrix<typename S::Scalar, S::dimension, S::dimension>>;
    };

namespace detail {
/// Where the body of a slot is, as a solver tells it.
template <class S> struct PlacesProbe {
    const Vector<typename S::Scalar, S::dimension>& operator()(std::size_t slot) const;
};
} // namespace detail

/// A constraint of a number of bodies that is known only at run time, such as the volume of a closed surface:
/// `count()` of them, `slot(i)`, and `linearise(at, gradient)`, which is told where the body of a slot is and fills a
/// gradient for each body. It is not one-sided, and of its curvature only \f$ k\,\nabla C\,\nabla C^T \f$ is used.
///
/// `PressureConstraint` is what `Pressure` gives; `Xpbd` and `VertexBlockDescent` hold it (notes 4).
template <class K, class S>
concept WideConstraintIn = requires(const K& k, const detail::PlacesProbe<S>& at,
                                    std::span<Vector<typename S::Scalar, S::dimension>> gradient) {
    { k.count() } -> std::convertible_to<std::size_t>;
    { k.slot(std::size_t(0)) } -> std::convertible_to<std::size_t>;
    { k.stiffness } -> std::convertible_to<typename S::Scalar>;
    { k.damping } -> std::convertible_to<typename S::Scalar>;
    { k.linearise(at, gradient) } -> std::same_as<typename S::Scalar>;
};

namespace detail {
/// How many bodies a constraint of either kind holds, and in which slots they are.
template <class K> [[gnu::always_inline]] inline std::size_t bodies_of(const K& k) {
    if constexpr (requires { k.count(); }) return k.count();
    else return K::bodies;
}
template <class K> [[gnu::always_inline]] inline std::size_t slot_of(const K& k, std::size_t i) {
    if constexpr (requires { k.count(); }) return k.slot(i);
    else return k.slots[i];
}
struct TakesAny {
    void operator()(const auto&) const {}
};
} // namespace detail

/// A policy that gives constraints.
///
/// `Springs` and `Ropes` do, and `Xpbd` holds them (notes 4).
template <class Q, class S>
concept GivesConstraints =
    requires(const detail::Bound<Q, S>& q, const ObserverView<S, Q>& view) { q.constraints(view, detail::TakesAny{}); };

} // namespace ansatz
