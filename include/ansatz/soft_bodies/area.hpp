// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Area`: a triangle keeps its area, whatever its shape (notes 4).
///
/// Use it for skin that gives way in its plane like a film of water, beside springs that hold its shape; and in two
/// dimensions for soft bodies of triangles that must not be turned inside out: there an area has a sign, and a triangle
/// that was pushed through itself finds its way back. In three dimensions a triangle without an area has no plane, and
/// feels nothing. Add the policy, then a `Membrane` for each triangle. Not for a volume: that is `Pressure`.
///
/// \f[ E = \tfrac12 \frac K{A_0}\,(A - A_0)^2, \qquad A = \tfrac12 |(\mathbf x_b - \mathbf x_a) \times (\mathbf x_c - \mathbf x_a)|
///     \quad \text{(in two dimensions with its sign)} \f]
///
/// | symbol | meaning                                                                         | unit  |
/// |--------|---------------------------------------------------------------------------------|-------|
/// | A, A_0 | the area, and that at rest                                                        | m^2   |
/// | K      | `stiffness` of the film: the tension along every line, over (A - A_0) / A_0       | N/m   |
/// | c      | `damping`: that tension over the rate of (A - A_0) / A_0                          | N s/m |
///
/// K does not depend on how fine a surface is divided.

#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/world/space.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace ansatz {

/// A triangle that keeps its area: what `World::add` takes of a world with `Area`.
struct Membrane {
    using element = Membrane;                                         ///< marks it as one that World::add takes
    std::array<Handle, 3> corners = {};                               ///< its bodies; in a plane anticlockwise
    Parameter<unit::Stiffness> stiffness = 0.0 * newton_per_metre;    ///< K, N/m, not negative
    Parameter<unit::Damping> damping = 0.0 * newton_second_per_metre; ///< c, N s/m, not negative
    std::optional<Parameter<unit::Area>> area = {};                   ///< A_0, m^2, greater than zero; else what it has
};

/// The area of a triangle as a constraint, in numbers of SI: \f$ C = A - A_0 \f$.
template <class S> struct AreaConstraint {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;                         ///< m
    using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>; ///< of one body
    static constexpr std::size_t bodies = 3;                          ///< its corners
    static constexpr bool one_sided = false;                          ///< it holds both ways
    static constexpr bool moves_along = true; ///< unchanged where all its bodies are moved by the same way

    std::array<std::size_t, 3> slots; ///< of its corners
    Scalar area;                      ///< A_0, m^2
    Scalar stiffness;                 ///< K / A_0, N/m^3
    Scalar damping;                   ///< c / A_0, N s/m^3

    /// C, m^2, and its gradient, m.
    Scalar linearise(const std::array<Vec, 3>& x, std::array<Vec, 3>& gradient) const {
        using std::sqrt;
        const Vec u = x[1] - x[0], v = x[2] - x[0];
        if constexpr (S::dimension == 2) {
            gradient[1] = Vec(v[1], -v[0]) / 2;
            gradient[2] = Vec(-u[1], u[0]) / 2;
            gradient[0] = -gradient[1] - gradient[2];
            return (u[0] * v[1] - u[1] * v[0]) / 2 - area;
        } else {
            const Vec normal = u.cross(v);
            const Scalar squared = normal.squaredNorm();
            if (!detail::squares_well(squared)) {
                for (Vec& g : gradient) g.setZero();
                return -area;
            }
            const Scalar twice = sqrt(squared);
            const Vec up = normal / (2 * twice);
            gradient[1] = v.cross(up);
            gradient[2] = up.cross(u);
            gradient[0] = -gradient[1] - gradient[2];
            return twice / 2 - area;
        }
    }
    /// Of a corner: as it leaves the plane, its distance from the opposite side grows. In a plane there is none.
    Matrix curvature(std::size_t body, const std::array<Vec, 3>& x, const std::array<Vec, 3>&) const {
        if constexpr (S::dimension == 2) return Matrix::Zero();
        else {
            using std::sqrt;
            const Vec side = x[(body + 2) % 3] - x[(body + 1) % 3], normal = (x[1] - x[0]).cross(x[2] - x[0]);
            const Scalar squared = normal.squaredNorm();
            if (!detail::squares_well(squared)) return Matrix::Zero();
            return side.squaredNorm() / (2 * sqrt(squared) * squared) * normal * normal.transpose();
        }
    }
};

/// What is kept of a membrane.
template <class S> struct MembraneRow {
    using Scalar = typename S::Scalar;
    std::array<BodyId, 3> corners;                              ///< its bodies
    typename S::template ScalarOf<unit::Stiffness> stiffness{}; ///< N/m
    typename S::template ScalarOf<unit::Damping> damping{};     ///< N s/m
    typename S::template ScalarOf<unit::Area> area{};           ///< m^2

    /// Names what it consists of.
    static void fields(auto& self, auto&& field) {
        field("corners", self.corners);
        field("stiffness", self.stiffness);
        field("damping", self.damping);
        field("area", self.area);
    }
    /// Of a description.
    /// \throws std::invalid_argument where two corners are one, for bad numbers, and where it has no area and is given
    /// none
    static MembraneRow from(const auto& asked, const Membrane& m) {
        MembraneRow row;
        for (std::size_t i = 0; i < 3; ++i) row.corners[i] = asked.body(m.corners[i]);
        detail::check_corners(asked.where, row.corners);
        require_not_negative(asked.where, "stiffness", m.stiffness);
        require_not_negative(asked.where, "damping", m.damping);
        row.stiffness = S::convert("stiffness", m.stiffness);
        row.damping = S::convert("damping", m.damping);
        if (m.area) {
            require_positive(asked.where, "area", *m.area);
            row.area = S::convert("area", *m.area);
        } else {
            std::array<Vector<Scalar, S::dimension>, 3> x, gradient;
            for (std::size_t i = 0; i < 3; ++i) x[i] = asked.position(m.corners[i]).value();
            row.area = decltype(row.area)::from_value(AreaConstraint<S>{{}, 0, 0, 0}.linearise(x, gradient));
            if (!(row.area.value() > Scalar(0)))
                refuse_value(asked.where, "the area of the triangle", row.area,
                             "it is greater than zero; in a plane its corners run anticlockwise");
        }
        return row;
    }
    /// What it was made of.
    Membrane describe(const auto& handle_of) const {
        return {{handle_of(corners[0]), handle_of(corners[1]), handle_of(corners[2])},
                scalar_cast<double>(stiffness),
                scalar_cast<double>(damping),
                scalar_cast<double>(area)};
    }
    /// Holds it against what a step relies on, whatever made it: a file, too.
    void check() const {
        detail::check_corners("a membrane", corners);
        require_not_negative("a membrane", "stiffness", stiffness);
        require_not_negative("a membrane", "damping", damping);
        require_positive("a membrane", "area", area);
        if (!is_finite(stiffness / area) || !is_finite(damping / area))
            refuse_value(
                "a membrane", "area", area,
                "it resists a change of it by more than the world's scalar can hold: give it more area, or less "
                "stiffness and damping");
    }
    /// As a constraint.
    /// \param slot answers with the slot of a BodyId
    AreaConstraint<S> constraint(const auto& slot) const {
        return {{slot(corners[0]), slot(corners[1]), slot(corners[2])},
                area.value(),
                stiffness.value() / area.value(),
                damping.value() / area.value()};
    }
};

/// Triangles that keep their areas.
struct Area : ConstraintForce<Membrane, MembraneRow> {
    static constexpr std::string_view name = "Area"; ///< in a saved file
};

} // namespace ansatz
