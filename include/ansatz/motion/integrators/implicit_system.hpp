// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ImplicitSystem`: one step of implicit Euler for all bodies at once, where springs couple them (notes 1.6.2, 3).
// not in the umbrella: only worlds that couple bodies and solve need it, and Eigen's sparse module takes half a second
///
/// Newton's method for the velocities u at the end of the step:
/// \f$ M (u - v) - \Delta t\,f(x + \Delta t\,u, u) = 0 \f$. Each iteration solves
/// \f$ (M - \Delta t\,\partial f/\partial v - \Delta t^2\,\partial f/\partial x)\,\delta = r \f$, which is
/// symmetric, positive definite and sparse. For springs along a line one iteration is the solution; where they turn, a
/// few are needed, and a step that makes the residual larger is halved. The pattern, the vectors and the solver are
/// kept.
///
/// D. Baraff, A. Witkin, SIGGRAPH 1998, solve the same system once a step, without iterating.

#include <ansatz/motion/integrators/block_matrix.hpp>
#include <ansatz/motion/integrators/implicit_euler.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam S            the space
/// \tparam LinearSolver ConjugateGradient or Cholesky
template <class S, class LinearSolver> class ImplicitSystem {
public:
    using Scalar = typename S::Scalar;
    using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>; ///< a number for each row

    /// Advances the bodies of a system by a step of length `dt`.
    /// \param asked its `tolerance` and `most_iterations`: see ImplicitEulerBy
    /// \return whether it converged; if not, the bodies have moved with the best velocities that were found
    template <class System, class Dt> bool solve(System& system, const Dt& dt, const auto& asked) {
        const Scalar h = dt.value();
        system.read(x_, v_, mass_);
        if (x_.size() == 0) return true;
        u_ = v_;
        Scalar left = residual(system, u_, h, r_);
        const Scalar close = close_enough(asked.tolerance);
        // Below the smallest normal number there are too few digits left to come any closer.
        const Scalar enough = std::max(Scalar(close * left), std::numeric_limits<Scalar>::min());
        bool converged = left == Scalar(0), solved = true;
        for (iterations_ = 0; iterations_ < asked.most_iterations && !converged && is_finite(left); ++iterations_) {
            linearise(system, h);
            solved = solve_linear(close) && solved;
            if (!step_.allFinite()) break;
            // A change that the positions cannot hold, or that is nothing beside the velocities, is the end.
            const Scalar eps = std::numeric_limits<Scalar>::epsilon();
            auto negligible = [&](const Scalar& factor) {
                const Scalar change = step_.cwiseAbs().maxCoeff();
                return h * change <= factor * eps * x_.cwiseAbs().maxCoeff() ||
                       change <= factor * eps * u_.cwiseAbs().maxCoeff();
            };
            const bool steady = negligible(Scalar(4)), near = negligible(Scalar(4000));
            const bool rounds = near && left <= rounding_left(h);
            next_ = u_ - step_;
            Scalar next_left = residual(system, next_, h, next_r_);
            for (int half = 0; half < 30 && !rounds && !(next_left <= left); ++half) {
                step_ *= Scalar(0.5);
                next_ = u_ - step_;
                next_left = residual(system, next_, h, next_r_);
            }
            const bool rounding = near && !(next_left < left); // as small as rounding lets it become
            if (!rounding) {
                std::swap(u_, next_);
                std::swap(r_, next_r_);
                left = next_left;
            }
            // As good as the solver can make it: springs along a line are there after one iteration.
            converged = steady || rounding || left <= enough;
        }
        if (u_.allFinite()) v_ = u_;
        x_ += h * v_;
        system.write(x_, v_);
        return converged && solved;
    }
    /// Newton's iterations in the last step.
    int iterations() const { return iterations_; }
    /// The solver, with what it can tell of the last solution.
    const typename LinearSolver::template Solver<Scalar>& solver() const { return solver_; }

private:
    using Solver = typename LinearSolver::template Solver<Scalar>;
    /// What fraction of a residual may be left: as much as is wanted, or the solver's own.
    static Scalar close_enough(double tolerance) {
        return tolerance > 0 ? std::max<Scalar>(Scalar(tolerance), 16 * std::numeric_limits<Scalar>::epsilon())
                             : Solver::close();
    }
    /// One that iterates is told how far; what solves by factors has rounding left, and no choice.
    bool solve_linear(const Scalar& close) {
        if constexpr (requires { solver_.solve(matrix_.matrix(), r_, step_, close); })
            return solver_.solve(matrix_.matrix(), r_, step_, close);
        else return solver_.solve(matrix_.matrix(), r_, step_);
    }
    /// r = M (u - v) - dt f at the end of the step with velocities u.
    /// \return |r|, each row by the square root of its mass: what Newton's method must make small
    template <class System> Scalar residual(System& system, const Column& u, const Scalar& h, Column& r) {
        end_ = x_ + h * u;
        system.write(end_, u);
        system.accelerations(1.0, a_);
        r = mass_.cwiseProduct(u - v_ - h * a_);
        using std::sqrt;
        const Scalar unit = r.cwiseAbs().maxCoeff(); // or the square of what dies away would be nothing
        if (!(unit > Scalar(0))) return unit;
        Scalar sum(0);
        for (Eigen::Index i = 0; i < r.size(); ++i)
            if (mass_[i] > Scalar(0)) sum += (r[i] / unit) * (r[i] / unit) / mass_[i];
        return unit * sqrt(sum);
    }

    /// How much of |r| may come of how the places are rounded, by the matrix as it is. What is larger, and does not
    /// fall, is no rounding but a force that sets in on the way: a rope that becomes taut, of which the matrix knows
    /// nothing yet. So a short step that does not help is halved then, as a long one is.
    Scalar rounding_left(const Scalar& h) const {
        using std::sqrt;
        const Scalar digits = 4 * std::numeric_limits<Scalar>::epsilon() * x_.cwiseAbs().maxCoeff() / h;
        Scalar sum(0);
        for (Eigen::Index i = 0; i < r_.size(); ++i)
            if (mass_[i] > Scalar(0)) {
                const Scalar push = digits * matrix_.matrix().coeff(i, i);
                sum += push * push / mass_[i];
            }
        return sqrt(sum);
    }
    /// M - dt df/dv - dt^2 df/dx at the end of the step; the rows of bodies that do not take part say "no change".
    template <class System> void linearise(System& system, const Scalar& h) {
        if (matrix_.bodies() != system.bodies() || !LinearSolver::pattern_may_grow_old) find_pattern(system);
        if (!fill(system, h)) { // a spring was added
            find_pattern(system);
            fill(system, h);
        }
    }
    template <class System> bool fill(System& system, const Scalar& h) {
        using Block = typename System::Block;
        constexpr int dimension = System::dimension;
        matrix_.set_zero();
        for (Eigen::Index i = 0; i < system.bodies(); ++i) {
            const Scalar m = mass_[i * dimension];
            matrix_.add(i, i, Block(Block::Identity() * (m > Scalar(0) ? m : Scalar(1))));
        }
        bool fits = true;
        system.jacobians(
            1.0,
            [&](Eigen::Index i, const Block& by_x, const Block& by_v) {
                matrix_.add(i, i, Block(-h * by_v - h * h * by_x));
            },
            [&](Eigen::Index i, Eigen::Index j, const Block& by_x, const Block& by_v) {
                fits = matrix_.add(i, j, Block(-h * by_v - h * h * by_x)) && fits;
            });
        return fits;
    }
    template <class System> void find_pattern(System& system) {
        pairs_.clear();
        system.joined([&](Eigen::Index i, Eigen::Index j) { pairs_.emplace_back(int(i), int(j)); });
        if constexpr (LinearSolver::pattern_may_grow_old) matrix_.make_pattern(system.bodies(), pairs_);
        else if (matrix_.bodies() != system.bodies() || pairs_ != known_) {
            known_ = pairs_;
            matrix_.make_pattern(system.bodies(), pairs_);
            solver_.pattern(matrix_.matrix());
        }
    }

    BlockMatrix<Scalar, S::dimension> matrix_;
    Solver solver_;
    std::vector<std::pair<int, int>> pairs_, known_;
    Column x_, v_, mass_;          // at the beginning of the step
    Column u_, r_, next_, next_r_; // the velocities tried, and what is left
    Column step_, end_, a_;
    int iterations_ = 0;
};

} // namespace ansatz
