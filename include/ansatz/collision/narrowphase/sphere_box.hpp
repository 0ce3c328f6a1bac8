// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A sphere and a box: the point of the box that is nearest to the centre decides.
///
/// A centre inside the box has no nearest point outside; it leaves through the nearest face, the lower axis first where
/// two are as near.

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>

namespace ansatz {

namespace detail {
/// The axis on which `inside` is nearest to the surface of a box, and which way is out.
template <class S> struct NearestFace {
    int axis = 0;
    typename S::Scalar out = 1, away;
    NearestFace(const typename S::Position& inside, const typename S::Position& half)
        : away(half.value()[0] - abs(inside.value()[0])) {
        for (int k = 1; k < S::dimension; ++k) {
            const auto to_face = half.value()[k] - abs(inside.value()[k]);
            if (to_face < away) axis = k, away = to_face;
        }
        out = inside.value()[axis] < typename S::Scalar(0) ? typename S::Scalar(-1) : typename S::Scalar(1);
    }
};
} // namespace detail

/// Whether a sphere reaches into a box, and how.
/// \param xs, xb where their centres are, m
template <class S>
bool collide(const Sphere::In<S>& sphere, const typename S::Position& xs, const Box::In<S>& box,
             const typename S::Position& xb, Touch<S>& touch) {
    using Scalar = typename S::Scalar;
    const typename S::Position seen = xs - xb; // the centre, seen from the box
    auto nearest = seen.value();
    bool inside = true;
    for (int k = 0; k < S::dimension; ++k) {
        const Scalar h = box.half.value()[k];
        inside = inside && !(abs(nearest[k]) > h);
        nearest[k] = max(-h, min(h, nearest[k]));
    }
    if (inside) {
        const detail::NearestFace<S> face(seen, box.half);
        for (int k = 0; k < S::dimension; ++k) touch.normal[k] = k == face.axis ? face.out : Scalar(0);
        nearest[face.axis] = face.out * box.half.value()[face.axis];
        touch.depth = sphere.radius + S::Length::from_value(face.away);
    } else {
        const auto out = S::Position::from_value(seen.value() - nearest);
        const auto distance = robust_norm(out);
        if (!(distance < sphere.radius) || !detail::unit_vector(out.value(), touch.normal)) return false;
        touch.depth = sphere.radius - distance;
    }
    touch.point = detail::halfway<S>(xs - sphere.radius * touch.normal, xb + S::Position::from_value(nearest));
    return true;
}

} // namespace ansatz
