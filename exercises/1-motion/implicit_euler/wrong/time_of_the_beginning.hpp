// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: the forces asked for the beginning of the step
// Why:     The state is that of the end, and so is the time: a force that changes by itself is taken at part 1.0 of
//          the step.
// Read:    1.6.2
// Fails:   end

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
        auto u = v;
        bool solved = false;
        for (int i = 0; i < most_iterations && !solved; ++i) {
            const auto residual = u - v - laws(x + u * dt, u, 0.0) * dt;
            const auto slope = laws.jacobian(x + u * dt, u, 0.0);
            const auto correction =
                solution_of(unit_matrix(u) - slope.velocity * dt - slope.position * dt * dt, residual);
            u -= correction;
            solved = is_rounding(correction, u, x, dt);
        }
        v = u;
        x += u * dt;
        return solved;
    }
};

/// What part of the energy of a mass on a spring, (v^2 + omega^2 x^2) / 2 for each kilogram, is left after one step of
/// implicit Euler. It is the same in every step, whatever x and v are.
inline double energy_factor(Quantity<unit::Frequency> omega, Quantity<unit::Time> dt) {
    const double angle = omega * dt;
    return 1 / (1 + angle * angle);
}

} // namespace exercise
