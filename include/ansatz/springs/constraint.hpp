// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A spring as a constraint: how far it is from its rest length, and along which directions its ends change that.
///
/// A force says what pulls now; a solver that works on positions (Xpbd, VertexBlockDescent) asks instead for a number
/// that should be zero, its gradient, and how stiff it is. `SpringConstraint` and `AnchoredSpringConstraint` say it of
/// Springs and Ropes, and are the pattern for constraints of your own: the concept is `ConstraintIn`
/// (soft_bodies/constraint.hpp).
///
/// \f[ C = |\mathbf x_b - \mathbf x_a| - l, \qquad E = \tfrac12 k C^2, \qquad \nabla_b C = \mathbf n = -\nabla_a C,
///     \qquad \nabla_b\nabla_b C = \frac{1 - \mathbf n \mathbf n^T}{L} \f]
///
/// Numbers are those of SI, without units: what a constraint measures is a length here, an angle or a volume elsewhere.

#include <ansatz/springs/hooke.hpp>
#include <ansatz/world/space.hpp>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace ansatz {

namespace detail {
/// The same for ends so near or so far apart that the square of their distance is none.
template <class S>
[[gnu::cold, gnu::noinline]] typename S::Scalar axis_by_scaling(Vector<typename S::Scalar, S::dimension> to,
                                                                Vector<typename S::Scalar, S::dimension>& axis) {
    if (!unit_vector(to, axis)) axis.setZero();
    return robust_norm(S::Position::from_value(to)).value();
}
/// The unit vector from one end to the other and their distance; zero for ends in one place, which have no axis.
template <class S>
[[gnu::always_inline]] inline typename S::Scalar axis_of(const Vector<typename S::Scalar, S::dimension>& to,
                                                         Vector<typename S::Scalar, S::dimension>& axis) {
    using std::sqrt;
    const typename S::Scalar squared = dot_of(to, to);
    if (!squares_well(squared)) return axis_by_scaling<S>(to, axis);
    const typename S::Scalar length = sqrt(squared);
    axis = to * (1 / length);
    return length;
}
} // namespace detail

/// A spring between two bodies, in numbers of SI.
/// \tparam How a rope only pulls
template <class S, springs::Acts How> struct SpringConstraint {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;                         ///< m, or a direction
    using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>; ///< of one body
    static constexpr std::size_t bodies = 2;                          ///< that it holds
    static constexpr bool unit_gradients = true;                      ///< by each body, or zero without an axis
    static constexpr bool one_sided = How == springs::Acts::pulling;  ///< whether it may be shorter than it should be
    static constexpr bool moves_along = true; ///< unchanged where all its bodies are moved by the same way

    std::array<std::size_t, 2> slots; ///< of its ends
    Scalar rest_length;               ///< l, m
    Scalar stiffness;                 ///< k, N/m
    Scalar damping;                   ///< c along the axis, N s/m

    /// C, m, and its gradient.
    [[gnu::always_inline]] Scalar linearise(const std::array<Vec, 2>& x, std::array<Vec, 2>& gradient) const {
        const Scalar length = detail::axis_of<S>(x[1] - x[0], gradient[1]);
        gradient[0] = -gradient[1];
        return length - rest_length;
    }
    /// The part of C's second derivative by one body that is never negative, 1/m: the same for both.
    /// \param gradient of `linearise`
    Matrix curvature(std::size_t, const std::array<Vec, 2>& x, const std::array<Vec, 2>& gradient) const {
        const Scalar length = robust_norm(S::Position::from_value(x[1] - x[0])).value();
        if (!(length > Scalar(0))) return Matrix::Zero();
        return (Matrix::Identity() - gradient[1] * gradient[1].transpose()) / length;
    }
};

/// A spring between a body and a point that nothing moves, in numbers of SI.
template <class S, springs::Acts How> struct AnchoredSpringConstraint {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;                         ///< m, or a direction
    using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>; ///< of one body
    static constexpr std::size_t bodies = 1;                          ///< that it holds
    static constexpr bool unit_gradients = true;                      ///< by each body, or zero without an axis
    static constexpr bool one_sided = How == springs::Acts::pulling;  ///< whether it may be shorter than it should be

    std::array<std::size_t, 1> slots; ///< of the body
    Scalar rest_length;               ///< l, m
    Scalar stiffness;                 ///< k, N/m
    Scalar damping;                   ///< c along the axis, N s/m
    Vec anchor;                       ///< the point, m

    /// C, m, and its gradient.
    [[gnu::always_inline]] Scalar linearise(const std::array<Vec, 1>& x, std::array<Vec, 1>& gradient) const {
        return detail::axis_of<S>(x[0] - anchor, gradient[0]) - rest_length;
    }
    /// As that of SpringConstraint.
    Matrix curvature(std::size_t, const std::array<Vec, 1>& x, const std::array<Vec, 1>& gradient) const {
        const Scalar length = robust_norm(S::Position::from_value(x[0] - anchor)).value();
        if (!(length > Scalar(0))) return Matrix::Zero();
        return (Matrix::Identity() - gradient[0] * gradient[0].transpose()) / length;
    }
};

} // namespace ansatz
