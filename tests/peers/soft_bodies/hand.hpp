// SPDX-License-Identifier: BSL-1.0
// What somebody writes by hand for this one sheet: XPBD over structures, and implicit Euler with Eigen's matrices.
#pragma once

#include "tests/peers/soft_bodies/sheet.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace peers {

/// XPBD, the constraints one after the other; velocities take each correction as it is made.
class HandXpbd : public SheetOf {
public:
    HandXpbd(const Sheet& sheet, int substeps) : substeps_(substeps) {
        for (std::size_t i = 0; i < sheet.size(); ++i) {
            const auto& x = sheet.places[i];
            bodies_.push_back({{x[0], x[1], x[2]}, {0, 0, 0}, sheet.masses[i] > 0 ? 1 / sheet.masses[i] : 0});
        }
        for (const auto& l : sheet.links) links_.push_back({l.a, l.b, l.rest, sheet.stiffness, sheet.damping});
    }
    void step() override {
        for (int i = 0; i < substeps_; ++i) substep(Sheet::dt / substeps_);
    }
    std::array<double, 3> at(std::size_t i) const override {
        return {bodies_[i].x[0], bodies_[i].x[1], bodies_[i].x[2]};
    }

private:
    struct Body {
        double x[3], v[3], weight;
    };
    struct Link {
        std::uint32_t a, b;
        double rest, stiffness, damping;
    };
    [[gnu::noinline]] void substep(double h) {
        for (Body& body : bodies_) {
            if (body.weight > 0) body.v[1] -= h * Sheet::gravity;
            for (int k = 0; k < 3; ++k) body.x[k] += h * body.v[k];
        }
        const double rate = 1 / h;
        for (const Link& link : links_) {
            Body &a = bodies_[link.a], &b = bodies_[link.b];
            const double x = b.x[0] - a.x[0], y = b.x[1] - a.x[1], z = b.x[2] - a.x[2];
            const double length = std::sqrt(x * x + y * y + z * z);
            if (!(length > 0)) continue;
            const double per_length = 1 / length;
            const double n[3] = {x * per_length, y * per_length, z * per_length};
            const double way = h * (n[0] * (b.v[0] - a.v[0]) + n[1] * (b.v[1] - a.v[1]) + n[2] * (b.v[2] - a.v[2]));
            const double by_value = h * h * link.stiffness, by_rate = h * link.damping;
            const double impulse =
                -(by_value * (length - link.rest) + by_rate * way) / (1 + (by_value + by_rate) * (a.weight + b.weight));
            for (int k = 0; k < 3; ++k) {
                const double to_a = -a.weight * impulse * n[k], to_b = b.weight * impulse * n[k];
                a.x[k] += to_a;
                b.x[k] += to_b;
                a.v[k] += rate * to_a;
                b.v[k] += rate * to_b;
            }
        }
    }
    int substeps_;
    std::vector<Body> bodies_;
    std::vector<Link> links_;
};

/// One linear system of implicit Euler: the triplets of all springs, Eigen's matrix of them, Eigen's conjugate
/// gradients.
class EigenStep : public SheetOf {
public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    EigenStep(const Sheet& sheet, double tolerance) : sheet_(sheet), tolerance_(tolerance) {
        const auto rows = Eigen::Index(3 * sheet.size());
        x.setZero(rows);
        v.setZero(rows);
        for (std::size_t i = 0; i < sheet.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) x[Eigen::Index(3 * i + k)] = sheet.places[i][k];
    }
    /// The system of a step from where it is: M + h C + h^2 K with forces at the positions x + h v.
    void assemble() {
        const double h = Sheet::dt;
        const Eigen::VectorXd end = x + h * v;
        triplets_.clear();
        rhs.setZero(x.size());
        for (const auto& l : sheet_.links) {
            const Eigen::Index a = 3 * Eigen::Index(l.a), b = 3 * Eigen::Index(l.b);
            const bool a_moves = sheet_.masses[l.a] > 0, b_moves = sheet_.masses[l.b] > 0;
            const Eigen::Vector3d to = end.segment<3>(b) - end.segment<3>(a);
            const double length = to.norm(), slack = length - l.rest;
            const Eigen::Vector3d n = to / length;
            const Eigen::Matrix3d along = n * n.transpose();
            const double across = slack > 0 ? sheet_.stiffness * slack / length : 0;
            const Eigen::Matrix3d block = (h * h * sheet_.stiffness + h * sheet_.damping) * along +
                                          h * h * across * (Eigen::Matrix3d::Identity() - along);
            const double speed = n.dot(v.segment<3>(b) - v.segment<3>(a));
            const Eigen::Vector3d push = h * (sheet_.stiffness * slack + sheet_.damping * speed) * n;
            if (a_moves) put(a, a, block), rhs.segment<3>(a) += push;
            if (b_moves) put(b, b, block), rhs.segment<3>(b) -= push;
            if (a_moves && b_moves) put(a, b, -block), put(b, a, -block);
        }
        for (std::size_t i = 0; i < sheet_.size(); ++i) {
            const double m = sheet_.masses[i];
            for (int k = 0; k < 3; ++k) {
                const auto row = int(3 * i) + k;
                triplets_.emplace_back(row, row, m > 0 ? m : 1);
            }
            rhs[Eigen::Index(3 * i + 1)] -= h * m * Sheet::gravity;
        }
        matrix.resize(x.size(), x.size());
        matrix.setFromTriplets(triplets_.begin(), triplets_.end());
    }
    /// Its solution, the change of the velocities.
    const Eigen::VectorXd& solve() {
        solver.setTolerance(tolerance_);
        solver.compute(matrix);
        change_ = solver.solve(rhs);
        return change_;
    }
    void step() override {
        assemble();
        v += solve();
        x += Sheet::dt * v;
    }
    std::array<double, 3> at(std::size_t i) const override {
        return {x[Eigen::Index(3 * i)], x[Eigen::Index(3 * i + 1)], x[Eigen::Index(3 * i + 2)]};
    }

    Eigen::VectorXd x, v, rhs; ///< m, m/s, N s
    Matrix matrix;
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;

private:
    void put(Eigen::Index row, Eigen::Index column, const Eigen::Matrix3d& block) {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) triplets_.emplace_back(int(row) + r, int(column) + c, block(r, c));
    }
    const Sheet& sheet_;
    double tolerance_;
    std::vector<Eigen::Triplet<double>> triplets_;
    Eigen::VectorXd change_;
};

} // namespace peers
