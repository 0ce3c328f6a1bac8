// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `submerged`: how much of a sphere, or of an upright box, is under a level surface, and where the middle of that part
/// is (notes 7.4, buoyancy).
///
/// Use it for Archimedes' force, \f$ \rho g V \f$, with water of your own; in a world `Buoyancy` does that. The formulas are
/// exact, so that the force has no step where a body touches the water or goes under, and no sampled points stand for a
/// shape. Bodies do not turn yet: a box is upright, and a tilted surface is taken level over the width of the body.
///
/// | symbol | meaning                                                | unit |
/// |--------|--------------------------------------------------------|------|
/// | d      | depth of the lowest point, held to 0 up to the height  | m    |
/// | V      | volume under water                                     | m^3  |
/// | c      | height of its centroid above the lowest point          | m    |
/// | A      | area of the section at the water line, dV/dd           | m^2  |
///
/// \f[ \text{sphere:}\quad V = \frac{\pi d^2 (3r - d)}{3}, \quad c = r - \frac{3 (2r - d)^2}{4 (3r - d)}, \quad A = \pi d (2r - d);
/// \qquad \text{box:}\quad V = A d, \quad c = \frac d 2 \f]

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/sphere.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/space.hpp>

#include <cmath>
#include <numbers>

namespace ansatz {

namespace detail {
/// What is under water, raw SI.
template <class Scalar> struct Sunk {
    Scalar volume{}, centre{}, waterline{};
};
template <class Scalar> Scalar held_to(const Scalar& d, const Scalar& height) {
    return d > Scalar(0) ? (d < height ? d : height) : Scalar(0);
}
template <class Scalar> Sunk<Scalar> sunk_sphere(const Scalar& r, const Scalar& depth) {
    const Scalar d = held_to(depth, Scalar(2) * r), pi(std::numbers::pi), rest = Scalar(2) * r - d;
    return {pi * d * d * (Scalar(3) * r - d) / Scalar(3),
            r - Scalar(3) * rest * rest / (Scalar(4) * (Scalar(3) * r - d)), pi * d * rest};
}
/// A cylinder that lies along z, of a length: the disc of a world of two dimensions.
template <class Scalar> Sunk<Scalar> sunk_disc(const Scalar& r, const Scalar& length, const Scalar& depth) {
    using std::acos;
    using std::sqrt;
    const Scalar d = held_to(depth, Scalar(2) * r), half = sqrt(d * (Scalar(2) * r - d));
    const Scalar segment = r * r * acos(Scalar(1) - d / r) - (r - d) * half,
                 area = segment > Scalar(0) ? segment : Scalar(0);
    const Scalar below = area > Scalar(0) ? Scalar(2) * half * half * half / (Scalar(3) * area) : r;
    return {area * length, below < r ? r - below : Scalar(0), Scalar(2) * half * length};
}
template <class Scalar> Sunk<Scalar> sunk_box(const Scalar& section, const Scalar& height, const Scalar& depth) {
    const Scalar d = held_to(depth, height);
    return {section * d, d / Scalar(2), d > Scalar(0) && d < height ? section : Scalar(0)};
}
} // namespace detail

/// The part of a body that is under water.
struct Submerged {
    Quantity<unit::Volume> volume;  ///< V, m^3
    Quantity<unit::Length> centre;  ///< of its centroid above the lowest point of the body, m
    Quantity<unit::Area> waterline; ///< dV/dd, m^2; 0 where it does not reach the surface
};

namespace detail {
inline Submerged submerged_of(const Sunk<double>& s) {
    return {s.volume * cubic_metre, s.centre * metre, s.waterline * square_metre};
}
} // namespace detail

/// Of a sphere.
/// \param sphere its radius is finite and positive
/// \param depth  of its lowest point under the surface, m; not NaN; negative above it
/// \throws std::invalid_argument for other values
inline Submerged submerged(const Sphere& sphere, const Quantity<unit::Length>& depth) {
    sphere.check();
    if (std::isnan(depth.value())) refuse_value("submerged", "depth", depth, "it must be a number");
    return detail::submerged_of(detail::sunk_sphere(Quantity<unit::Length>(sphere.radius).value(), depth.value()));
}
/// Of an upright box.
/// \param box   three half lengths, finite and positive
/// \param depth of its lower face under the surface, m; not NaN; negative above it
/// \throws std::invalid_argument for other values
inline Submerged submerged(const Box& box, const Quantity<unit::Length>& depth) {
    const Box::In<Space<double, 3>> in(box);
    if (std::isnan(depth.value())) refuse_value("submerged", "depth", depth, "it must be a number");
    const auto half = in.half.value();
    return detail::submerged_of(detail::sunk_box(4 * half[0] * half[2], 2 * half[1], depth.value()));
}

} // namespace ansatz
