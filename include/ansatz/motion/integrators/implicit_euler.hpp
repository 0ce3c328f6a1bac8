// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ImplicitEuler`: the rate of change in the *next* state, found by solving for it (notes 1.6.2).
///
/// Use it for stiff forces whose fast motion nobody wants to see: it never grows, at any step. The price is a solve in
/// every step, a Jacobian from every force, and damping that nature does not have: at omega = 10/s and 60 Hz it loses
/// 81 % of its energy in a second. Not for orbits or anything that should keep its energy.
///
/// "Solved" is meant: Newton's method with the forces' Jacobians. Repeating x = x + v dt, v = v + a dt until nothing
/// moves (fixed-point iterations) converges only while omega dt < 1, just where no implicit method was needed.
///
/// Where nothing couples bodies, each is solved by itself. Where springs couple them, all are solved together, as one
/// sparse system: `ImplicitEuler` with conjugate gradients (conjugate_gradient.hpp), `ImplicitEulerBy<Cholesky>` with a
/// direct solver (cholesky.hpp), and cloth by `ImplicitEulerBy<MatrixFree>` (matrix_free.hpp), which is roughly a
/// hundred times quicker there than the first at its exact default, and a little less accurate.

#include <ansatz/motion/concepts.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace ansatz {

struct ConjugateGradient;                                    // conjugate_gradient.hpp
struct Cholesky;                                             // cholesky.hpp
struct MatrixFree;                                           // matrix_free.hpp
template <class S, class LinearSolver> class ImplicitSystem; // implicit_system.hpp, which both of them include

/// \f$ v_{n+1} = v_n + a(x_{n+1}, v_{n+1})\,\Delta t, \quad x_{n+1} = x_n + v_{n+1}\,\Delta t \f$
/// \tparam LinearSolver for worlds whose bodies are coupled: ConjugateGradient, Cholesky, MatrixFree, or one of your own
template <class LinearSolver> struct ImplicitEulerBy {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr bool needs_jacobian = true;
    static constexpr double velocity_leads = 0.5; ///< of a step: v + leads a dt is the velocity where x is
    static constexpr int order = 1;
    using linear_solver = LinearSolver; ///< for worlds whose bodies are coupled

    /// Where bodies are coupled: Newton's method ends when the residual is this fraction of what it was at the
    /// beginning; less than 1. Each linear system is solved as accurately, with MatrixFree only as accurately as
    /// Newton's method can use. 0 is the linear solver's own: 1e-10 with conjugate gradients, rounding with factors,
    /// 1e-2 with MatrixFree. Bodies that nothing couples are solved to rounding always, which takes two or three
    /// iterations.
    double tolerance = 0;
    /// Newton's iterations before a body, or a step in which bodies are coupled, counts as unsolved (`World::status`).
    /// One, with MatrixFree, is the step of Baraff and Witkin (1998).
    int most_iterations = 50;

    static constexpr std::string_view name = "ImplicitEuler";
    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) {
        visit("tolerance", self.tolerance);
        visit("most_iterations", self.most_iterations);
    }
    /// Refuses a tolerance that is negative or not below 1, and fewer than one iteration.
    void check() const {
        if (!(tolerance >= 0 && tolerance < 1))
            refuse_value(name, "tolerance", tolerance, "it is at least 0 and less than 1");
        if (most_iterations < 1) refuse_value(name, "most_iterations", most_iterations, "it is at least 1");
    }

    /// Solves for all bodies at once, where forces couple them.
    template <class S> using Together = ImplicitSystem<S, LinearSolver>;

    /// One body, without a world, with the parameters that are the default.
    /// \return as that of In
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        using Vec = typename std::remove_cvref_t<decltype(v)>::value_type;
        return In<Space<typename Vec::Scalar, Vec::RowsAtCompileTime>>(ImplicitEulerBy{}).solve(x, v, laws, dt);
    }

    /// Bound to a space.
    template <class S> struct In {
        double tolerance;    ///< what fraction of the residual may be left
        int most_iterations; ///< of Newton's method

        /// Takes the parameters.
        explicit In(const ImplicitEulerBy& integrator)
            : tolerance(integrator.tolerance), most_iterations(integrator.most_iterations) {}

        /// Newton's method for the new velocity u of one body: r(u) = u - v - dt a(x + dt u, u) = 0, with
        /// dr/du = 1 - dt da/dv - dt^2 da/dx. A step that makes the residual larger is halved.
        /// \return whether it converged; if not, the body has moved with the best velocity that was found
        bool solve(auto& x, auto& v, const auto& laws, const auto& dt) const {
            using V = std::remove_cvref_t<decltype(v)>;
            using Vec = typename V::value_type;
            using Scalar = typename Vec::Scalar;
            constexpr int dimension = Vec::RowsAtCompileTime;
            const Scalar accurate = 16 * std::numeric_limits<Scalar>::epsilon();

            auto residual = [&](const V& u) { return u - v - laws(x + u * dt, u, 1.0) * dt; };
            V u = v;
            V r = residual(u);
            bool converged = false;
            for (int i = 0; i < most_iterations && !converged && is_finite(r); ++i) {
                const auto j = laws.jacobian(x + u * dt, u, 1.0);
                const Scalar h = dt.value();
                const Eigen::Matrix<Scalar, dimension, dimension> matrix =
                    Eigen::Matrix<Scalar, dimension, dimension>::Identity() - h * j.velocity.value() -
                    h * h * j.position.value();
                const Vec correction = solve_rows(matrix, r.value());
                V step = V::from_value(correction);
                if (!is_finite(step)) break;
                V next = u - step;
                V next_r = residual(next);
                const Scalar size = norm(u).value() + norm(v).value();
                // Halving is for the way there; within rounding of the solution the residual cannot fall any more.
                const Scalar close = Scalar(1e3) * accurate * size;
                for (int half = 0; half < 30 && !(norm(next_r) <= norm(r)) && norm(step).value() > close; ++half) {
                    step *= Scalar(0.5);
                    next = u - step;
                    next_r = residual(next);
                }
                const bool steady = norm(step).value() <= accurate * (norm(next).value() + norm(v).value());
                const bool rounding = norm(step).value() <= close && !(norm(next_r) < norm(r));
                if (!rounding || steady) {
                    u = next;
                    r = next_r;
                }
                converged = steady || rounding;
            }
            if (is_finite(u)) v = u;
            x += v * dt;
            return converged;
        }

    private:
        /// Solves two or three linear equations by Eigen's closed form of the inverse. Each row is divided by its
        /// largest coefficient first, so that the determinant neither overflows nor vanishes with the stiffness; what
        /// rounding leaves, Newton's next correction removes. (Eigen's pivoting LU is as good, and takes three seconds
        /// to compile in every world.)
        template <class Matrix, class Vec> static Vec solve_rows(Matrix matrix, Vec right) {
            using std::abs;
            using Scalar = typename Vec::Scalar;
            constexpr int n = Vec::RowsAtCompileTime;
            for (int i = 0; i < n; ++i) {
                Scalar largest(0);
                for (int k = 0; k < n; ++k)
                    if (largest < abs(matrix(i, k))) largest = abs(matrix(i, k));
                for (int k = 0; k < n; ++k) matrix(i, k) /= largest;
                right[i] /= largest;
            }
            // Written out: Eigen's product may use a fused multiply-add where the machine has one, and worlds would
            // differ with it.
            const Matrix inverse = matrix.inverse();
            Vec solution;
            for (int i = 0; i < n; ++i) {
                solution[i] = inverse(i, 0) * right[0];
                for (int k = 1; k < n; ++k) solution[i] += inverse(i, k) * right[k];
            }
            return solution;
        }
    };
};

/// Implicit Euler; where bodies are coupled, with conjugate gradients.
using ImplicitEuler = ImplicitEulerBy<ConjugateGradient>;

} // namespace ansatz
