// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Plane`: a half-space, solid below its surface: ground, walls, slopes (notes 2.1.2).
///
/// The notes write ax + by + cz + d = 0 with N = (a, b, c). Here a plane is given by N and by how far its surface lies
/// from the body's position along N, `offset` = -d: N . (x - position) = offset. It has no end and no box, so that
/// it is held against every body: have a few, not a thousand. Solid is the side that N points away from; whatever
/// is below the surface, however deep, is pushed out along N.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <cmath>
#include <limits>
#include <string_view>

namespace ansatz {

/// All points x with \f$ \mathbf N \cdot (\mathbf x - \mathbf x_{body}) \le offset \f$.
struct Plane {
    using shape = Plane;                   ///< it is a shape
    static constexpr bool bounded = false; ///< no box holds it

    /// N; any length but zero, it is made a unit vector. In two dimensions the third component must be zero.
    VectorParameter<unit::Dimensionless> normal = Eigen::Vector3d(0, 1, 0);
    /// m, along the unit normal from the body's position to the surface
    Parameter<unit::Length> offset = 0.0 * metre;

    /// The ground: its surface at this height, y upwards.
    static Plane ground(Quantity<unit::Length> height = 0.0 * metre) { return {Eigen::Vector3d(0, 1, 0), height}; }
    /// The plane with this normal whose surface goes through a point, seen from the body's position.
    template <class N, class X> static Plane through(const X& point, const N& normal) {
        Plane plane{normal, {}};
        const VectorParameter<unit::Length> x(point);
        plane.offset = Quantity<unit::Length>::from_value(plane.normal.value().stableNormalized().dot(x.value()));
        return plane;
    }

    static constexpr std::string_view name = "Plane";
    static void parameters(auto& self, auto&& visit) {
        visit("normal", self.normal);
        visit("offset", self.offset);
    }
    /// \throws std::invalid_argument for a normal without a direction, and for an offset that is not finite
    void check() const {
        require_finite("Plane", "normal", normal);
        if (!(normal.value().cwiseAbs().maxCoeff() > 0))
            refuse_value("Plane", "normal", normal, "it has a direction; the ground's is (0, 1, 0)");
        require_finite("Plane", "offset", offset);
    }

    /// In the scalar of a space.
    template <class S> struct In {
        using description = Plane;                       ///< what it was made from
        Vector<typename S::Scalar, S::dimension> normal; ///< a unit vector
        typename S::Length offset;                       ///< m
        explicit In(const Plane& plane)
            : normal(S::convert("Plane::normal",
                                VectorQuantity<unit::Dimensionless, 3>(plane.normal.value().stableNormalized()))
                         .value()),
              offset(S::convert(plane.offset)) {}

        static constexpr bool grows_evenly = true; ///< grown by d it is exactly what is within d of it
        /// One that is higher along its normal.
        [[gnu::always_inline]] In grown(const typename S::Length& by) const {
            In higher(*this);
            higher.offset += by;
            return higher;
        }
        /// How far a point is above the surface of the plane at position `x`, m; negative below it.
        [[gnu::always_inline]] typename S::Length height(const typename S::Position& point,
                                                         const typename S::Position& x) const {
            return dot(point - x, normal) - offset;
        }
        /// Whether a box is above the surface of the plane at position `x` by more than rounding, so that nothing in it
        /// touches the plane. All in m.
        [[gnu::always_inline]] bool misses(const Vector<typename S::Scalar, S::dimension>& lower,
                                           const Vector<typename S::Scalar, S::dimension>& upper,
                                           const Vector<typename S::Scalar, S::dimension>& x) const {
            using std::abs;
            using Scalar = typename S::Scalar;
            Scalar height = -offset.value(), size = abs(height); // of the box's lowest corner along the normal
            for (int k = 0; k < S::dimension; ++k) {
                const Scalar up = normal[k] > Scalar(0) ? normal[k] : Scalar(0), down = normal[k] - up;
                height += up * lower[k] + down * upper[k] - normal[k] * x[k];
                size += abs(normal[k]) * (abs(lower[k]) + abs(upper[k]) + abs(x[k]));
            }
            return height > 32 * std::numeric_limits<Scalar>::epsilon() * size;
        }
    };
};

} // namespace ansatz
