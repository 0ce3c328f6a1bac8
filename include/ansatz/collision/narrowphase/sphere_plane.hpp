// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A sphere and a plane (notes 2.1.2): with s = N . S + d the height of the centre, they intersect where s < r, and p =
/// r - s.
///
/// The notes call d the distance from the centre two lines after it was the plane's own constant. Read as a distance,
/// the depth depends on where the world has its origin: move plane and sphere together along N and it must stay what it
/// was.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/plane.hpp>
#include <ansatz/collision/sphere.hpp>

namespace ansatz {

/// Whether a sphere reaches into a plane, and how. However deep its centre is, it is pushed out along the plane's
/// normal.
/// \param xs where the sphere's centre is, m
/// \param xp where the plane's body is, m
template <class S>
[[gnu::always_inline]] inline bool collide(const Sphere::In<S>& sphere, const typename S::Position& xs,
                                           const Plane::In<S>& plane, const typename S::Position& xp, Touch<S>& touch) {
    const typename S::Length height = plane.height(xs, xp);
    if (!(height < sphere.radius)) return false;
    touch.normal = plane.normal;
    touch.depth = sphere.radius - height;
    touch.point =
        xs - (typename S::Scalar(0.5) * (sphere.radius + height)) * plane.normal; // between S - N r and S - N s
    return true;
}

} // namespace ansatz
