// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/narrowphase/narrowphase.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using Direction = ansatz::Vector<double, 3>;
struct Ball {
    Place centre;
    Length radius;
};

/// The library answers all four questions at once, because they share the distance.
inline auto contact(const Ball& first, const Ball& second) {
    return ansatz::contact(ansatz::Sphere{first.radius}, first.centre, ansatz::Sphere{second.radius}, second.centre);
}
inline bool intersect(const Ball& first, const Ball& second) { return contact(first, second).has_value(); }
inline Length penetration(const Ball& first, const Ball& second) { return contact(first, second).value().depth; }
inline Direction unit_normal(const Ball& first, const Ball& second) { return contact(first, second).value().normal; }
inline Place contact_point(const Ball& first, const Ball& second, const Direction&, Length) {
    return contact(first, second).value().point;
}

} // namespace exercise
