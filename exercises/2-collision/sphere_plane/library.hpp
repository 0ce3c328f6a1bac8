// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/narrowphase/narrowphase.hpp>
#include <ansatz/collision/narrowphase/sphere_plane.hpp>

#include <optional>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using Direction = ansatz::Vector<double, 3>;
struct Ball {
    Place centre;
    Length radius;
};
struct HalfSpace {
    Direction normal;
    Length d;
};
struct Contact {
    Place point;
    Direction normal;
    Length depth;
};

/// The library's plane belongs to a body; here to one in the origin. Its offset is the notes' -d.
inline Place origin() { return ansatz::metres(0, 0, 0); }
inline ansatz::Plane plane_of(const HalfSpace& plane) { return {plane.normal, -plane.d}; }

inline HalfSpace half_space(const Direction& facing, const Place& point) {
    const ansatz::Plane::In<ansatz::Space<>> plane(ansatz::Plane::through(point, facing));
    return {plane.normal, -plane.offset};
}
inline Length height(const Place& place, const HalfSpace& plane) {
    return ansatz::Plane::In<ansatz::Space<>>(plane_of(plane)).height(place, origin());
}
inline std::optional<Contact> contact(const Ball& ball, const HalfSpace& plane) {
    const auto touch = ansatz::contact(ansatz::Sphere{ball.radius}, ball.centre, plane_of(plane), origin());
    if (!touch) return std::nullopt;
    return Contact{touch->point, touch->normal, touch->depth};
}

} // namespace exercise
