// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `submerged`: how much of a sphere, or of an upright box, is under a level surface, and where the middle of that part
/// is (notes 7.4, buoyancy).
///
/// Use it for Archimedes' force, \f$ \rho g V \f$, with water of your own; in a world `Buoyancy` does that. The
/// formulas are exact, so that the force has no step where a body touches the water or goes under, and no sampled
/// points stand for a shape. Under a level surface a box is upright; `submerged(box, normal, height)` is that of a box
/// under a tilted one, or of a tilted box: turn the normal into its frame. Bodies of a world do not turn yet, and
/// Buoyancy takes the first.
///
/// | symbol | meaning                                                | unit |
/// |--------|--------------------------------------------------------|------|
/// | d      | depth of the lowest point, held to 0 up to the height  | m    |
/// | V      | volume under water                                     | m^3  |
/// | c      | height of its centroid above the lowest point          | m    |
/// | A      | area of the section at the water line, dV/dd           | m^2  |
///
/// \f[ \text{sphere:}\quad V = \frac{\pi d^2 (3r - d)}{3}, \quad c = r - \frac{3 (2r - d)^2}{4 (3r - d)},
/// \quad A = \pi d (2r - d); \qquad \text{box:}\quad V = A d, \quad c = \frac d 2 \f]

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/sphere.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/space.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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
    const Scalar x = d / (Scalar(2) * r), least = std::numeric_limits<Scalar>::epsilon();
    if (x * x * x * x * x < Scalar(100) * least) {
        // Segment and triangle would leave nothing but their rounding. The root of (1 - y / 2r) as a series, times
        // that of y, and for the moment times y, integrated.
        const auto sum = [&](int power) { // of 2 / (power + 2 k) times the binomial (1/2 over k) times (-x)^k
            const auto term = [&](int k, double binomial) { return Scalar(2 * binomial) / Scalar(power + 2 * k); };
            return term(0, 1) -
                   x * (term(1, 0.5) + x * (term(2, 0.125) + x * (term(3, 0.0625) + x * term(4, 0.0390625))));
        };
        const Scalar area = Scalar(2) * d * sqrt(Scalar(2) * r * d) * sum(3);
        return {area * length, d * sum(5) / sum(3), Scalar(2) * half * length};
    }
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

/// The part of a box that is under a tilted surface.
struct SubmergedBox {
    Quantity<unit::Volume> volume;       ///< V, m^3
    VectorQuantity<unit::Length> centre; ///< of its centroid, from the middle of the box, m; zero where V is
};
/// Of a box under any plane, exactly: the pyramids from a point of the surface in the box over what of each face is
/// under it. That of the surface itself has no height.
/// \param box    three half lengths, finite and positive
/// \param normal of the surface, in the frame of the box, towards the air; of any length but 0, finite
/// \param height of the surface above the middle of the box, along the normal, m; not NaN
/// \throws std::invalid_argument for other values
inline SubmergedBox submerged(const Box& box, const Vector<double, 3>& normal, const Quantity<unit::Length>& height) {
    using Point = Vector<double, 3>;
    const Point half = Box::In<Space<double, 3>>(box).half.value();
    Point n = normal;
    if (const double most = normal.cwiseAbs().maxCoeff(); !(n.norm() > 0 && is_finite(n.norm())) && most > 0)
        n /= most; // of squares that are no numbers, of a length that is one
    const double length = n.norm();
    if (!(length > 0) || !is_finite(length))
        refuse_value("submerged", "the length of the normal", length, "it must be finite and greater than zero");
    if (std::isnan(height.value())) refuse_value("submerged", "height", height, "it must be a number");
    n /= length;
    const double reach = n.cwiseAbs().dot(half), d = std::max(-reach, std::min(reach, height.value()));
    // On the diagonal from the lowest corner to the highest, and so in the box: seen from there no pyramid is negative.
    // Seen from outside large ones would cancel, and leave the rounding of a box that hardly touches the water.
    const Point apex = d / reach * (n.array() < 0).select(-half, half);
    double volume = 0;
    Point moment = Point::Zero();
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::array<Point, 8> cut; // four corners, cut by one plane: five
            std::size_t count = 0;
            auto corner = [&](int k) {
                Point at;
                at[axis] = side * half[axis];
                at[u] = (k == 1 || k == 2 ? 1 : -1) * side * half[u]; // anticlockwise, seen from outside
                at[v] = (k >= 2 ? 1 : -1) * half[v];
                return at;
            };
            for (int k = 0; k < 4; ++k) {
                const Point here = corner(k), next = corner((k + 1) % 4);
                const double over = n.dot(here) - d, over_next = n.dot(next) - d;
                if (over <= 0) cut[count++] = here;
                if ((over < 0 && over_next > 0) || (over > 0 && over_next < 0))
                    cut[count++] = here + over / (over - over_next) * (next - here);
            }
            for (std::size_t k = 2; k < count; ++k) {
                const Point a = cut[0] - apex, b = cut[k - 1] - apex, c = cut[k] - apex;
                const double part = a.dot(b.cross(c)) / 6;
                volume += part;
                moment += part * (apex + (a + b + c) / 4);
            }
        }
    SubmergedBox all{std::clamp(volume, 0.0, 8 * half.prod()) * cubic_metre, metres(0, 0, 0)};
    if (volume > 0)
        all.centre = VectorQuantity<unit::Length>::from_value(Point((moment / volume).cwiseMax(-half).cwiseMin(half)));
    return all;
}

} // namespace ansatz
