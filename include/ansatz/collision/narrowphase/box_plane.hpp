// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A box and a plane: the corner that is deepest decides; where an edge or a face is, its middle is the contact point.

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/plane.hpp>

namespace ansatz {

/// Whether a box reaches into a plane, and how.
/// \param xb where the box's centre is, m
/// \param xp where the plane's body is, m
template <class S>
bool collide(const Box::In<S>& box, const typename S::Position& xb, const Plane::In<S>& plane,
             const typename S::Position& xp, Touch<S>& touch) {
    using Scalar = typename S::Scalar;
    auto deepest = xb.value();
    Scalar reach(0);
    for (int k = 0; k < S::dimension; ++k) {
        const Scalar n = plane.normal[k], h = box.half.value()[k];
        reach += abs(n) * h;
        deepest[k] -= n > Scalar(0) ? h : n < Scalar(0) ? -h : Scalar(0);
    }
    const typename S::Length height = plane.height(xb, xp);
    if (!(height.value() < reach)) return false;
    touch.normal = plane.normal;
    touch.depth = S::Length::from_value(reach) - height;
    touch.point = S::Position::from_value(deepest) + (Scalar(0.5) * touch.depth) * plane.normal;
    return true;
}

} // namespace ansatz
