// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ConjugateGradient`: the iterative solver of implicit steps, and what ImplicitEuler uses unless told otherwise.
// not in the umbrella: only worlds that couple bodies and solve need it, and Eigen's sparse module takes half a second
///
/// Use it for chains, cloth and everything else whose bodies have few neighbours: its work grows with the springs, it
/// needs no more memory than the matrix, and a warm step allocates nothing. Take Cholesky (cholesky.hpp) where a system
/// is small and very stiff, with springs a million times stiffer than others. The loop is our own, on Eigen's matrix
/// and preconditioner, because Eigen's allocates in every call; sums are made in one order that no compiler changes.
///
/// M. R. Hestenes, E. Stiefel, J. Res. Natl. Bur. Stand. 49, 409 (1952).

#include <ansatz/motion/integrators/implicit_system.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <limits>

namespace ansatz {

/// Solves A x = b for a symmetric, positive definite A, until \f$ |b - Ax| \le \epsilon |b| \f$.
struct ConjugateGradient {
    static constexpr double tolerance = 1e-10;         ///< epsilon, but no less than some roundings of the scalar
    static constexpr bool pattern_may_grow_old = true; ///< zeros in the matrix change nothing, not even the last bit

    /// What it keeps between steps.
    template <class Scalar> class Solver {
    public:
        using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>; ///< a number for each row
        /// How small a fraction of b it leaves, unless it is told.
        static Scalar close() {
            return std::max<Scalar>(Scalar(tolerance), 16 * std::numeric_limits<Scalar>::epsilon());
        }

        /// \param x    the solution; what it holds is not used
        /// \param leave how small a fraction of b it leaves
        /// \return whether it converged
        template <class Matrix> bool solve(const Matrix& A, const Column& b, Column& x, const Scalar& leave = close()) {
            x.setZero(b.size());
            // In units of the largest of b: the square of what dies away is nothing long before it is.
            const Scalar unit = b.size() > 0 ? b.cwiseAbs().maxCoeff() : Scalar(0);
            if (!(unit > Scalar(0))) return unit == Scalar(0);
            residual_ = b / unit;
            const Scalar target = leave * leave * sum(residual_, residual_);
            preconditioner_.compute(A);
            towards_ = preconditioner_.solve(residual_);
            Scalar steep = sum(residual_, towards_);
            const auto most = 2 * b.size() + 50; // in exact arithmetic as many as rows
            for (iterations_ = 0; iterations_ < most; ++iterations_) {
                image_.noalias() = A.transpose() * towards_; // which is A: see block_matrix.hpp
                const Scalar length = steep / sum(towards_, image_);
                x += length * towards_;
                residual_ -= length * image_;
                const Scalar left = sum(residual_, residual_);
                if (left <= target) {
                    x *= unit;
                    return true;
                }
                // NOLINTNEXTLINE(misc-redundant-expression): false for what is no number
                if (!(left - left == Scalar(0))) return false; // infinite, or not a number
                scaled_ = preconditioner_.solve(residual_);
                const Scalar steepness = sum(residual_, scaled_);
                towards_ = scaled_ + (steepness / steep) * towards_;
                steep = steepness;
            }
            x *= unit;
            return false;
        }
        /// How many iterations the last solution took.
        Eigen::Index iterations() const { return iterations_; }

    private:
        /// In four sums, added in one order: what vector units do, and the same in every build.
        static Scalar sum(const Column& a, const Column& b) {
            Scalar part[4] = {};
            const auto whole = a.size() / 4 * 4;
            for (Eigen::Index i = 0; i < whole; i += 4)
                for (int k = 0; k < 4; ++k) part[k] += a[i + k] * b[i + k];
            for (Eigen::Index i = whole; i < a.size(); ++i) part[i - whole] += a[i] * b[i];
            return (part[0] + part[1]) + (part[2] + part[3]);
        }

        Eigen::DiagonalPreconditioner<Scalar> preconditioner_;
        Column residual_, towards_, image_, scaled_;
        Eigen::Index iterations_ = 0;
    };
};

} // namespace ansatz
