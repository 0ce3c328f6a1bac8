// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Two spheres (notes 2.1.2): \f$ d < r_1 + r_2 \f$, \f$ p = r_1 + r_2 - d \f$, \f$ \mathbf N = (\mathbf S_1 - \mathbf S_2)/d \f$.
///
/// Right from the smallest to the largest distance that the scalar can hold. Spheres with one centre have no direction
/// between them; they separate along the second axis, upwards for the first.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/sphere.hpp>

namespace ansatz {

namespace detail {
/// The unit vector that is taken where there is no direction: the second axis.
template <class S> Vector<typename S::Scalar, S::dimension> no_direction() {
    Vector<typename S::Scalar, S::dimension> up;
    for (int k = 0; k < S::dimension; ++k) up[k] = typename S::Scalar(k == 1);
    return up;
}
/// What lies between two points on the surfaces; the same for both orders.
template <class S>
[[gnu::always_inline]] inline typename S::Position halfway(const typename S::Position& a,
                                                           const typename S::Position& b) {
    return typename S::Scalar(0.5) * (a + b);
}
/// Spheres whose squares the scalar cannot hold.
template <class S>
[[gnu::cold, gnu::noinline]] bool spheres_near_or_far(typename S::Position between, typename S::Length reach,
                                                      typename S::Length& distance,
                                                      Vector<typename S::Scalar, S::dimension>& normal) {
    distance = robust_norm(between);
    if (!(distance < reach)) return false;
    if (!unit_vector(between.value(), normal)) normal = no_direction<S>();
    return true;
}
} // namespace detail

/// Whether two spheres intersect, and how.
/// \param xa, xb where their centres are, m
template <class S>
[[gnu::always_inline]] inline bool collide(const Sphere::In<S>& a, const typename S::Position& xa,
                                           const Sphere::In<S>& b, const typename S::Position& xb, Touch<S>& touch) {
    const typename S::Position between = xa - xb;
    const typename S::Length reach = a.radius + b.radius;
    const auto squared = squared_norm(between);
    const auto squared_reach = reach * reach;
    typename S::Length distance;
    if (detail::squares_well(squared_reach.value()) &&
        squared.value() >= detail::smallest_square<typename S::Scalar>()) {
        if (!(squared < squared_reach)) return false;
        distance = sqrt(squared);
        if (!(distance < reach)) return false;
        touch.normal = between.value() / distance.value();
    } else if (!detail::spheres_near_or_far<S>(between, reach, distance, touch.normal)) return false;
    touch.depth = reach - distance;
    touch.point = detail::halfway<S>(xa - a.radius * touch.normal, xb + b.radius * touch.normal);
    return true;
}

} // namespace ansatz
