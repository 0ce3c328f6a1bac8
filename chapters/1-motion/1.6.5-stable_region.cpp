// SPDX-License-Identifier: BSL-1.0
// 1.6.5 The stable region: how long a step may be, for every integrator and every damping

// An oscillation of angular frequency omega, damped by the ratio zeta (1: critically), is bounded; what an integrator
// makes of it is bounded only up to some length of the step. Each of these worlds is one point of a map: an integrator,
// a damping, and the longest step with which 4000 steps do not grow. Nothing connects the
// points, so that they are an ensemble: one run for each, on one core, on all of them, or on many machines
//
//     mpirun -n 5 ./stable_region          (compiled with -DANSATZ_ON_RANKS, Boost.MPI and MPI)
//
// and the same numbers with any executor. Beside each stands what theory says: one step is a matrix, and the motion is
// bounded while the powers of that matrix are.
// Compiled alone: it can be a program of MPI's ranks, with headers and a main of its own.

#include "claims.hpp"
#include "plot.hpp"
#include "problems.hpp"

#include <ansatz/execution/ensemble.hpp>
#include <ansatz/world.hpp>

#ifdef ANSATZ_ON_RANKS
#include <ansatz/execution/on_ranks.hpp>

#include <boost/mpi/environment.hpp>
#endif

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;
using workbook::Claims;

constexpr int integrators = 6;
const char* const names[integrators] = {"explicit Euler", "semi-implicit Euler", "implicit Euler",
                                        "Verlet",         "velocity Verlet",     "Runge-Kutta 4"};
const double longest = 8; // omega dt; what is stable there is taken for stable everywhere

struct Point {
    int integrator;
    double damping;
};

/// Whether 4000 steps of omega dt = q leave an oscillation of 1 m below 100 m.
//! [run]
template <class Integrator> bool bounded(double damping, double q) {
    World world{Integrator{}, problems::Oscillator{1.0 / second}, problems::LinearDamping{2 * damping / second}};
    const auto body = world.add(position(metres(1, 0, 0)));
    for (int i = 0; i < 4000; ++i) {
        world.step(q * second);
        if (!(norm(world.position(body)) < 100.0 * metre)) return false;
    }
    return true;
}
/// The longest step up to which all are bounded, to a thousandth: where it grows, and then by halving. Halving alone
/// would miss that Verlet has an island: with a damping ratio of 0.2 it is unstable from 2.4 on, and stable again
/// behind it.
template <class Integrator> double longest_step(double damping, double apart = 0.05) {
    double stable = 0, unstable = apart;
    while (bounded<Integrator>(damping, unstable)) {
        stable = unstable;
        unstable += apart;
        if (unstable > longest) return longest;
    }
    while (unstable - stable > 1e-3) {
        const double q = (stable + unstable) / 2;
        (bounded<Integrator>(damping, q) ? stable : unstable) = q;
    }
    return stable;
}
double run(const Point& point) {
    switch (point.integrator) {
    case 0: return longest_step<ExplicitEuler>(point.damping);
    case 1: return longest_step<SemiImplicitEuler>(point.damping);
    case 2: return longest_step<ImplicitEuler>(point.damping, 1);
    case 3: return longest_step<Verlet>(point.damping);
    case 4: return longest_step<VelocityVerlet>(point.damping);
    default: return longest_step<RungeKutta4>(point.damping);
    }
}
//! [run]

/// One step as a matrix on (x, v), in units of the oscillation: the acceleration is -x - 2 zeta v, q the step. Verlet's
/// v is the mean velocity of the last step, which it brings to the present before it asks for the acceleration.
Eigen::Matrix2d step_matrix(const Point& point, double q) {
    const double c = 2 * point.damping;
    const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
    Eigen::Matrix2d rate, step;
    rate << 0, 1, -1, -c;
    const Eigen::Matrix2d z = q * rate;
    const Eigen::RowVector2d x(1, 0), v(0, 1), a(-1, -c);
    switch (point.integrator) {
    case 0: return one + z;
    case 1: step << x + q * (v + q * a), v + q * a; break;
    case 2: return (one - z).inverse();
    case 3: {
        const Eigen::RowVector2d now = -x - c * (v + q / 2 * a);
        step << x + q * (v + q * now), v + q * now;
        break;
    }
    case 4: {
        const Eigen::RowVector2d half = v + q / 2 * a, there = x + q * half;
        step << there, half + q / 2 * (-there - c * (v + q * a));
        break;
    }
    default: return one + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24;
    }
    return step;
}
/// The first step whose matrix has powers that grow: it is squared twenty times, which is a million steps.
double theory(const Point& point) {
    for (double q = 1e-3; q < longest; q += 1e-3) {
        Eigen::Matrix2d power = step_matrix(point, q);
        for (int i = 0; i < 20 && power.norm() < 1e6; ++i) power = (power * power).eval();
        if (!(power.norm() < 1e3)) return q;
    }
    return longest;
}

int main([[maybe_unused]] int count, [[maybe_unused]] char** words) {
    std::vector<Point> points;
    for (int integrator = 0; integrator < integrators; ++integrator)
        for (int k = 0; k <= 15; ++k) points.push_back({integrator, 0.1 * k});
#ifdef ANSATZ_ON_RANKS
    boost::mpi::environment environment(count, words);
    OnRanks executor{boost::mpi::communicator()};
    const auto measured = ensemble(run, points, executor, {.progress = ProgressLine{std::cerr}});
    if (!executor.leads()) return 0;
#else
    //! [ensemble]
    const auto measured = ensemble(run, points, OneByOne{});
    //! [ensemble]
#endif

    Claims claim;
    workbook::Plot plot("1.6.5", "How long a step may be");
    plot.x("damping ratio").y("longest stable omega dt").y_range(0., 4.);
    std::cout << "Longest stable omega dt, measured (by theory):\n"
              << "  damping ratio          0.0           0.5           1.0           1.5\n";
    std::vector<double> dampings, limits;
    double worst = 0;
    bool always = true;
    for (int i = 0; i < integrators; ++i) {
        std::vector<double> damping, known;
        std::cout << "  " << std::left << std::setw(20) << names[i] << std::right << std::fixed << std::setprecision(3);
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (points[k].integrator != i) continue;
            const double bound = theory(points[k]);
            const auto number = std::lround(10 * points[k].damping);
            if (number % 5 == 0) {
                if (bound == longest) std::cout << "   any   (any)";
                else std::cout << ' ' << measured[k] << " (" << bound << ')';
            }
            if (i == 2) always = always && measured[k] == longest && bound == longest;
            else worst = std::max(worst, std::abs(measured[k] - bound));
            damping.push_back(points[k].damping);
            known.push_back(bound);
            if (i == 2) continue;
            dampings.push_back(points[k].damping);
            limits.push_back(measured[k]);
        }
        std::cout << '\n';
        if (i != 2) plot.line(std::string(names[i]) + ", theory", damping, known);
    }
    plot.points("measured", dampings, limits).write();
    std::cout << std::defaultfloat;

    claim("every measured limit is that of theory, to 0.05", worst < 0.05);
    claim("implicit Euler is stable at every step and damping", always);
    claim("without damping, explicit Euler is stable at no step", measured[0] < 0.05);
    claim("without damping, the others hold up to 2, Runge-Kutta 4 up to 2 sqrt 2",
          std::abs(measured[16] - 2) < 0.01 && std::abs(measured[64] - 2) < 0.01 &&
              std::abs(measured[80] - 2 * std::sqrt(2)) < 0.02);
    claim("damping lets explicit Euler take longer steps, up to critical damping, and semi-implicit Euler only shorter "
          "ones",
          measured[5] > measured[1] && measured[31] < measured[21] && measured[21] < measured[16]);
    return claim.result();
}
