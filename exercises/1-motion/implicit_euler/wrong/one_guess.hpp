// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the state at the end predicted by one explicit step
// Why:     The acceleration at the end needs the state at the end, and an explicit step does give one: but not the
//          one that the implicit step leads to. What comes out is an explicit method, and it explodes like one.
// Read:    1.6.2
// Fails:   soft, stiff, damper, bent, hopeless, world

#include <ansatz/world.hpp>

#include <limits>

using namespace ansatz;

namespace exercise {

/// \name Given, so that the exercise is about Newton's method and not about matrices
/// @{

/// The matrix with ones in its diagonal, of the dimension of the vector `like`.
template <class V> auto unit_matrix(const V& like) {
    using Vec = typename V::value_type;
    constexpr int n = Vec::RowsAtCompileTime;
    using Matrix = Eigen::Matrix<typename Vec::Scalar, n, n>;
    return Quantity<unit::Dimensionless, Matrix>::from_value(Matrix::Identity());
}
/// The c for which matrix * c = right; the matrix has no unit.
template <class Matrix, class V> V solution_of(const Matrix& matrix, const V& right) {
    return V::from_value(matrix.value().inverse() * right.value());
}
/// Whether a correction of the velocity u moves a body at x by no more than the rounding of its place.
bool is_rounding(const auto& correction, const auto& u, const auto& x, const auto& dt) {
    using Scalar = std::remove_cvref_t<decltype(dt.value())>;
    return is_finite(norm(correction)) &&
           norm(correction) * dt <= 16 * std::numeric_limits<Scalar>::epsilon() * (norm(x) + norm(u) * dt);
}
/// @}

/// 1.6.2: v' = v + a(x', v') dt and x' = x + v' dt, solved for the state at the end of the step.
struct ImplicitEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr bool needs_jacobian = true;
    static constexpr int order = 1;
    static constexpr int most_iterations = 50;

    /// Change x (m) and v (m/s) to what they are dt (s) later.
    /// \param laws `laws(x, v, 1.0)` is the acceleration at the end of the step; `laws.jacobian(x, v, 1.0)` has its
    ///             derivatives `.position` (1/s^2) and `.velocity` (1/s)
    /// \return whether the equation was solved in at most most_iterations corrections
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        const auto guess = v + laws(x, v, 0.0) * dt;
        v += laws(x + guess * dt, guess, 1.0) * dt;
        x += v * dt;
        return true;
    }
};

/// What part of the energy of a mass on a spring, (v^2 + omega^2 x^2) / 2 for each kilogram, is left after one step of
/// implicit Euler. It is the same in every step, whatever x and v are.
inline double energy_factor(Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    const double angle = omega * dt;
    return 1 / (1 + angle * angle);
}

} // namespace exercise
