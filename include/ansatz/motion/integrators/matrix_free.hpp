// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `MatrixFree`: implicit steps of cloth at the price that cloth is worth: inexact Newton over the springs themselves.
// not in the umbrella: only worlds that couple bodies and solve need it
///
/// Use it, `ImplicitEulerBy<MatrixFree>`, for cloth and soft bodies of many springs. Three things make it quicker than
/// ImplicitEuler with the same equation: no matrix is put together (pair_matrix.hpp); the blocks of the bodies and
/// groups that move as wholes (group_correction.hpp) precondition the solve, so that the number
/// of iterations grows less with the size of the sheet; and each linear system is solved only as accurately as Newton's
/// method can use: to a tenth while it is far from the solution, closer as it comes near (Eisenstat and Walker's second
/// choice). Left to itself it ends at a hundredth of what the equation was at the beginning of the step; a sheet of 50
/// x 50 that falls 15 cm in ten steps is then an eighth of a millimetre (in the mean square; 1.4 mm at most) from where
/// 1e-4 takes it.
/// `.tolerance` asks for more or less. Take ImplicitEuler where a step shall be exact to rounding,
/// ImplicitEulerBy<Cholesky> where a system is small and very stiff.
///
/// `ImplicitEulerBy<MatrixFree>{.most_iterations = 1}` is the step of Baraff and Witkin: one linear system, solved to
/// the tolerance, and the whole of its solution is taken. The equation is not evaluated again; what counts as unsolved
/// is the linear system. It takes half the time. A tolerance of 0.1 is too rough for it: a sheet that swings gains
/// energy.
///
/// What a step of Newton's method must not do is to go too far: where springs are pressed, their matrices lack what
/// would bend them (springs.hpp). So a step that makes the residual larger and goes past the least energy along its
/// direction, \f$ r(u - p)\cdot p < -\tfrac12\,r(u)\cdot p \f$, is shortened to where a parabola has it.
///
/// S. C. Eisenstat, H. F. Walker, SIAM J. Sci. Comput. 17, 16 (1996). D. Baraff, A. Witkin, SIGGRAPH 1998.

#include <ansatz/motion/integrators/growing_column.hpp>
#include <ansatz/motion/integrators/implicit_euler.hpp>
#include <ansatz/motion/integrators/pair_matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ansatz {

/// Names the solver: conjugate gradients over pairs of bodies.
struct MatrixFree {
    static constexpr double tolerance = 1e-2; ///< what fraction of the residual may be left, unless it is told

    /// Solves A x = b for a PairMatrix A, symmetric and positive definite.
    template <class Scalar> class Solver {
    public:
        using Column = GrowingColumn<Scalar>; ///< a number for each row; so may be any of Eigen's vectors
        /// How small a fraction of b it leaves, unless it is told.
        static Scalar close() { return Scalar(tolerance); }

        /// \param weight  of each row in the norm in which b and what is left of it are measured, the square root of
        ///                the sum of weight * value^2; 1 / mass makes it Newton's
        /// \param x       the solution; what it holds is not used. Where it did not converge, the best so far.
        /// \param leave   how small a fraction of b it leaves
        /// \return whether it converged
        template <class Matrix, class X>
        bool solve(const Matrix& A, const auto& b, const auto& weight, X& x, const Scalar& leave = close()) {
            iterations_ = 0;
            x.setZero(b.size());
            // In units of the largest of b: the square of what dies away is nothing long before it is.
            const Scalar unit = b.size() > 0 ? b.cwiseAbs().maxCoeff() : Scalar(0);
            if (!(unit > Scalar(0))) return unit == Scalar(0);
            residual_ = b / unit;
            const Scalar target = leave * leave * sum(residual_, residual_, weight);
            A.precondition(residual_, towards_);
            Scalar steep = sum(residual_, towards_);
            const auto most = 2 * b.size() + 50; // in exact arithmetic as many as rows
            bool converged = false;
            while (iterations_ < most && !converged) {
                ++iterations_;
                A.multiply(towards_, image_);
                const Scalar curved = sum(towards_, image_);
                if (!(curved > Scalar(0))) break; // not definite, or not a number: what was found so far goes downhill
                const Scalar length = steep / curved;
                x += length * towards_;
                residual_ -= length * image_;
                converged = sum(residual_, residual_, weight) <= target;
                A.precondition(residual_, scaled_);
                const Scalar steepness = sum(residual_, scaled_);
                towards_ = scaled_ + (steepness / steep) * towards_;
                steep = steepness;
            }
            x *= unit;
            return converged;
        }
        /// Makes room for so many rows.
        void reserve(std::size_t rows) {
            for (Column* column : {&residual_, &towards_, &image_, &scaled_}) column->reserve(rows);
        }
        /// How many iterations the last solution took.
        Eigen::Index iterations() const { return iterations_; }

        /// In four sums, added in one order: what vector units do, and the same in every build.
        static Scalar sum(const auto& a, const auto& b) {
            return detail::sum_in_four<Scalar>(a.size(), [&](Eigen::Index i) { return a[i] * b[i]; });
        }
        /// The same with weights.
        static Scalar sum(const auto& a, const auto& b, const auto& weight) {
            return detail::sum_in_four<Scalar>(a.size(), [&](Eigen::Index i) { return a[i] * b[i] * weight[i]; });
        }

    private:
        Column residual_, towards_, image_, scaled_;
        Eigen::Index iterations_ = 0;
    };
};

/// One step of implicit Euler for all bodies at once: inexact Newton.
/// \tparam S the space
template <class S> class ImplicitSystem<S, MatrixFree> {
public:
    using Scalar = typename S::Scalar;
    using Solver = MatrixFree::Solver<Scalar>; ///< of the linear systems
    using Column = GrowingColumn<Scalar>;      ///< a number for each row

    /// Advances the bodies of a system by a step of length `dt`.
    /// \param asked its `tolerance` and `most_iterations`: see ImplicitEulerBy
    /// \return whether it converged; if not, the bodies have moved with the best velocities that were found
    template <class System, class Dt> bool solve(System& system, const Dt& dt, const auto& asked) {
        const Scalar h = dt.value();
        system.read(x_, v_, mass_);
        iterations_ = 0;
        products_ = 0;
        if (x_.size() == 0) return true;
        reserve(system);
        weight_ = mass_.unaryExpr([](const Scalar& m) { return m > Scalar(0) ? Scalar(1 / m) : Scalar(0); });
        u_ = v_;
        const Scalar close = asked.tolerance > 0
                                 ? std::max(Scalar(asked.tolerance), 16 * std::numeric_limits<Scalar>::epsilon())
                                 : Solver::close();
        const bool solved = asked.most_iterations == 1 ? solve_once(system, h, close)
                                                       : iterate(system, h, close, asked.most_iterations);
        if (u_.allFinite()) v_ = u_;
        x_ += h * v_;
        system.write(x_, v_);
        return solved;
    }
    /// Makes room for so many bodies: before a step that may divide some, so that those after it allocate nothing.
    void make_room_for_bodies(std::size_t bodies) {
        const auto rows = bodies * std::size_t(S::dimension);
        for (Column* column : {&x_, &v_, &mass_, &weight_, &u_, &r_, &next_, &next_r_, &step_, &end_, &a_})
            column->reserve(rows);
        solver_.reserve(rows);
        matrix_.reserve_bodies(bodies);
    }
    /// Newton's iterations in the last step.
    int iterations() const { return iterations_; }
    /// How often the matrix was multiplied in the last step.
    Eigen::Index products() const { return products_; }

private:
    /// What is left of a linear system is of no use beside what its linearisation left out.
    static constexpr Scalar roughest() { return Scalar(0.1); }

    /// Room for all pairs, and the groups of bodies that are coupled and move.
    template <class System> void reserve(const System& system) {
        constexpr auto dimension = Eigen::Index(S::dimension);
        std::size_t pairs = 0;
        matrix_.group(system.bodies(), [&](const auto& f) {
            system.joined([&](Eigen::Index a, Eigen::Index b) {
                ++pairs;
                if (mass_[dimension * a] > Scalar(0) && mass_[dimension * b] > Scalar(0))
                    f(std::size_t(a), std::size_t(b));
            });
        });
        matrix_.reserve(pairs);
    }
    /// One linear system, and its solution as it is.
    template <class System> bool solve_once(System& system, const Scalar& h, const Scalar& close) {
        const Scalar left = residual(system, u_, h, r_);
        if (left == Scalar(0)) return true;
        iterations_ = 1;
        linearise(system, h);
        const bool solved = is_finite(left) && linear(close);
        if (step_.allFinite()) u_ -= step_;
        return solved && step_.allFinite();
    }
    template <class System> bool iterate(System& system, const Scalar& h, const Scalar& close, int most) {
        Scalar left = residual(system, u_, h, r_);
        // Below the smallest normal number there are too few digits left to come any closer.
        const Scalar enough = std::max(Scalar(close * left), std::numeric_limits<Scalar>::min());
        Scalar leave = std::max(close, roughest());
        bool converged = left == Scalar(0);
        for (; iterations_ < most && !converged && is_finite(left); ++iterations_) {
            linearise(system, h);
            linear(leave);
            if (!step_.allFinite()) break;
            const bool steady = negligible(h, Scalar(4)), near = negligible(h, Scalar(4000));
            bool downhill = false;
            const Scalar next_left = go(system, h, left, near && left <= rounding_left(h), downhill);
            // As small as rounding lets it become.
            const bool rounding = near && !downhill && !(next_left < left);
            const Scalar before = left;
            if (!rounding) {
                u_.swap(next_);
                r_.swap(next_r_);
                left = next_left;
            }
            converged = steady || rounding || left <= enough;
            leave = next_accuracy(leave, before, left, enough);
        }
        return converged;
    }
    /// Eisenstat and Walker's second choice, and no more than the end of Newton's method needs.
    static Scalar next_accuracy(const Scalar& leave, const Scalar& before, const Scalar& left, const Scalar& enough) {
        const Scalar fall = left / before;
        Scalar next = Scalar(0.9) * fall * fall;
        const Scalar held = Scalar(0.9) * leave * leave; // no sudden jump, while that is still large
        if (held > Scalar(0.1)) next = std::max(next, held);
        return std::min(roughest(), std::max(next, Scalar(enough / (2 * left))));
    }
    bool linear(const Scalar& leave) {
        const bool solved = solver_.solve(matrix_, r_, weight_, step_, leave);
        products_ += solver_.iterations();
        return solved;
    }
    /// A change that the positions cannot hold, or that is nothing beside the velocities.
    bool negligible(const Scalar& h, const Scalar& factor) const {
        const Scalar eps = std::numeric_limits<Scalar>::epsilon(), change = step_.cwiseAbs().maxCoeff();
        return h * change <= factor * eps * x_.cwiseAbs().maxCoeff() ||
               change <= factor * eps * u_.cwiseAbs().maxCoeff();
    }
    /// How much of what is left may come of how the places are rounded: as in implicit_system.hpp.
    Scalar rounding_left(const Scalar& h) const {
        using std::sqrt;
        const Scalar digits = 4 * std::numeric_limits<Scalar>::epsilon() * x_.cwiseAbs().maxCoeff() / h;
        Scalar sum(0);
        for (Eigen::Index i = 0; i < r_.size(); ++i) {
            const Scalar push = digits * matrix_.diagonal(i);
            sum += push * push * weight_[i];
        }
        return sqrt(sum);
    }
    /// Takes the step, or the part of it behind which the energy would rise.
    /// \param rounds what is left may be rounding: then all of it is taken
    /// \param downhill becomes true where the energy falls, whatever is left
    /// \return what is left
    template <class System>
    Scalar go(System& system, const Scalar& h, const Scalar& left, bool rounds, bool& downhill) {
        next_ = u_ - step_;
        Scalar next_left = residual(system, next_, h, next_r_);
        const Scalar fall = Solver::sum(r_, step_);
        for (int i = 0; i < 30 && !rounds && !(next_left <= left); ++i) {
            const Scalar ahead = Solver::sum(next_r_, step_); // both along the step as it is now
            const Scalar steep = i == 0 ? fall : Solver::sum(r_, step_);
            downhill = ahead >= Scalar(-0.5) * steep;
            if (downhill) break;
            const Scalar part = is_finite(ahead) ? Scalar(steep / (steep - ahead)) : Scalar(0.1);
            step_ *= std::min(Scalar(0.9), std::max(Scalar(0.1), part));
            next_ = u_ - step_;
            next_left = residual(system, next_, h, next_r_);
        }
        return next_left;
    }
    /// r = M (u - v) - dt f at the end of the step with velocities u.
    /// \return |r|, each row by the square root of its mass: what Newton's method must make small
    template <class System> Scalar residual(System& system, const Column& u, const Scalar& h, Column& r) {
        using std::sqrt;
        end_ = x_ + h * u;
        system.write(end_, u);
        system.accelerations(1.0, a_);
        r = mass_.cwiseProduct(u - v_ - h * a_);
        const Scalar unit = r.cwiseAbs().maxCoeff(); // or the square of what dies away would be nothing
        if (!(unit > Scalar(0))) return unit;
        end_ = r / unit;
        return unit * sqrt(Solver::sum(end_, end_, weight_));
    }
    /// M - dt df/dv - dt^2 df/dx at the end of the step; the rows of bodies that do not take part say "no change".
    template <class System> void linearise(System& system, const Scalar& h) {
        using Block = typename System::Block;
        constexpr int dimension = System::dimension;
        matrix_.clear(system.bodies());
        system.pair_jacobians(
            1.0,
            [&](Eigen::Index i, const Block& by_x, const Block& by_v) {
                matrix_.add(i, Block(-h * by_v - h * h * by_x));
            },
            [&](Eigen::Index i, Eigen::Index j, const Block& by_x, const Block& by_v) {
                matrix_.add_both(i, j, Block(-h * by_v - h * h * by_x));
            });
        for (Eigen::Index i = 0; i < system.bodies(); ++i) {
            const Scalar m = mass_[i * dimension];
            matrix_.add(i, Block(Block::Identity() * (m > Scalar(0) ? m : Scalar(1))));
        }
        matrix_.finish();
    }

    PairMatrix<Scalar, S::dimension> matrix_;
    Solver solver_;
    Column x_, v_, mass_, weight_; // at the beginning of the step
    Column u_, r_, next_, next_r_; // the velocities tried, and what is left
    Column step_, end_, a_;
    Eigen::Index products_ = 0;
    int iterations_ = 0;
};

} // namespace ansatz
