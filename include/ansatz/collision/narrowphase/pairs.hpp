// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Which shapes can meet: whether there is a `collide` for two of them, in either order (notes 2.1.2).
///
/// Shapes without a box, such as planes, never meet each other; every other two of a Narrowphase need a function. A
/// shape of yours brings its own, in its own namespace:
///
/// \code
/// template <class S> bool collide(const Capsule::In<S>& a, const typename S::Position& xa,
///                                 const Sphere::In<S>& b, const typename S::Position& xb, Touch<S>& touch);
/// \endcode
///
/// It answers whether they intersect, and then says in `touch` where, along which normal (from b to a), and how deep.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/types.hpp>

#include <concepts>

namespace ansatz::detail {

/// A function for these two, in this order.
template <class A, class B, class S>
concept Collides = requires(const A& a, const B& b, const typename S::Position& x, Touch<S>& touch) {
    { collide(a, x, b, x, touch) } -> std::same_as<bool>;
};
template <class A, class B> inline constexpr bool may_meet = A::bounded || B::bounded;
template <class A, class B, class S>
inline constexpr bool can_meet =
    !may_meet<A, B> || Collides<typename A::template In<S>, typename B::template In<S>, S> ||
    Collides<typename B::template In<S>, typename A::template In<S>, S>;

/// The compiler's note names the two: CheckPair<Sphere, Capsule, ...>.
template <class A, class B, class S> struct CheckPair {
    static_assert(can_meet<A, B, S>, "Ansatz: two shapes of a Narrowphase that nothing knows how to collide; the "
                                     "compiler's note names them, CheckPair<A, B>; write "
                                     "`template <class S> bool collide(const A::In<S>& a, const typename S::Position& "
                                     "xa, const B::In<S>& b, const typename "
                                     "S::Position& xb, Touch<S>& touch)` in the namespace of your shape");
};
/// Each two of a list once, a shape with itself too.
template <class List, class S> struct CheckPairs {};
template <class First, class... Rest, class S>
struct CheckPairs<Types<First, Rest...>, S>
    : CheckPair<First, First, S>
    , CheckPair<First, Rest, S>...
    , CheckPairs<Types<Rest...>, S> {};
template <class S> constexpr bool pairs_can_meet(Types<>) { return true; }
template <class S, class First, class... Rest> constexpr bool pairs_can_meet(Types<First, Rest...>) {
    return can_meet<First, First, S> && (can_meet<First, Rest, S> && ...) && pairs_can_meet<S>(Types<Rest...>());
}

/// Whether two shapes intersect, whichever order `collide` wants them in.
template <class S, class A, class B>
[[gnu::always_inline]] inline bool intersect(const A& a, const typename S::Position& xa, const B& b,
                                             const typename S::Position& xb, Touch<S>& touch) {
    if constexpr (Collides<A, B, S>) return collide(a, xa, b, xb, touch);
    else if constexpr (Collides<B, A, S>) {
        if (!collide(b, xb, a, xa, touch)) return false;
        touch.normal = -touch.normal;
        return true;
    } else return false;
}

} // namespace ansatz::detail
