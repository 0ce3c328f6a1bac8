// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Cholesky`: the direct solver of implicit steps, Eigen's sparse LDL^T.
// not in the umbrella: Eigen's sparse module takes half a second to compile
///
/// Use it, `ImplicitEulerBy<Cholesky>`, for systems that are small and very stiff, where conjugate gradients need
/// thousands of iterations: its time does not depend on the stiffness. It allocates in every step, and its work
/// grows more than in proportion to the number of bodies.

#include <ansatz/motion/integrators/implicit_system.hpp>

#include <Eigen/SparseCholesky>

#include <limits>

namespace ansatz {

/// Solves A x = b for a symmetric, positive definite A by its factors.
struct Cholesky {
    /// The order of elimination, and with it the last bit, follows from the pattern.
    static constexpr bool pattern_may_grow_old = false;

    /// What it keeps between steps.
    template <class Scalar> class Solver {
    public:
        using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>; ///< a number for each row
        /// How small a fraction of b it leaves, about.
        static Scalar close() { return 1000 * std::numeric_limits<Scalar>::epsilon(); }

        /// The pattern is another: finds a new order of elimination.
        template <class Matrix> void pattern(const Matrix& A) { factors_.analyzePattern(A); }
        /// \return whether A has factors
        template <class Matrix> bool solve(const Matrix& A, const Column& b, Column& x) {
            x.setZero(b.size());
            factors_.factorize(A);
            if (factors_.info() != Eigen::Success) return false;
            x = factors_.solve(b);
            return true;
        }

    private:
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar, Eigen::ColMajor, int>> factors_;
    };
};

} // namespace ansatz
