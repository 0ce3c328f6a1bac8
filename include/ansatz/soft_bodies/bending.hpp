// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Bending`: an angle between two triangles is kept, as a hinge with a spring keeps it (notes 4).
///
/// Use it for sheets that should resist folding and nothing else: paper, leather, sails, leaves. A spring across an
/// edge (`Cloth::bend`) does it too, but it hardly feels a small angle, resists being stretched as well, and does not
/// know which way a fold goes. Add the policy, then a `Hinge` for each edge, or give `Cloth` a `rigidity`. Not for hair
/// and ropes, which have no triangles, and not in two dimensions.
///
/// \f[ E = \tfrac12 k\,(\theta - \theta_0)^2, \qquad \theta = \operatorname{atan2}\bigl((\mathbf n_1 \times \mathbf n_2)\cdot\mathbf{\hat e},\;
///     \mathbf n_1 \cdot \mathbf n_2\bigr), \qquad \mathbf n_1 = \mathbf e \times (\mathbf x_c - \mathbf x_a), \quad
///     \mathbf n_2 = (\mathbf x_d - \mathbf x_a) \times \mathbf e \f]
///
/// | symbol     | meaning                                                                       | unit |
/// |------------|-------------------------------------------------------------------------------|------|
/// | a, b; e    | the ends of the edge, and the way from a to b                                  | m    |
/// | c, d       | the wings: the third vertices of the two triangles, c to the left of the edge | m    |
/// | theta      | 0 flat, positive where the wings lie below the normals' side (a ridge)        | rad  |
/// | theta_0    | the angle at rest                                                             | rad  |
/// | k, eta     | stiffness and damping of the hinge                                            | J, J s |
///
/// Angles are counted the shorter way round from theta_0, so that a fold can go through flat and back. A triangle that
/// has lost its area has no angle: its hinge does nothing until it has one again. The force grows as a triangle becomes
/// thin; `stable_step` follows.
///
/// R. Bridson, S. Marino, R. Fedkiw, Simulation of Clothing with Folds and Wrinkles, SCA 2003; E. Grinspun et al.,
/// Discrete Shells, SCA 2003, for the gradients and for what a hinge of a sheet is given.

#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/units/angle.hpp>
#include <ansatz/world/world.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <optional>
#include <string_view>

namespace ansatz {

/// An edge between two triangles that keeps their angle: what `World::add` takes of a world with `Bending`.
struct Hinge {
    using element = Hinge;                                           ///< marks it as one that World::add takes
    std::array<Handle, 2> edge = {};                                 ///< its ends
    std::array<Handle, 2> wings = {};                                ///< the third vertices of the two triangles
    Parameter<unit::Energy> stiffness = 0.0 * joule;                 ///< k, J for a squared radian, not negative
    Parameter<unit::AngularMomentum> damping = 0.0 * joule * second; ///< eta, J s, not negative
    std::optional<Parameter<unit::PlaneAngle>> rest = {};            ///< without it the angle that it has
};

/// A hinge as a constraint, in numbers of SI: \f$ C = \theta - \theta_0 \f$.
template <class S> struct HingeConstraint {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;                         ///< m, or 1/m
    using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>; ///< of one body
    static constexpr std::size_t bodies = 4;                          ///< the edge's ends, then the wings
    static constexpr bool one_sided = false;                          ///< it holds both ways
    static constexpr bool moves_along = true; ///< unchanged where all its bodies are moved by the same way

    std::array<std::size_t, 4> slots; ///< of its bodies
    Scalar rest;                      ///< rad
    Scalar stiffness;                 ///< J
    Scalar damping;                   ///< J s

    /// C, rad, and its gradient, 1/m.
    Scalar linearise(const std::array<Vec, 4>& x, std::array<Vec, 4>& gradient) const {
        using std::abs;
        using std::atan2;
        using std::sqrt;
        const Vec e = x[1] - x[0], c = x[2] - x[0], d = x[3] - x[0];
        const Vec n1 = e.cross(c), n2 = d.cross(e);
        const Scalar ee = e.squaredNorm(), first = n1.squaredNorm(), other = n2.squaredNorm();
        if (!detail::squares_well(first) || !detail::squares_well(other) || !detail::squares_well(ee)) {
            for (Vec& g : gradient) g.setZero();
            return Scalar(0);
        }
        const Scalar length = sqrt(ee);
        const Vec up1 = n1 * (length / first), up2 = n2 * (length / other);
        gradient[2] = -up1;
        gradient[3] = -up2;
        gradient[0] = ((ee - c.dot(e)) / ee) * up1 + ((ee - d.dot(e)) / ee) * up2;
        gradient[1] = (c.dot(e) / ee) * up1 + (d.dot(e) / ee) * up2;
        const Scalar turn = Scalar(6.283185307179586476925286766559);
        Scalar off = atan2(n1.cross(n2).dot(e) / length, n1.dot(n2)) - rest;
        if (off > turn / 2) off -= turn;
        else if (off < -turn / 2) off += turn;
        return off;
    }
    /// Zero: the second derivative of the angle may be negative, and only what is never negative may be added.
    Matrix curvature(std::size_t, const std::array<Vec, 4>&, const std::array<Vec, 4>&) const { return Matrix::Zero(); }
};

/// What is kept of a hinge.
template <class S> struct HingeRow {
    using Scalar = typename S::Scalar;
    std::array<BodyId, 4> bodies;                                   ///< the edge's ends, then the wings
    typename S::template ScalarOf<unit::Energy> stiffness{};        ///< J
    typename S::template ScalarOf<unit::AngularMomentum> damping{}; ///< J s
    typename S::template ScalarOf<unit::PlaneAngle> rest{};         ///< rad

    /// Names what it consists of.
    static void fields(auto& self, auto&& field) {
        field("bodies", self.bodies);
        field("stiffness", self.stiffness);
        field("damping", self.damping);
        field("rest", self.rest);
    }
    /// Of a description.
    /// \throws std::invalid_argument where two of its bodies are one, where a triangle has no area, and for bad numbers
    static HingeRow from(const auto& asked, const Hinge& hinge) {
        HingeRow row;
        row.bodies = {asked.body(hinge.edge[0]), asked.body(hinge.edge[1]), asked.body(hinge.wings[0]),
                      asked.body(hinge.wings[1])};
        row.check_bodies(asked.where);
        require_not_negative(asked.where, "stiffness", hinge.stiffness);
        require_not_negative(asked.where, "damping", hinge.damping);
        row.stiffness = S::convert("stiffness", hinge.stiffness);
        row.damping = S::convert("damping", hinge.damping);
        const std::array<Handle, 4> all{hinge.edge[0], hinge.edge[1], hinge.wings[0], hinge.wings[1]};
        std::array<Vector<Scalar, 3>, 4> x, gradient;
        for (std::size_t i = 0; i < 4; ++i) x[i] = asked.position(all[i]).value();
        const auto angle = HingeConstraint<S>{{}, Scalar(0), Scalar(1), Scalar(0)}.linearise(x, gradient);
        if (gradient[2].isZero(0))
            refuse_value(asked.where, "the area of a triangle of the hinge", "0 m^2",
                         "each wing lies beside the edge, and the edge has a length");
        if (hinge.rest) {
            require_finite(asked.where, "rest", *hinge.rest);
            row.rest = S::convert("rest", *hinge.rest);
        } else row.rest = decltype(row.rest)::from_value(angle);
        return row;
    }
    /// What it was made of.
    Hinge describe(const auto& handle_of) const {
        return {{handle_of(bodies[0]), handle_of(bodies[1])},
                {handle_of(bodies[2]), handle_of(bodies[3])},
                scalar_cast<double>(stiffness),
                scalar_cast<double>(damping),
                scalar_cast<double>(rest)};
    }
    /// Holds it against what a step relies on, whatever made it: a file, too.
    void check() const {
        check_bodies("a hinge");
        require_not_negative("a hinge", "stiffness", stiffness);
        require_not_negative("a hinge", "damping", damping);
        constexpr double half_turn = 3.14159274; // as float rounds it
        if (!(rest.value() >= Scalar(-half_turn) && rest.value() <= Scalar(half_turn)))
            refuse_value("a hinge", "rest", rest, "an angle lies between -pi and pi");
    }
    /// As a constraint.
    /// \param slot answers with the slot of a BodyId
    HingeConstraint<S> constraint(const auto& slot) const {
        return {{slot(bodies[0]), slot(bodies[1]), slot(bodies[2]), slot(bodies[3])},
                rest.value(),
                stiffness.value(),
                damping.value()};
    }

private:
    void check_bodies(std::string_view where) const {
        for (std::size_t i = 0; i < 4; ++i) {
            if (bodies[i] == BodyId()) refuse_value(where, "one of its bodies", "nobody", "a hinge is between four");
            for (std::size_t j = 0; j < i; ++j)
                if (bodies[i] == bodies[j])
                    refuse_value(where, "two of its bodies", "one", "a hinge is between four different ones");
        }
    }
};

/// Hinges between the triangles of surfaces.
struct Bending : ConstraintForce<Hinge, HingeRow> {
    static constexpr std::string_view name = "Bending"; ///< in a saved file

    /// Bound to a space.
    template <class S> struct In : ConstraintForce<Hinge, HingeRow>::In<S> {
        static_assert(S::dimension == 3,
                      "Ansatz: Bending is of triangles that fold, so of a world of three dimensions; "
                      "leave it out of one of two");
        explicit In(const Bending& bending) : ConstraintForce<Hinge, HingeRow>::In<S>(bending) {}
    };
};

/// The angle of a hinge as its bodies are now, rad, from -pi to pi; 0 where a triangle has no area.
/// \throws std::out_of_range for a stale handle
template <class... P> auto hinge_angle(const World<P...>& world, ElementHandle<Hinge> which) {
    using S = typename World<P...>::S;
    const auto view = world.template view<Bending>();
    auto flat = view.state().row(view.state().id(which, "hinge_angle"));
    flat.rest = {};
    const auto hinge = flat.constraint([&](BodyId body) { return std::size_t(view.slot(body)); });
    std::array<typename HingeConstraint<S>::Vec, 4> x, gradient;
    for (std::size_t i = 0; i < 4; ++i) x[i] = view.template get<Position>(hinge.slots[i]).value();
    return S::template ScalarOf<unit::PlaneAngle>::from_value(hinge.linearise(x, gradient));
}

} // namespace ansatz
