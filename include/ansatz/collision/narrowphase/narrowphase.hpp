// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Narrowphase<Shapes...>`: whether two bodies really intersect, and where (notes 2.1.2).
///
/// The list of shapes is part of the type: which two meet is decided by a comparison of two small numbers, and the
/// function that tests them is known to the compiler. A pair of shapes that no `collide` knows is a sentence at
/// compile time, if both have a box; two that have none (planes) never meet. Free functions do the same for two bodies
/// without a World: `contact(Sphere{1.0 * metre}, xa, Sphere{1.0 * metre}, xb)`.

#include <ansatz/collision/check.hpp>
#include <ansatz/collision/collisions.hpp>
#include <ansatz/collision/narrowphase/box_box.hpp>
#include <ansatz/collision/narrowphase/box_plane.hpp>
#include <ansatz/collision/narrowphase/pairs.hpp>
#include <ansatz/collision/narrowphase/sphere_box.hpp>
#include <ansatz/collision/narrowphase/sphere_plane.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>
#include <ansatz/collision/roles.hpp>
#include <ansatz/collision/shapes.hpp>
#include <ansatz/world/space.hpp>

#include <optional>
#include <string_view>

namespace ansatz {

namespace detail {
template <class X> struct SpaceOfPosition;
template <class Scalar, int Dim, int Options>
struct SpaceOfPosition<boost::units::quantity<unit::Length, Eigen::Matrix<Scalar, Dim, 1, Options, Dim, 1>>> {
    using type = Space<Scalar, Dim>;
};

/// Of two shapes the one with the larger number is made larger: 0 cannot be `grown`, 1 grows further at its corners (a
/// box), 2 and 3 grow evenly, and of these one that has a box (3, a sphere) goes before one that has none (2, a plane).
template <class Shape, class S>
inline constexpr int how_it_grows = [] {
    if constexpr (!requires(const Shape& shape, typename S::Length by) { shape.grown(by); }) return 0;
    else if constexpr (!requires { requires Shape::grows_evenly; }) return 1;
    else if constexpr (!requires(const Shape& shape, typename S::Position x) { shape.bounds(x, x, x); }) return 2;
    else return 3;
}();
} // namespace detail

/// How two shapes intersect, if they do.
/// \param xa, xb where they are, m
/// \throws std::invalid_argument for a shape whose numbers are not acceptable
template <ShapeDescription A, ShapeDescription B, class X>
auto contact(const A& a, const X& xa, const B& b, const X& xb) {
    using S = typename detail::SpaceOfPosition<X>::type;
    static_assert(sizeof(detail::CheckPair<A, B, S>) > 0);
    if constexpr (requires { a.check(); }) a.check();
    if constexpr (requires { b.check(); }) b.check();
    Touch<S> touch;
    const bool there =
        detail::intersect<S>(typename A::template In<S>(a), xa, typename B::template In<S>(b), xb, touch);
    return there ? std::optional<Touch<S>>(touch) : std::nullopt;
}

template <class C, class Policies> class Query; // queries_in_world.hpp, for those who ask

/// The contacts of bodies with these shapes.
template <class... T> struct Narrowphase {
    using role = roles::Narrowphase;
    using shapes = Types<T...>; ///< whose list collision/check.hpp checks

    static constexpr std::string_view name = "Narrowphase"; ///< in a saved file
    /// Whether it knows a shape.
    template <class Kind> static constexpr bool knows = (std::same_as<Kind, T> || ...);
    /// Whether one of them has no box, so that it meets everything.
    static constexpr bool any_unbounded = (!T::bounded || ...);
    static constexpr bool any_bounded = (T::bounded || ...); ///< whether one has one

    /// What a world holds of them.
    template <class C> using Collisions = ansatz::Collisions<C>;
    /// What answers a world's queries.
    template <class C, class Policies> using Query = ansatz::Query<C, Policies>;
    /// Where the shapes are kept.
    template <class S> using Shapes = ShapesOf<S, T...>;

    /// Calls `f.template operator()<Kind>()` for each kind of shape.
    template <class F> static void for_each_kind(F&& f) { (f.template operator()<T>(), ...); }

    /// The same for bodies that may be apart by up to `margin`, m; the depth is negative then. One of the two is made
    /// larger: rather one that is then exactly what is within `margin` of it, as a sphere is and a box is not, whose
    /// corners come too far. Shapes that cannot be `grown` are found when they intersect.
    template <class S>
    [[gnu::always_inline]] static bool
    nearly_collide(const Shapes<S>& shapes, std::uint32_t a, const typename S::Position& xa, std::uint32_t b,
                   const typename S::Position& xb, const typename S::Length& margin, Touch<S>& touch) {
        bool there = false;
        with_both(shapes, a, b, [&]<class One, class Other>(const One& one, const Other& other) {
            using Scalar = typename S::Scalar;
            constexpr int grows = detail::how_it_grows<One, S>, other_grows = detail::how_it_grows<Other, S>;
            if constexpr (grows == 0 && other_grows == 0) {
                there = detail::intersect<S>(one, xa, other, xb, touch);
            } else {
                if constexpr (grows >= other_grows)
                    there = detail::intersect<S>(one.grown(margin), xa, other, xb, touch);
                else there = detail::intersect<S>(one, xa, other.grown(margin), xb, touch);
                if (!there) return;
                touch.depth -= margin;
                // Half of it is that of the surface that was moved.
                touch.point += Scalar(grows >= other_grows ? 0.5 : -0.5) * margin * touch.normal;
            }
        });
        return there;
    }
    /// Whether the shapes of two bodies intersect, and how.
    /// \param a, b   their ids
    /// \param xa, xb where they are, m
    template <class S>
    [[gnu::always_inline]] static bool collide_bodies(const Shapes<S>& shapes, std::uint32_t a,
                                                      const typename S::Position& xa, std::uint32_t b,
                                                      const typename S::Position& xb, Touch<S>& touch) {
        bool there = false;
        with_both(shapes, a, b,
                  [&](const auto& one, const auto& other) { there = detail::intersect<S>(one, xa, other, xb, touch); });
        return there;
    }

    /// Calls `f(shape, shape)` with the shapes of two bodies, if both have one.
    template <class S, class F>
    [[gnu::always_inline]] static void with_both(const ShapesOf<S, T...>& shapes, std::uint32_t a, std::uint32_t b,
                                                 F&& f) {
        const auto ka = shapes.kind(a), kb = shapes.kind(b);
        auto against = [&]<class A, class B>() {
            static_assert(sizeof(detail::CheckPair<A, B, S>) > 0);
            if (kb == Shapes<S>::template kind_of<B>) f(shapes.template get<A>(a), shapes.template get<B>(b));
        };
        auto first = [&]<class A>() {
            if (ka == Shapes<S>::template kind_of<A>) (against.template operator()<A, T>(), ...);
        };
        (first.template operator()<T>(), ...);
    }
};

} // namespace ansatz
